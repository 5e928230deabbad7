"""The classes of moveit_msgs/srv/QueryPlannerInterfaces, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import QueryPlannerInterfaces as QueryPlannerInterfaces
from tfloom_interfaces.interfaces.moveit_msgs.srv import QueryPlannerInterfaces_Event as QueryPlannerInterfaces_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import QueryPlannerInterfaces_Request as QueryPlannerInterfaces_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import QueryPlannerInterfaces_Response as QueryPlannerInterfaces_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryPlannerInterfaces
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryPlannerInterfaces_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryPlannerInterfaces_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryPlannerInterfaces_Response

__all__ = ["Metaclass_QueryPlannerInterfaces", "Metaclass_QueryPlannerInterfaces_Event", "Metaclass_QueryPlannerInterfaces_Request", "Metaclass_QueryPlannerInterfaces_Response", "QueryPlannerInterfaces", "QueryPlannerInterfaces_Event", "QueryPlannerInterfaces_Request", "QueryPlannerInterfaces_Response"]
