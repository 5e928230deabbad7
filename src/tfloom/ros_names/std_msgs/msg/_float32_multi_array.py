"""The classes of std_msgs/msg/Float32MultiArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Float32MultiArray as Float32MultiArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Float32MultiArray

__all__ = ["Metaclass_Float32MultiArray", "Float32MultiArray"]
