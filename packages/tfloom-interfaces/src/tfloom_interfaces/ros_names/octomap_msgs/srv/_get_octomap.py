"""The classes of octomap_msgs/srv/GetOctomap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.octomap_msgs.srv import GetOctomap as GetOctomap
from tfloom_interfaces.interfaces.octomap_msgs.srv import GetOctomap_Event as GetOctomap_Event
from tfloom_interfaces.interfaces.octomap_msgs.srv import GetOctomap_Request as GetOctomap_Request
from tfloom_interfaces.interfaces.octomap_msgs.srv import GetOctomap_Response as GetOctomap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetOctomap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetOctomap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetOctomap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetOctomap_Response

__all__ = ["Metaclass_GetOctomap", "Metaclass_GetOctomap_Event", "Metaclass_GetOctomap_Request", "Metaclass_GetOctomap_Response", "GetOctomap", "GetOctomap_Event", "GetOctomap_Request", "GetOctomap_Response"]
