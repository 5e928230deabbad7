"""The classes of control_msgs/action/PointHead, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.action import PointHead as PointHead
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_Feedback as PointHead_Feedback
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_FeedbackMessage as PointHead_FeedbackMessage
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_GetResult as PointHead_GetResult
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_GetResult_Event as PointHead_GetResult_Event
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_GetResult_Request as PointHead_GetResult_Request
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_GetResult_Response as PointHead_GetResult_Response
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_Goal as PointHead_Goal
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_Result as PointHead_Result
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_SendGoal as PointHead_SendGoal
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_SendGoal_Event as PointHead_SendGoal_Event
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_SendGoal_Request as PointHead_SendGoal_Request
from tfloom_interfaces.interfaces.control_msgs.action import PointHead_SendGoal_Response as PointHead_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointHead_SendGoal_Response

__all__ = ["Metaclass_PointHead", "Metaclass_PointHead_Feedback", "Metaclass_PointHead_FeedbackMessage", "Metaclass_PointHead_GetResult", "Metaclass_PointHead_GetResult_Event", "Metaclass_PointHead_GetResult_Request", "Metaclass_PointHead_GetResult_Response", "Metaclass_PointHead_Goal", "Metaclass_PointHead_Result", "Metaclass_PointHead_SendGoal", "Metaclass_PointHead_SendGoal_Event", "Metaclass_PointHead_SendGoal_Request", "Metaclass_PointHead_SendGoal_Response", "PointHead", "PointHead_Feedback", "PointHead_FeedbackMessage", "PointHead_GetResult", "PointHead_GetResult_Event", "PointHead_GetResult_Request", "PointHead_GetResult_Response", "PointHead_Goal", "PointHead_Result", "PointHead_SendGoal", "PointHead_SendGoal_Event", "PointHead_SendGoal_Request", "PointHead_SendGoal_Response"]
