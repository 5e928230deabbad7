"""The classes of control_msgs/msg/Float64Values, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import Float64Values as Float64Values
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Float64Values

__all__ = ["Metaclass_Float64Values", "Float64Values"]
