"""The classes of moveit_msgs/action/MoveGroup, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup as MoveGroup
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_Feedback as MoveGroup_Feedback
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_FeedbackMessage as MoveGroup_FeedbackMessage
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_GetResult as MoveGroup_GetResult
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_GetResult_Event as MoveGroup_GetResult_Event
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_GetResult_Request as MoveGroup_GetResult_Request
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_GetResult_Response as MoveGroup_GetResult_Response
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_Goal as MoveGroup_Goal
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_Result as MoveGroup_Result
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_SendGoal as MoveGroup_SendGoal
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_SendGoal_Event as MoveGroup_SendGoal_Event
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_SendGoal_Request as MoveGroup_SendGoal_Request
from tfloom_interfaces.interfaces.moveit_msgs.action import MoveGroup_SendGoal_Response as MoveGroup_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MoveGroup_SendGoal_Response

__all__ = ["Metaclass_MoveGroup", "Metaclass_MoveGroup_Feedback", "Metaclass_MoveGroup_FeedbackMessage", "Metaclass_MoveGroup_GetResult", "Metaclass_MoveGroup_GetResult_Event", "Metaclass_MoveGroup_GetResult_Request", "Metaclass_MoveGroup_GetResult_Response", "Metaclass_MoveGroup_Goal", "Metaclass_MoveGroup_Result", "Metaclass_MoveGroup_SendGoal", "Metaclass_MoveGroup_SendGoal_Event", "Metaclass_MoveGroup_SendGoal_Request", "Metaclass_MoveGroup_SendGoal_Response", "MoveGroup", "MoveGroup_Feedback", "MoveGroup_FeedbackMessage", "MoveGroup_GetResult", "MoveGroup_GetResult_Event", "MoveGroup_GetResult_Request", "MoveGroup_GetResult_Response", "MoveGroup_Goal", "MoveGroup_Result", "MoveGroup_SendGoal", "MoveGroup_SendGoal_Event", "MoveGroup_SendGoal_Request", "MoveGroup_SendGoal_Response"]
