"""The classes of lifecycle_msgs/srv/GetAvailableTransitions, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.lifecycle_msgs.srv import GetAvailableTransitions as GetAvailableTransitions
from tfloom.interfaces.lifecycle_msgs.srv import GetAvailableTransitions_Event as GetAvailableTransitions_Event
from tfloom.interfaces.lifecycle_msgs.srv import GetAvailableTransitions_Request as GetAvailableTransitions_Request
from tfloom.interfaces.lifecycle_msgs.srv import GetAvailableTransitions_Response as GetAvailableTransitions_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetAvailableTransitions
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetAvailableTransitions_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetAvailableTransitions_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetAvailableTransitions_Response

__all__ = ["Metaclass_GetAvailableTransitions", "Metaclass_GetAvailableTransitions_Event", "Metaclass_GetAvailableTransitions_Request", "Metaclass_GetAvailableTransitions_Response", "GetAvailableTransitions", "GetAvailableTransitions_Event", "GetAvailableTransitions_Request", "GetAvailableTransitions_Response"]
