"""Handler of the launch's end."""

from typing import TYPE_CHECKING

from tfloom.launch.event import Event as Event
from tfloom.launch.event_handler import BaseEventHandler as BaseEventHandler
from tfloom.launch.event_handlers.on_shutdown import OnShutdown as OnShutdown
from tfloom.launch.events.shutdown import Shutdown as Shutdown
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType

if TYPE_CHECKING:
    from tfloom.launch.utilities.class_tools import is_a_subclass as is_a_subclass
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        is_a_subclass="tfloom.launch.utilities.class_tools",
    )
