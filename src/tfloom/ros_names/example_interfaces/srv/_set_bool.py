"""The classes of example_interfaces/srv/SetBool, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.srv import SetBool as SetBool
from tfloom.interfaces.example_interfaces.srv import SetBool_Event as SetBool_Event
from tfloom.interfaces.example_interfaces.srv import SetBool_Request as SetBool_Request
from tfloom.interfaces.example_interfaces.srv import SetBool_Response as SetBool_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetBool
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetBool_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetBool_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetBool_Response

__all__ = ["Metaclass_SetBool", "Metaclass_SetBool_Event", "Metaclass_SetBool_Request", "Metaclass_SetBool_Response", "SetBool", "SetBool_Event", "SetBool_Request", "SetBool_Response"]
