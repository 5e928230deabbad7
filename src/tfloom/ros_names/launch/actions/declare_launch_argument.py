"""Declare an argument of a launch description."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.declare_launch_argument import DeclareLaunchArgument as DeclareLaunchArgument
