"""The classes of moveit_msgs/srv/LoadMap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import LoadMap as LoadMap
from tfloom_interfaces.interfaces.moveit_msgs.srv import LoadMap_Event as LoadMap_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import LoadMap_Request as LoadMap_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import LoadMap_Response as LoadMap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadMap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadMap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadMap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadMap_Response

__all__ = ["Metaclass_LoadMap", "Metaclass_LoadMap_Event", "Metaclass_LoadMap_Request", "Metaclass_LoadMap_Response", "LoadMap", "LoadMap_Event", "LoadMap_Request", "LoadMap_Response"]
