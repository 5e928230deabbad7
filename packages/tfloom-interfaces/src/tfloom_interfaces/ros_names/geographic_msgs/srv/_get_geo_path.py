"""The classes of geographic_msgs/srv/GetGeoPath, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.srv import GetGeoPath as GetGeoPath
from tfloom_interfaces.interfaces.geographic_msgs.srv import GetGeoPath_Event as GetGeoPath_Event
from tfloom_interfaces.interfaces.geographic_msgs.srv import GetGeoPath_Request as GetGeoPath_Request
from tfloom_interfaces.interfaces.geographic_msgs.srv import GetGeoPath_Response as GetGeoPath_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGeoPath
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGeoPath_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGeoPath_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGeoPath_Response

__all__ = ["Metaclass_GetGeoPath", "Metaclass_GetGeoPath_Event", "Metaclass_GetGeoPath_Request", "Metaclass_GetGeoPath_Response", "GetGeoPath", "GetGeoPath_Event", "GetGeoPath_Request", "GetGeoPath_Response"]
