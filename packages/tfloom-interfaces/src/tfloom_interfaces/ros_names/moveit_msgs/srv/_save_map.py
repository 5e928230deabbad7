"""The classes of moveit_msgs/srv/SaveMap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import SaveMap as SaveMap
from tfloom_interfaces.interfaces.moveit_msgs.srv import SaveMap_Event as SaveMap_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import SaveMap_Request as SaveMap_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import SaveMap_Response as SaveMap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SaveMap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SaveMap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SaveMap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SaveMap_Response

__all__ = ["Metaclass_SaveMap", "Metaclass_SaveMap_Event", "Metaclass_SaveMap_Request", "Metaclass_SaveMap_Response", "SaveMap", "SaveMap_Event", "SaveMap_Request", "SaveMap_Response"]
