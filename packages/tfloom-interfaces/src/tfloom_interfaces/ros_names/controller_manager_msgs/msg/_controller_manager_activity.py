"""The classes of controller_manager_msgs/msg/ControllerManagerActivity, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.msg import ControllerManagerActivity as ControllerManagerActivity
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ControllerManagerActivity

__all__ = ["Metaclass_ControllerManagerActivity", "ControllerManagerActivity"]
