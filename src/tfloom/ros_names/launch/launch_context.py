"""The state of a launch: its events and handlers, variables, launch configurations and environment."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_context import LaunchContext as LaunchContext
