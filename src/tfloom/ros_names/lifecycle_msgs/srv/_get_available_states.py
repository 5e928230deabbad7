"""The classes of lifecycle_msgs/srv/GetAvailableStates, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.lifecycle_msgs.srv import GetAvailableStates as GetAvailableStates
from tfloom.interfaces.lifecycle_msgs.srv import GetAvailableStates_Event as GetAvailableStates_Event
from tfloom.interfaces.lifecycle_msgs.srv import GetAvailableStates_Request as GetAvailableStates_Request
from tfloom.interfaces.lifecycle_msgs.srv import GetAvailableStates_Response as GetAvailableStates_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetAvailableStates
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetAvailableStates_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetAvailableStates_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetAvailableStates_Response

__all__ = ["Metaclass_GetAvailableStates", "Metaclass_GetAvailableStates_Event", "Metaclass_GetAvailableStates_Request", "Metaclass_GetAvailableStates_Response", "GetAvailableStates", "GetAvailableStates_Event", "GetAvailableStates_Request", "GetAvailableStates_Response"]
