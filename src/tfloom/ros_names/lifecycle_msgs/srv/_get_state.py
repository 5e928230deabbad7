"""The classes of lifecycle_msgs/srv/GetState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.lifecycle_msgs.srv import GetState as GetState
from tfloom.interfaces.lifecycle_msgs.srv import GetState_Event as GetState_Event
from tfloom.interfaces.lifecycle_msgs.srv import GetState_Request as GetState_Request
from tfloom.interfaces.lifecycle_msgs.srv import GetState_Response as GetState_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetState_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetState_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetState_Response

__all__ = ["Metaclass_GetState", "Metaclass_GetState_Event", "Metaclass_GetState_Request", "Metaclass_GetState_Response", "GetState", "GetState_Event", "GetState_Request", "GetState_Response"]
