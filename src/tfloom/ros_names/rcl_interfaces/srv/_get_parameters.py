"""The classes of rcl_interfaces/srv/GetParameters, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.srv import GetParameters as GetParameters
from tfloom.interfaces.rcl_interfaces.srv import GetParameters_Event as GetParameters_Event
from tfloom.interfaces.rcl_interfaces.srv import GetParameters_Request as GetParameters_Request
from tfloom.interfaces.rcl_interfaces.srv import GetParameters_Response as GetParameters_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetParameters
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetParameters_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetParameters_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetParameters_Response

__all__ = ["Metaclass_GetParameters", "Metaclass_GetParameters_Event", "Metaclass_GetParameters_Request", "Metaclass_GetParameters_Response", "GetParameters", "GetParameters_Event", "GetParameters_Request", "GetParameters_Response"]
