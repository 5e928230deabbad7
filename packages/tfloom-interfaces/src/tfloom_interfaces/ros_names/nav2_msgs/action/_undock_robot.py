"""The classes of nav2_msgs/action/UndockRobot, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot as UndockRobot
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_Feedback as UndockRobot_Feedback
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_FeedbackMessage as UndockRobot_FeedbackMessage
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_GetResult as UndockRobot_GetResult
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_GetResult_Event as UndockRobot_GetResult_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_GetResult_Request as UndockRobot_GetResult_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_GetResult_Response as UndockRobot_GetResult_Response
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_Goal as UndockRobot_Goal
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_Result as UndockRobot_Result
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_SendGoal as UndockRobot_SendGoal
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_SendGoal_Event as UndockRobot_SendGoal_Event
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_SendGoal_Request as UndockRobot_SendGoal_Request
from tfloom_interfaces.interfaces.nav2_msgs.action import UndockRobot_SendGoal_Response as UndockRobot_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UndockRobot_SendGoal_Response

__all__ = ["Metaclass_UndockRobot", "Metaclass_UndockRobot_Feedback", "Metaclass_UndockRobot_FeedbackMessage", "Metaclass_UndockRobot_GetResult", "Metaclass_UndockRobot_GetResult_Event", "Metaclass_UndockRobot_GetResult_Request", "Metaclass_UndockRobot_GetResult_Response", "Metaclass_UndockRobot_Goal", "Metaclass_UndockRobot_Result", "Metaclass_UndockRobot_SendGoal", "Metaclass_UndockRobot_SendGoal_Event", "Metaclass_UndockRobot_SendGoal_Request", "Metaclass_UndockRobot_SendGoal_Response", "UndockRobot", "UndockRobot_Feedback", "UndockRobot_FeedbackMessage", "UndockRobot_GetResult", "UndockRobot_GetResult_Event", "UndockRobot_GetResult_Request", "UndockRobot_GetResult_Response", "UndockRobot_Goal", "UndockRobot_Result", "UndockRobot_SendGoal", "UndockRobot_SendGoal_Event", "UndockRobot_SendGoal_Request", "UndockRobot_SendGoal_Response"]
