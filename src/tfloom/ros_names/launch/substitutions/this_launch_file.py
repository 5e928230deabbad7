"""The path of the launch file that is being launched."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.this_launch_file import ThisLaunchFile as ThisLaunchFile
