"""The experimental part of rclpy, whose API may change."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "EventsExecutor",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rclpy.experimental import events_executor as events_executor
    from tfloom.node.executing.events_executor import EventsExecutor as EventsExecutor
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        EventsExecutor="tfloom.node.executing.events_executor",
        events_executor="rclpy.experimental",
    )
