"""What programs import of the compiled half of rclpy."""

from tfloom.node.exceptions import InvalidHandle, RCLError, RCLInvalidROSArgsError, UnknownROSArgsError

__all__ = ["InvalidHandle", "RCLError", "RCLInvalidROSArgsError", "UnknownROSArgsError"]
