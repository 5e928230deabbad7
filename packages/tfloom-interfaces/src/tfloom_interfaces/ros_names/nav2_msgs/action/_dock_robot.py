"""The classes of nav2_msgs/action/DockRobot, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot as DockRobot
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_Feedback as DockRobot_Feedback
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_FeedbackMessage as DockRobot_FeedbackMessage
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_GetResult as DockRobot_GetResult
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_GetResult_Event as DockRobot_GetResult_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_GetResult_Request as DockRobot_GetResult_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_GetResult_Response as DockRobot_GetResult_Response
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_Goal as DockRobot_Goal
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_Result as DockRobot_Result
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_SendGoal as DockRobot_SendGoal
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_SendGoal_Event as DockRobot_SendGoal_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_SendGoal_Request as DockRobot_SendGoal_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import DockRobot_SendGoal_Response as DockRobot_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DockRobot_SendGoal_Response

__all__ = ["Metaclass_DockRobot", "Metaclass_DockRobot_Feedback", "Metaclass_DockRobot_FeedbackMessage", "Metaclass_DockRobot_GetResult", "Metaclass_DockRobot_GetResult_Event", "Metaclass_DockRobot_GetResult_Request", "Metaclass_DockRobot_GetResult_Response", "Metaclass_DockRobot_Goal", "Metaclass_DockRobot_Result", "Metaclass_DockRobot_SendGoal", "Metaclass_DockRobot_SendGoal_Event", "Metaclass_DockRobot_SendGoal_Request", "Metaclass_DockRobot_SendGoal_Response", "DockRobot", "DockRobot_Feedback", "DockRobot_FeedbackMessage", "DockRobot_GetResult", "DockRobot_GetResult_Event", "DockRobot_GetResult_Request", "DockRobot_GetResult_Response", "DockRobot_Goal", "DockRobot_Result", "DockRobot_SendGoal", "DockRobot_SendGoal_Event", "DockRobot_SendGoal_Request", "DockRobot_SendGoal_Response"]
