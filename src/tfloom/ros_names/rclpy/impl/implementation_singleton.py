"""The name under which programs import rclpy's compiled module."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.implementation_singleton import rclpy_implementation as rclpy_implementation
