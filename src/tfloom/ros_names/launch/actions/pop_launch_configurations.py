"""End a scope of launch configurations."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.pop_launch_configurations import PopLaunchConfigurations as PopLaunchConfigurations
from tfloom.launch.launch_context import LaunchContext as LaunchContext
