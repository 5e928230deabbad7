"""Launch descriptions in Python files."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_description_sources.python_launch_description_source import PythonLaunchDescriptionSource as PythonLaunchDescriptionSource
