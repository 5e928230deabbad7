"""The classes of action_msgs/srv/CancelGoal, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.action_msgs.srv import CancelGoal as CancelGoal
from tfloom.interfaces.action_msgs.srv import CancelGoal_Event as CancelGoal_Event
from tfloom.interfaces.action_msgs.srv import CancelGoal_Request as CancelGoal_Request
from tfloom.interfaces.action_msgs.srv import CancelGoal_Response as CancelGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CancelGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CancelGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CancelGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CancelGoal_Response

__all__ = ["Metaclass_CancelGoal", "Metaclass_CancelGoal_Event", "Metaclass_CancelGoal_Request", "Metaclass_CancelGoal_Response", "CancelGoal", "CancelGoal_Event", "CancelGoal_Request", "CancelGoal_Response"]
