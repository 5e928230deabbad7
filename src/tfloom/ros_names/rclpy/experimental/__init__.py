"""What may yet change in rclpy."""

from tfloom.node.executing.events_executor import EventsExecutor

__all__ = ["EventsExecutor"]
