"""The classes of moveit_msgs/action/Place, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.action import Place as Place
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_Feedback as Place_Feedback
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_FeedbackMessage as Place_FeedbackMessage
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_GetResult as Place_GetResult
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_GetResult_Event as Place_GetResult_Event
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_GetResult_Request as Place_GetResult_Request
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_GetResult_Response as Place_GetResult_Response
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_Goal as Place_Goal
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_Result as Place_Result
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_SendGoal as Place_SendGoal
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_SendGoal_Event as Place_SendGoal_Event
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_SendGoal_Request as Place_SendGoal_Request
from tfloom_interfaces.interfaces.moveit_msgs.action import Place_SendGoal_Response as Place_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Place_SendGoal_Response

__all__ = ["Metaclass_Place", "Metaclass_Place_Feedback", "Metaclass_Place_FeedbackMessage", "Metaclass_Place_GetResult", "Metaclass_Place_GetResult_Event", "Metaclass_Place_GetResult_Request", "Metaclass_Place_GetResult_Response", "Metaclass_Place_Goal", "Metaclass_Place_Result", "Metaclass_Place_SendGoal", "Metaclass_Place_SendGoal_Event", "Metaclass_Place_SendGoal_Request", "Metaclass_Place_SendGoal_Response", "Place", "Place_Feedback", "Place_FeedbackMessage", "Place_GetResult", "Place_GetResult_Event", "Place_GetResult_Request", "Place_GetResult_Response", "Place_Goal", "Place_Result", "Place_SendGoal", "Place_SendGoal_Event", "Place_SendGoal_Request", "Place_SendGoal_Response"]
