"""The classes of rcl_interfaces/srv/SetLoggerLevels, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.srv import SetLoggerLevels as SetLoggerLevels
from tfloom.interfaces.rcl_interfaces.srv import SetLoggerLevels_Event as SetLoggerLevels_Event
from tfloom.interfaces.rcl_interfaces.srv import SetLoggerLevels_Request as SetLoggerLevels_Request
from tfloom.interfaces.rcl_interfaces.srv import SetLoggerLevels_Response as SetLoggerLevels_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetLoggerLevels
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetLoggerLevels_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetLoggerLevels_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetLoggerLevels_Response

__all__ = ["Metaclass_SetLoggerLevels", "Metaclass_SetLoggerLevels_Event", "Metaclass_SetLoggerLevels_Request", "Metaclass_SetLoggerLevels_Response", "SetLoggerLevels", "SetLoggerLevels_Event", "SetLoggerLevels_Request", "SetLoggerLevels_Response"]
