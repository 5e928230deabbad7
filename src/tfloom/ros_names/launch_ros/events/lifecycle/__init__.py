"""Events of lifecycle nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "ChangeState",
    "StateTransition",
    "matches_node_name",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_ros.events.lifecycle import change_state as change_state
    from launch_ros.events.lifecycle import lifecycle_node_matchers as lifecycle_node_matchers
    from launch_ros.events.lifecycle import state_transition as state_transition
    from tfloom.launch.ros.events.lifecycle.change_state import ChangeState as ChangeState
    from tfloom.launch.ros.events.lifecycle.lifecycle_node_matchers import matches_node_name as matches_node_name
    from tfloom.launch.ros.events.lifecycle.state_transition import StateTransition as StateTransition
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ChangeState="tfloom.launch.ros.events.lifecycle.change_state",
        StateTransition="tfloom.launch.ros.events.lifecycle.state_transition",
        change_state="launch_ros.events.lifecycle",
        lifecycle_node_matchers="launch_ros.events.lifecycle",
        matches_node_name="tfloom.launch.ros.events.lifecycle.lifecycle_node_matchers",
        state_transition="launch_ros.events.lifecycle",
    )
