"""The classes of moveit_msgs/srv/GetMotionSequence, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GetMotionSequence as GetMotionSequence
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetMotionSequence_Event as GetMotionSequence_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetMotionSequence_Request as GetMotionSequence_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetMotionSequence_Response as GetMotionSequence_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMotionSequence
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMotionSequence_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMotionSequence_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetMotionSequence_Response

__all__ = ["Metaclass_GetMotionSequence", "Metaclass_GetMotionSequence_Event", "Metaclass_GetMotionSequence_Request", "Metaclass_GetMotionSequence_Response", "GetMotionSequence", "GetMotionSequence_Event", "GetMotionSequence_Request", "GetMotionSequence_Response"]
