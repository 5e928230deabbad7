"""The classes of control_msgs/msg/AdmittanceControllerState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import AdmittanceControllerState as AdmittanceControllerState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AdmittanceControllerState

__all__ = ["Metaclass_AdmittanceControllerState", "AdmittanceControllerState"]
