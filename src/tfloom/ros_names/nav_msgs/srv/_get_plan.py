"""The classes of nav_msgs/srv/GetPlan, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.nav_msgs.srv import GetPlan as GetPlan
from tfloom.interfaces.nav_msgs.srv import GetPlan_Event as GetPlan_Event
from tfloom.interfaces.nav_msgs.srv import GetPlan_Request as GetPlan_Request
from tfloom.interfaces.nav_msgs.srv import GetPlan_Response as GetPlan_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlan
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlan_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlan_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetPlan_Response

__all__ = ["Metaclass_GetPlan", "Metaclass_GetPlan_Event", "Metaclass_GetPlan_Request", "Metaclass_GetPlan_Response", "GetPlan", "GetPlan_Event", "GetPlan_Request", "GetPlan_Response"]
