"""The action that takes lifecycle nodes through several transitions."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.interfaces.lifecycle_msgs.msg import Transition as Transition
    from tfloom.launch.action import Action as Action
    from tfloom.launch.actions.emit_event import EmitEvent as EmitEvent
    from tfloom.launch.actions.register_event_handler import RegisterEventHandler as RegisterEventHandler
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.actions.lifecycle_transition import LifecycleTransition as LifecycleTransition
    from tfloom.launch.ros.actions.lifecycle_transition import match_node_name_goal as match_node_name_goal
    from tfloom.launch.ros.actions.lifecycle_transition import (
        match_node_name_start_goal as match_node_name_start_goal,
    )
    from tfloom.launch.ros.event_handlers.on_state_transition import OnStateTransition as OnStateTransition
    from tfloom.launch.ros.events.lifecycle.change_state import ChangeState as ChangeState
    from tfloom.launch.ros.events.lifecycle.state_transition import StateTransition as StateTransition
    from tfloom.launch.ros.events.matchers import matches_node_name as matches_node_name
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        ChangeState="tfloom.launch.ros.events.lifecycle.change_state",
        EmitEvent="tfloom.launch.actions.emit_event",
        LaunchContext="tfloom.launch.launch_context",
        LifecycleTransition="tfloom.launch.ros.actions.lifecycle_transition",
        OnStateTransition="tfloom.launch.ros.event_handlers.on_state_transition",
        RegisterEventHandler="tfloom.launch.actions.register_event_handler",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        StateTransition="tfloom.launch.ros.events.lifecycle.state_transition",
        Transition="tfloom.interfaces.lifecycle_msgs.msg",
        match_node_name_goal="tfloom.launch.ros.actions.lifecycle_transition",
        match_node_name_start_goal="tfloom.launch.ros.actions.lifecycle_transition",
        matches_node_name="tfloom.launch.ros.events.matchers",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
    )
