"""The classes of nav2_msgs/action/Spin, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.action import Spin as Spin
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_Feedback as Spin_Feedback
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_FeedbackMessage as Spin_FeedbackMessage
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_GetResult as Spin_GetResult
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_GetResult_Event as Spin_GetResult_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_GetResult_Request as Spin_GetResult_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_GetResult_Response as Spin_GetResult_Response
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_Goal as Spin_Goal
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_Result as Spin_Result
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_SendGoal as Spin_SendGoal
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_SendGoal_Event as Spin_SendGoal_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_SendGoal_Request as Spin_SendGoal_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import Spin_SendGoal_Response as Spin_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spin_SendGoal_Response

__all__ = ["Metaclass_Spin", "Metaclass_Spin_Feedback", "Metaclass_Spin_FeedbackMessage", "Metaclass_Spin_GetResult", "Metaclass_Spin_GetResult_Event", "Metaclass_Spin_GetResult_Request", "Metaclass_Spin_GetResult_Response", "Metaclass_Spin_Goal", "Metaclass_Spin_Result", "Metaclass_Spin_SendGoal", "Metaclass_Spin_SendGoal_Event", "Metaclass_Spin_SendGoal_Request", "Metaclass_Spin_SendGoal_Response", "Spin", "Spin_Feedback", "Spin_FeedbackMessage", "Spin_GetResult", "Spin_GetResult_Event", "Spin_GetResult_Request", "Spin_GetResult_Response", "Spin_Goal", "Spin_Result", "Spin_SendGoal", "Spin_SendGoal_Event", "Spin_SendGoal_Request", "Spin_SendGoal_Response"]
