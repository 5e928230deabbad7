"""The classes of octomap_msgs/srv/BoundingBoxQuery, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.octomap_msgs.srv import BoundingBoxQuery as BoundingBoxQuery
from tfloom_interfaces.interfaces.octomap_msgs.srv import BoundingBoxQuery_Event as BoundingBoxQuery_Event
from tfloom_interfaces.interfaces.octomap_msgs.srv import BoundingBoxQuery_Request as BoundingBoxQuery_Request
from tfloom_interfaces.interfaces.octomap_msgs.srv import BoundingBoxQuery_Response as BoundingBoxQuery_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingBoxQuery
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingBoxQuery_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingBoxQuery_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingBoxQuery_Response

__all__ = ["Metaclass_BoundingBoxQuery", "Metaclass_BoundingBoxQuery_Event", "Metaclass_BoundingBoxQuery_Request", "Metaclass_BoundingBoxQuery_Response", "BoundingBoxQuery", "BoundingBoxQuery_Event", "BoundingBoxQuery_Request", "BoundingBoxQuery_Response"]
