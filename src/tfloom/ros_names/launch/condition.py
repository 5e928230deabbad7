"""The base class of conditions."""

from tfloom.launch.condition import Condition as Condition
from tfloom.launch.launch_context import LaunchContext as LaunchContext
