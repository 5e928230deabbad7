"""The classes of nav2_msgs/srv/GetCost, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import GetCost as GetCost
from tfloom_interfaces.interfaces.nav2_msgs.srv import GetCost_Event as GetCost_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import GetCost_Request as GetCost_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import GetCost_Response as GetCost_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCost
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCost_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCost_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetCost_Response

__all__ = ["Metaclass_GetCost", "Metaclass_GetCost_Event", "Metaclass_GetCost_Request", "Metaclass_GetCost_Response", "GetCost", "GetCost_Event", "GetCost_Request", "GetCost_Response"]
