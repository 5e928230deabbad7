"""Begin a scope of launch configurations."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.push_launch_configurations import (
    PushLaunchConfigurations as PushLaunchConfigurations,
)
from tfloom.launch.launch_context import LaunchContext as LaunchContext
