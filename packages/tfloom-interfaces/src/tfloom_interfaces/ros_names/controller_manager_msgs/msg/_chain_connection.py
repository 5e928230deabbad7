"""The classes of controller_manager_msgs/msg/ChainConnection, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.msg import ChainConnection as ChainConnection
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ChainConnection

__all__ = ["Metaclass_ChainConnection", "ChainConnection"]
