"""Wait, then visit actions."""

from typing import TYPE_CHECKING

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.timer_action import TimerAction as TimerAction
from tfloom.launch.event_handler import EventHandler as EventHandler
from tfloom.launch.events.shutdown import Shutdown as Shutdown
from tfloom.launch.events.timer_event import TimerEvent as TimerEvent
from tfloom.launch.frontend.entity import Entity as Entity
from tfloom.launch.frontend.expose import expose_action as expose_action
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.some_substitutions_type import (
    SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple,
)

if TYPE_CHECKING:
    from tfloom.launch.actions.opaque_function import OpaqueFunction as OpaqueFunction
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.utilities.class_tools import is_a_subclass as is_a_subclass
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        OpaqueFunction="tfloom.launch.actions.opaque_function",
        Parser="tfloom.launch.frontend.parser",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
        is_a_subclass="tfloom.launch.utilities.class_tools",
    )
