"""The classes of moveit_msgs/action/Pickup, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup as Pickup
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_Feedback as Pickup_Feedback
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_FeedbackMessage as Pickup_FeedbackMessage
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_GetResult as Pickup_GetResult
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_GetResult_Event as Pickup_GetResult_Event
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_GetResult_Request as Pickup_GetResult_Request
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_GetResult_Response as Pickup_GetResult_Response
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_Goal as Pickup_Goal
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_Result as Pickup_Result
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_SendGoal as Pickup_SendGoal
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_SendGoal_Event as Pickup_SendGoal_Event
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_SendGoal_Request as Pickup_SendGoal_Request
from tfloom_interfaces.interfaces.moveit_msgs.action import Pickup_SendGoal_Response as Pickup_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pickup_SendGoal_Response

__all__ = ["Metaclass_Pickup", "Metaclass_Pickup_Feedback", "Metaclass_Pickup_FeedbackMessage", "Metaclass_Pickup_GetResult", "Metaclass_Pickup_GetResult_Event", "Metaclass_Pickup_GetResult_Request", "Metaclass_Pickup_GetResult_Response", "Metaclass_Pickup_Goal", "Metaclass_Pickup_Result", "Metaclass_Pickup_SendGoal", "Metaclass_Pickup_SendGoal_Event", "Metaclass_Pickup_SendGoal_Request", "Metaclass_Pickup_SendGoal_Response", "Pickup", "Pickup_Feedback", "Pickup_FeedbackMessage", "Pickup_GetResult", "Pickup_GetResult_Event", "Pickup_GetResult_Request", "Pickup_GetResult_Response", "Pickup_Goal", "Pickup_Result", "Pickup_SendGoal", "Pickup_SendGoal_Event", "Pickup_SendGoal_Request", "Pickup_SendGoal_Response"]
