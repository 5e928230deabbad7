"""The classes of rcl_interfaces/srv/SetParameters, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.srv import SetParameters as SetParameters
from tfloom.interfaces.rcl_interfaces.srv import SetParameters_Event as SetParameters_Event
from tfloom.interfaces.rcl_interfaces.srv import SetParameters_Request as SetParameters_Request
from tfloom.interfaces.rcl_interfaces.srv import SetParameters_Response as SetParameters_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetParameters
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetParameters_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetParameters_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetParameters_Response

__all__ = ["Metaclass_SetParameters", "Metaclass_SetParameters_Event", "Metaclass_SetParameters_Request", "Metaclass_SetParameters_Response", "SetParameters", "SetParameters_Event", "SetParameters_Request", "SetParameters_Response"]
