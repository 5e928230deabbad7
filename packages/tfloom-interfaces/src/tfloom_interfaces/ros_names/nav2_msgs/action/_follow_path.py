"""The classes of nav2_msgs/action/FollowPath, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath as FollowPath
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_Feedback as FollowPath_Feedback
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_FeedbackMessage as FollowPath_FeedbackMessage
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_GetResult as FollowPath_GetResult
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_GetResult_Event as FollowPath_GetResult_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_GetResult_Request as FollowPath_GetResult_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_GetResult_Response as FollowPath_GetResult_Response
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_Goal as FollowPath_Goal
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_Result as FollowPath_Result
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_SendGoal as FollowPath_SendGoal
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_SendGoal_Event as FollowPath_SendGoal_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_SendGoal_Request as FollowPath_SendGoal_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import FollowPath_SendGoal_Response as FollowPath_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FollowPath_SendGoal_Response

__all__ = ["Metaclass_FollowPath", "Metaclass_FollowPath_Feedback", "Metaclass_FollowPath_FeedbackMessage", "Metaclass_FollowPath_GetResult", "Metaclass_FollowPath_GetResult_Event", "Metaclass_FollowPath_GetResult_Request", "Metaclass_FollowPath_GetResult_Response", "Metaclass_FollowPath_Goal", "Metaclass_FollowPath_Result", "Metaclass_FollowPath_SendGoal", "Metaclass_FollowPath_SendGoal_Event", "Metaclass_FollowPath_SendGoal_Request", "Metaclass_FollowPath_SendGoal_Response", "FollowPath", "FollowPath_Feedback", "FollowPath_FeedbackMessage", "FollowPath_GetResult", "FollowPath_GetResult_Event", "FollowPath_GetResult_Request", "FollowPath_GetResult_Response", "FollowPath_Goal", "FollowPath_Result", "FollowPath_SendGoal", "FollowPath_SendGoal_Event", "FollowPath_SendGoal_Request", "FollowPath_SendGoal_Response"]
