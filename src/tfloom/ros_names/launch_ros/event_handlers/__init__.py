"""Handlers of the events of nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "OnStateTransition",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_ros.event_handlers import on_state_transition as on_state_transition
    from tfloom.launch.ros.event_handlers.on_state_transition import OnStateTransition as OnStateTransition
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        OnStateTransition="tfloom.launch.ros.event_handlers.on_state_transition",
        on_state_transition="launch_ros.event_handlers",
    )
