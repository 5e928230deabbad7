"""The classes of nav2_msgs/action/BackUp, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp as BackUp
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_Feedback as BackUp_Feedback
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_FeedbackMessage as BackUp_FeedbackMessage
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_GetResult as BackUp_GetResult
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_GetResult_Event as BackUp_GetResult_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_GetResult_Request as BackUp_GetResult_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_GetResult_Response as BackUp_GetResult_Response
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_Goal as BackUp_Goal
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_Result as BackUp_Result
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_SendGoal as BackUp_SendGoal
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_SendGoal_Event as BackUp_SendGoal_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_SendGoal_Request as BackUp_SendGoal_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import BackUp_SendGoal_Response as BackUp_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BackUp_SendGoal_Response

__all__ = ["Metaclass_BackUp", "Metaclass_BackUp_Feedback", "Metaclass_BackUp_FeedbackMessage", "Metaclass_BackUp_GetResult", "Metaclass_BackUp_GetResult_Event", "Metaclass_BackUp_GetResult_Request", "Metaclass_BackUp_GetResult_Response", "Metaclass_BackUp_Goal", "Metaclass_BackUp_Result", "Metaclass_BackUp_SendGoal", "Metaclass_BackUp_SendGoal_Event", "Metaclass_BackUp_SendGoal_Request", "Metaclass_BackUp_SendGoal_Response", "BackUp", "BackUp_Feedback", "BackUp_FeedbackMessage", "BackUp_GetResult", "BackUp_GetResult_Event", "BackUp_GetResult_Request", "BackUp_GetResult_Response", "BackUp_Goal", "BackUp_Result", "BackUp_SendGoal", "BackUp_SendGoal_Event", "BackUp_SendGoal_Request", "BackUp_SendGoal_Response"]
