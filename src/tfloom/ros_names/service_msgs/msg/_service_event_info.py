"""The classes of service_msgs/msg/ServiceEventInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.service_msgs.msg import ServiceEventInfo as ServiceEventInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ServiceEventInfo

__all__ = ["Metaclass_ServiceEventInfo", "ServiceEventInfo"]
