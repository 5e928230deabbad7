"""The classes of nav2_msgs/action/SmoothPath, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath as SmoothPath
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_Feedback as SmoothPath_Feedback
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_FeedbackMessage as SmoothPath_FeedbackMessage
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_GetResult as SmoothPath_GetResult
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_GetResult_Event as SmoothPath_GetResult_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_GetResult_Request as SmoothPath_GetResult_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_GetResult_Response as SmoothPath_GetResult_Response
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_Goal as SmoothPath_Goal
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_Result as SmoothPath_Result
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_SendGoal as SmoothPath_SendGoal
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_SendGoal_Event as SmoothPath_SendGoal_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_SendGoal_Request as SmoothPath_SendGoal_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import SmoothPath_SendGoal_Response as SmoothPath_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SmoothPath_SendGoal_Response

__all__ = ["Metaclass_SmoothPath", "Metaclass_SmoothPath_Feedback", "Metaclass_SmoothPath_FeedbackMessage", "Metaclass_SmoothPath_GetResult", "Metaclass_SmoothPath_GetResult_Event", "Metaclass_SmoothPath_GetResult_Request", "Metaclass_SmoothPath_GetResult_Response", "Metaclass_SmoothPath_Goal", "Metaclass_SmoothPath_Result", "Metaclass_SmoothPath_SendGoal", "Metaclass_SmoothPath_SendGoal_Event", "Metaclass_SmoothPath_SendGoal_Request", "Metaclass_SmoothPath_SendGoal_Response", "SmoothPath", "SmoothPath_Feedback", "SmoothPath_FeedbackMessage", "SmoothPath_GetResult", "SmoothPath_GetResult_Event", "SmoothPath_GetResult_Request", "SmoothPath_GetResult_Response", "SmoothPath_Goal", "SmoothPath_Result", "SmoothPath_SendGoal", "SmoothPath_SendGoal_Event", "SmoothPath_SendGoal_Request", "SmoothPath_SendGoal_Response"]
