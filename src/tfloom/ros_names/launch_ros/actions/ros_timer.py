"""The action that waits by ROS's time, then executes others."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.actions.timer_action import TimerAction as TimerAction
    from tfloom.launch.events.timer_event import TimerEvent as TimerEvent
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
    from tfloom.launch.ros.actions.ros_timer import ROSTimer as ROSTimer
    from tfloom.launch.ros.ros_adapters import get_ros_node as get_ros_node
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.some_substitutions_type import (
        SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple,
    )
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Entity="tfloom.launch.frontend.entity",
        LaunchContext="tfloom.launch.launch_context",
        LaunchDescriptionEntity="tfloom.launch.launch_description_entity",
        Parser="tfloom.launch.frontend.parser",
        ROSTimer="tfloom.launch.ros.actions.ros_timer",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        SomeSubstitutionsType_types_tuple="tfloom.launch.some_substitutions_type",
        TimerAction="tfloom.launch.actions.timer_action",
        TimerEvent="tfloom.launch.events.timer_event",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
        expose_action="tfloom.launch.frontend.expose",
        get_ros_node="tfloom.launch.ros.ros_adapters",
    )
