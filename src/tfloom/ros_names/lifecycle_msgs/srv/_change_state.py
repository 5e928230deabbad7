"""The classes of lifecycle_msgs/srv/ChangeState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.lifecycle_msgs.srv import ChangeState as ChangeState
from tfloom.interfaces.lifecycle_msgs.srv import ChangeState_Event as ChangeState_Event
from tfloom.interfaces.lifecycle_msgs.srv import ChangeState_Request as ChangeState_Request
from tfloom.interfaces.lifecycle_msgs.srv import ChangeState_Response as ChangeState_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ChangeState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ChangeState_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ChangeState_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ChangeState_Response

__all__ = ["Metaclass_ChangeState", "Metaclass_ChangeState_Event", "Metaclass_ChangeState_Request", "Metaclass_ChangeState_Response", "ChangeState", "ChangeState_Event", "ChangeState_Request", "ChangeState_Response"]
