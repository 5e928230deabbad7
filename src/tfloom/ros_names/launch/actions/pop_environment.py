"""End a scope of environment variables."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.pop_environment import PopEnvironment as PopEnvironment
from tfloom.launch.launch_context import LaunchContext as LaunchContext
