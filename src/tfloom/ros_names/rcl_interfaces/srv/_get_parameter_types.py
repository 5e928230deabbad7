"""The classes of rcl_interfaces/srv/GetParameterTypes, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.srv import GetParameterTypes as GetParameterTypes
from tfloom.interfaces.rcl_interfaces.srv import GetParameterTypes_Event as GetParameterTypes_Event
from tfloom.interfaces.rcl_interfaces.srv import GetParameterTypes_Request as GetParameterTypes_Request
from tfloom.interfaces.rcl_interfaces.srv import GetParameterTypes_Response as GetParameterTypes_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetParameterTypes
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetParameterTypes_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetParameterTypes_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetParameterTypes_Response

__all__ = ["Metaclass_GetParameterTypes", "Metaclass_GetParameterTypes_Event", "Metaclass_GetParameterTypes_Request", "Metaclass_GetParameterTypes_Response", "GetParameterTypes", "GetParameterTypes_Event", "GetParameterTypes_Request", "GetParameterTypes_Response"]
