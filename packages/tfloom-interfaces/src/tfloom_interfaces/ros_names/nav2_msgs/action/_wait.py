"""The classes of nav2_msgs/action/Wait, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.action import Wait as Wait
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_Feedback as Wait_Feedback
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_FeedbackMessage as Wait_FeedbackMessage
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_GetResult as Wait_GetResult
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_GetResult_Event as Wait_GetResult_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_GetResult_Request as Wait_GetResult_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_GetResult_Response as Wait_GetResult_Response
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_Goal as Wait_Goal
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_Result as Wait_Result
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_SendGoal as Wait_SendGoal
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_SendGoal_Event as Wait_SendGoal_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_SendGoal_Request as Wait_SendGoal_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import Wait_SendGoal_Response as Wait_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Wait_SendGoal_Response

__all__ = ["Metaclass_Wait", "Metaclass_Wait_Feedback", "Metaclass_Wait_FeedbackMessage", "Metaclass_Wait_GetResult", "Metaclass_Wait_GetResult_Event", "Metaclass_Wait_GetResult_Request", "Metaclass_Wait_GetResult_Response", "Metaclass_Wait_Goal", "Metaclass_Wait_Result", "Metaclass_Wait_SendGoal", "Metaclass_Wait_SendGoal_Event", "Metaclass_Wait_SendGoal_Request", "Metaclass_Wait_SendGoal_Response", "Wait", "Wait_Feedback", "Wait_FeedbackMessage", "Wait_GetResult", "Wait_GetResult_Event", "Wait_GetResult_Request", "Wait_GetResult_Response", "Wait_Goal", "Wait_Result", "Wait_SendGoal", "Wait_SendGoal_Event", "Wait_SendGoal_Request", "Wait_SendGoal_Response"]
