"""The experimental part of rclpy, whose API may change."""

from tfloom.node.executing.events_executor import EventsExecutor

__all__ = ["EventsExecutor"]
