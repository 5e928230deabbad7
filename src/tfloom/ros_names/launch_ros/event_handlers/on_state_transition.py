"""The handler of transitions of lifecycle nodes."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.event import Event as Event
    from tfloom.launch.event_handler import EventHandler as EventHandler
    from tfloom.launch.ros.actions.lifecycle_node import LifecycleNode as LifecycleNode
    from tfloom.launch.ros.event_handlers.on_state_transition import OnStateTransition as OnStateTransition
    from tfloom.launch.ros.events.lifecycle.state_transition import StateTransition as StateTransition
    from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Event="tfloom.launch.event",
        EventHandler="tfloom.launch.event_handler",
        LifecycleNode="tfloom.launch.ros.actions.lifecycle_node",
        OnStateTransition="tfloom.launch.ros.event_handlers.on_state_transition",
        SomeEntitiesType="tfloom.launch.some_entities_type",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        StateTransition="tfloom.launch.ros.events.lifecycle.state_transition",
    )
