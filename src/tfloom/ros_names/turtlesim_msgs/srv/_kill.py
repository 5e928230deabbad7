"""The classes of turtlesim_msgs/srv/Kill, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.turtlesim_msgs.srv import Kill as Kill
from tfloom.interfaces.turtlesim_msgs.srv import Kill_Event as Kill_Event
from tfloom.interfaces.turtlesim_msgs.srv import Kill_Request as Kill_Request
from tfloom.interfaces.turtlesim_msgs.srv import Kill_Response as Kill_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Kill
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Kill_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Kill_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Kill_Response

__all__ = ["Metaclass_Kill", "Metaclass_Kill_Event", "Metaclass_Kill_Request", "Metaclass_Kill_Response", "Kill", "Kill_Event", "Kill_Request", "Kill_Response"]
