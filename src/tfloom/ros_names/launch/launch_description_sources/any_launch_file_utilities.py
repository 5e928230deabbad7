"""The loading of launch files in any language."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_description_sources.any_launch_file_utilities import get_launch_description_from_any_launch_file as get_launch_description_from_any_launch_file
