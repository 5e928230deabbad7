"""The base class of the handlers of events that belong to an action."""

from tfloom.launch.event import Event as Event
from tfloom.launch.event_handler import BaseEventHandler as BaseEventHandler
from tfloom.launch.event_handlers.on_action_event_base import OnActionEventBase as OnActionEventBase
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
