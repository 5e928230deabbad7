"""The classes of rcl_interfaces/srv/GetLoggerLevels, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.srv import GetLoggerLevels as GetLoggerLevels
from tfloom.interfaces.rcl_interfaces.srv import GetLoggerLevels_Event as GetLoggerLevels_Event
from tfloom.interfaces.rcl_interfaces.srv import GetLoggerLevels_Request as GetLoggerLevels_Request
from tfloom.interfaces.rcl_interfaces.srv import GetLoggerLevels_Response as GetLoggerLevels_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetLoggerLevels
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetLoggerLevels_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetLoggerLevels_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetLoggerLevels_Response

__all__ = ["Metaclass_GetLoggerLevels", "Metaclass_GetLoggerLevels_Event", "Metaclass_GetLoggerLevels_Request", "Metaclass_GetLoggerLevels_Response", "GetLoggerLevels", "GetLoggerLevels_Event", "GetLoggerLevels_Request", "GetLoggerLevels_Response"]
