"""The classes of rosbag2_interfaces/srv/GetRate, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import GetRate as GetRate
from tfloom.interfaces.rosbag2_interfaces.srv import GetRate_Event as GetRate_Event
from tfloom.interfaces.rosbag2_interfaces.srv import GetRate_Request as GetRate_Request
from tfloom.interfaces.rosbag2_interfaces.srv import GetRate_Response as GetRate_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetRate
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetRate_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetRate_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetRate_Response

__all__ = ["Metaclass_GetRate", "Metaclass_GetRate_Event", "Metaclass_GetRate_Request", "Metaclass_GetRate_Response", "GetRate", "GetRate_Event", "GetRate_Request", "GetRate_Response"]
