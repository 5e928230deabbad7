"""The error of a launch file that cannot be loaded."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.invalid_launch_file_error import InvalidLaunchFileError as InvalidLaunchFileError
