"""The classes of rosbag2_interfaces/srv/SetRate, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import SetRate as SetRate
from tfloom.interfaces.rosbag2_interfaces.srv import SetRate_Event as SetRate_Event
from tfloom.interfaces.rosbag2_interfaces.srv import SetRate_Request as SetRate_Request
from tfloom.interfaces.rosbag2_interfaces.srv import SetRate_Response as SetRate_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetRate
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetRate_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetRate_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetRate_Response

__all__ = ["Metaclass_SetRate", "Metaclass_SetRate_Event", "Metaclass_SetRate_Request", "Metaclass_SetRate_Response", "SetRate", "SetRate_Event", "SetRate_Request", "SetRate_Response"]
