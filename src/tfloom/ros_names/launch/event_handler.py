"""The base classes of event handlers."""

from tfloom.launch.event import Event as Event
from tfloom.launch.event_handler import BaseEventHandler as BaseEventHandler
from tfloom.launch.event_handler import EventHandler as EventHandler
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
