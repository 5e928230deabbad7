"""The classes of rcl_interfaces/srv/ListParameters, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.srv import ListParameters as ListParameters
from tfloom.interfaces.rcl_interfaces.srv import ListParameters_Event as ListParameters_Event
from tfloom.interfaces.rcl_interfaces.srv import ListParameters_Request as ListParameters_Request
from tfloom.interfaces.rcl_interfaces.srv import ListParameters_Response as ListParameters_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListParameters
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListParameters_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListParameters_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListParameters_Response

__all__ = ["Metaclass_ListParameters", "Metaclass_ListParameters_Event", "Metaclass_ListParameters_Request", "Metaclass_ListParameters_Response", "ListParameters", "ListParameters_Event", "ListParameters_Request", "ListParameters_Response"]
