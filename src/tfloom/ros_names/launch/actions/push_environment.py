"""Begin a scope of environment variables."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.push_environment import PushEnvironment as PushEnvironment
from tfloom.launch.launch_context import LaunchContext as LaunchContext
