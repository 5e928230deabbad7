"""What may yet change in rclpy."""

from __future__ import annotations

from tfloom.node.experimental.events_executor import EventsExecutor

__all__ = ["EventsExecutor"]
