"""The classes of type_description_interfaces/srv/GetTypeDescription, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.type_description_interfaces.srv import GetTypeDescription as GetTypeDescription
from tfloom.interfaces.type_description_interfaces.srv import GetTypeDescription_Event as GetTypeDescription_Event
from tfloom.interfaces.type_description_interfaces.srv import GetTypeDescription_Request as GetTypeDescription_Request
from tfloom.interfaces.type_description_interfaces.srv import GetTypeDescription_Response as GetTypeDescription_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetTypeDescription
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetTypeDescription_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetTypeDescription_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetTypeDescription_Response

__all__ = ["Metaclass_GetTypeDescription", "Metaclass_GetTypeDescription_Event", "Metaclass_GetTypeDescription_Request", "Metaclass_GetTypeDescription_Response", "GetTypeDescription", "GetTypeDescription_Event", "GetTypeDescription_Request", "GetTypeDescription_Response"]
