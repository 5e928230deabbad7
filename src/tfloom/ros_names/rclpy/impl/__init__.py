"""Internal modules of rclpy that programs import."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rclpy.impl import implementation_singleton as implementation_singleton
    from rclpy.impl import logging_severity as logging_severity
    from rclpy.impl import rcutils_logger as rcutils_logger
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rclpy.impl")
