"""Internal modules of rclpy that programs import."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rclpy.impl import implementation_singleton as implementation_singleton
    from rclpy.impl import logging_severity as logging_severity
    from rclpy.impl import rcutils_logger as rcutils_logger
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        implementation_singleton="rclpy.impl",
        logging_severity="rclpy.impl",
        rcutils_logger="rclpy.impl",
    )
