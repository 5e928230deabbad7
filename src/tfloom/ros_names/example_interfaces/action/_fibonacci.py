"""The classes of example_interfaces/action/Fibonacci, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.action import Fibonacci as Fibonacci
from tfloom.interfaces.example_interfaces.action import Fibonacci_Feedback as Fibonacci_Feedback
from tfloom.interfaces.example_interfaces.action import Fibonacci_FeedbackMessage as Fibonacci_FeedbackMessage
from tfloom.interfaces.example_interfaces.action import Fibonacci_GetResult as Fibonacci_GetResult
from tfloom.interfaces.example_interfaces.action import Fibonacci_GetResult_Event as Fibonacci_GetResult_Event
from tfloom.interfaces.example_interfaces.action import Fibonacci_GetResult_Request as Fibonacci_GetResult_Request
from tfloom.interfaces.example_interfaces.action import Fibonacci_GetResult_Response as Fibonacci_GetResult_Response
from tfloom.interfaces.example_interfaces.action import Fibonacci_Goal as Fibonacci_Goal
from tfloom.interfaces.example_interfaces.action import Fibonacci_Result as Fibonacci_Result
from tfloom.interfaces.example_interfaces.action import Fibonacci_SendGoal as Fibonacci_SendGoal
from tfloom.interfaces.example_interfaces.action import Fibonacci_SendGoal_Event as Fibonacci_SendGoal_Event
from tfloom.interfaces.example_interfaces.action import Fibonacci_SendGoal_Request as Fibonacci_SendGoal_Request
from tfloom.interfaces.example_interfaces.action import Fibonacci_SendGoal_Response as Fibonacci_SendGoal_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_Feedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_FeedbackMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_GetResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_GetResult_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_GetResult_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_GetResult_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_Goal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_Result
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_SendGoal
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_SendGoal_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_SendGoal_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Fibonacci_SendGoal_Response

__all__ = ["Metaclass_Fibonacci", "Metaclass_Fibonacci_Feedback", "Metaclass_Fibonacci_FeedbackMessage", "Metaclass_Fibonacci_GetResult", "Metaclass_Fibonacci_GetResult_Event", "Metaclass_Fibonacci_GetResult_Request", "Metaclass_Fibonacci_GetResult_Response", "Metaclass_Fibonacci_Goal", "Metaclass_Fibonacci_Result", "Metaclass_Fibonacci_SendGoal", "Metaclass_Fibonacci_SendGoal_Event", "Metaclass_Fibonacci_SendGoal_Request", "Metaclass_Fibonacci_SendGoal_Response", "Fibonacci", "Fibonacci_Feedback", "Fibonacci_FeedbackMessage", "Fibonacci_GetResult", "Fibonacci_GetResult_Event", "Fibonacci_GetResult_Request", "Fibonacci_GetResult_Response", "Fibonacci_Goal", "Fibonacci_Result", "Fibonacci_SendGoal", "Fibonacci_SendGoal_Event", "Fibonacci_SendGoal_Request", "Fibonacci_SendGoal_Response"]
