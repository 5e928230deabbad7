"""The classes of rcl_interfaces/srv/SetParametersAtomically, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.srv import SetParametersAtomically as SetParametersAtomically
from tfloom.interfaces.rcl_interfaces.srv import SetParametersAtomically_Event as SetParametersAtomically_Event
from tfloom.interfaces.rcl_interfaces.srv import SetParametersAtomically_Request as SetParametersAtomically_Request
from tfloom.interfaces.rcl_interfaces.srv import SetParametersAtomically_Response as SetParametersAtomically_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetParametersAtomically
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetParametersAtomically_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetParametersAtomically_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetParametersAtomically_Response

__all__ = ["Metaclass_SetParametersAtomically", "Metaclass_SetParametersAtomically_Event", "Metaclass_SetParametersAtomically_Request", "Metaclass_SetParametersAtomically_Response", "SetParametersAtomically", "SetParametersAtomically_Event", "SetParametersAtomically_Request", "SetParametersAtomically_Response"]
