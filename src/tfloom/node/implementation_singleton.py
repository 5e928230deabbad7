"""The name under which programs import rclpy's compiled module."""

from __future__ import annotations

from tfloom.node import implementation as rclpy_implementation

__all__ = ["rclpy_implementation"]
