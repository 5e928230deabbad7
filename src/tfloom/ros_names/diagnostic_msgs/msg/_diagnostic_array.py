"""The classes of diagnostic_msgs/msg/DiagnosticArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.diagnostic_msgs.msg import DiagnosticArray as DiagnosticArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DiagnosticArray

__all__ = ["Metaclass_DiagnosticArray", "DiagnosticArray"]
