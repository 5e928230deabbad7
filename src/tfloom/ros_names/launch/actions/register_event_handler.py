"""Register an event handler."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.register_event_handler import RegisterEventHandler as RegisterEventHandler
from tfloom.launch.event_handler import BaseEventHandler as BaseEventHandler
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.utilities.normalize_to_list_of_entities import (
    normalize_to_list_of_entities as normalize_to_list_of_entities,
)
