"""The classes of map_msgs/srv/ProjectedMapsInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.map_msgs.srv import ProjectedMapsInfo as ProjectedMapsInfo
from tfloom_interfaces.interfaces.map_msgs.srv import ProjectedMapsInfo_Event as ProjectedMapsInfo_Event
from tfloom_interfaces.interfaces.map_msgs.srv import ProjectedMapsInfo_Request as ProjectedMapsInfo_Request
from tfloom_interfaces.interfaces.map_msgs.srv import ProjectedMapsInfo_Response as ProjectedMapsInfo_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ProjectedMapsInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ProjectedMapsInfo_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ProjectedMapsInfo_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ProjectedMapsInfo_Response

__all__ = ["Metaclass_ProjectedMapsInfo", "Metaclass_ProjectedMapsInfo_Event", "Metaclass_ProjectedMapsInfo_Request", "Metaclass_ProjectedMapsInfo_Response", "ProjectedMapsInfo", "ProjectedMapsInfo_Event", "ProjectedMapsInfo_Request", "ProjectedMapsInfo_Response"]
