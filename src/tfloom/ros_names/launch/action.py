"""The base class of actions."""

from tfloom.launch.action import Action as Action
from tfloom.launch.condition import Condition as Condition
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
