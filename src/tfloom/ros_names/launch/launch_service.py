"""The engine: it visits descriptions, and handles events in order until nothing is left to do."""

from typing import TYPE_CHECKING

from tfloom.launch.event import Event as Event
from tfloom.launch.event_handlers.on_include_launch_description import (
    OnIncludeLaunchDescription as OnIncludeLaunchDescription,
)
from tfloom.launch.event_handlers.on_shutdown import OnShutdown as OnShutdown
from tfloom.launch.events.shutdown import Shutdown as Shutdown
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description import LaunchDescription as LaunchDescription
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.launch_service import LaunchService as LaunchService
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from tfloom.launch.utilities.signal_management import AsyncSafeSignalManager as AsyncSafeSignalManager
from tfloom.launch.utilities.visit_all_entities_and_collect_futures import (
    visit_all_entities_and_collect_futures as visit_all_entities_and_collect_futures,
)

if TYPE_CHECKING:
    from tfloom.launch.events.include_launch_description import (
        IncludeLaunchDescription as IncludeLaunchDescription,
    )
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        IncludeLaunchDescription="tfloom.launch.events.include_launch_description",
    )
