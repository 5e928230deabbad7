"""The classes of nav2_msgs/srv/DynamicEdges, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import DynamicEdges as DynamicEdges
from tfloom_interfaces.interfaces.nav2_msgs.srv import DynamicEdges_Event as DynamicEdges_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import DynamicEdges_Request as DynamicEdges_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import DynamicEdges_Response as DynamicEdges_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DynamicEdges
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DynamicEdges_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DynamicEdges_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DynamicEdges_Response

__all__ = ["Metaclass_DynamicEdges", "Metaclass_DynamicEdges_Event", "Metaclass_DynamicEdges_Request", "Metaclass_DynamicEdges_Response", "DynamicEdges", "DynamicEdges_Event", "DynamicEdges_Request", "DynamicEdges_Response"]
