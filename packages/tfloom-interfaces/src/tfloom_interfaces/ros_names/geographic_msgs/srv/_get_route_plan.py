"""The classes of geographic_msgs/srv/GetRoutePlan, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.srv import GetRoutePlan as GetRoutePlan
from tfloom_interfaces.interfaces.geographic_msgs.srv import GetRoutePlan_Event as GetRoutePlan_Event
from tfloom_interfaces.interfaces.geographic_msgs.srv import GetRoutePlan_Request as GetRoutePlan_Request
from tfloom_interfaces.interfaces.geographic_msgs.srv import GetRoutePlan_Response as GetRoutePlan_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetRoutePlan
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetRoutePlan_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetRoutePlan_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetRoutePlan_Response

__all__ = ["Metaclass_GetRoutePlan", "Metaclass_GetRoutePlan_Event", "Metaclass_GetRoutePlan_Request", "Metaclass_GetRoutePlan_Response", "GetRoutePlan", "GetRoutePlan_Event", "GetRoutePlan_Request", "GetRoutePlan_Response"]
