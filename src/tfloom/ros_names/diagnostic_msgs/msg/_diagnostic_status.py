"""The classes of diagnostic_msgs/msg/DiagnosticStatus, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.diagnostic_msgs.msg import DiagnosticStatus as DiagnosticStatus
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DiagnosticStatus

__all__ = ["Metaclass_DiagnosticStatus", "DiagnosticStatus"]
