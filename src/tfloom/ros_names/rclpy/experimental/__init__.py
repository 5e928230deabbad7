"""The experimental part of rclpy, whose API may change."""

from typing import TYPE_CHECKING

from tfloom.node.executing.events_executor import EventsExecutor as EventsExecutor

if TYPE_CHECKING:
    from rclpy.experimental import events_executor as events_executor
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rclpy.experimental")
