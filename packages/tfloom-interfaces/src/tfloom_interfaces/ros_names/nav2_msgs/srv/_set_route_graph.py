"""The classes of nav2_msgs/srv/SetRouteGraph, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import SetRouteGraph as SetRouteGraph
from tfloom_interfaces.interfaces.nav2_msgs.srv import SetRouteGraph_Event as SetRouteGraph_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import SetRouteGraph_Request as SetRouteGraph_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import SetRouteGraph_Response as SetRouteGraph_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetRouteGraph
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetRouteGraph_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetRouteGraph_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetRouteGraph_Response

__all__ = ["Metaclass_SetRouteGraph", "Metaclass_SetRouteGraph_Event", "Metaclass_SetRouteGraph_Request", "Metaclass_SetRouteGraph_Response", "SetRouteGraph", "SetRouteGraph_Event", "SetRouteGraph_Request", "SetRouteGraph_Response"]
