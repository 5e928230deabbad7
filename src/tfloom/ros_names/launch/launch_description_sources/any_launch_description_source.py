"""Launch descriptions in files of any language."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_description_sources.any_launch_description_source import AnyLaunchDescriptionSource as AnyLaunchDescriptionSource
