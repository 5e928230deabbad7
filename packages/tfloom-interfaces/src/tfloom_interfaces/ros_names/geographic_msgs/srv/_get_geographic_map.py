"""The classes of geographic_msgs/srv/GetGeographicMap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.srv import GetGeographicMap as GetGeographicMap
from tfloom_interfaces.interfaces.geographic_msgs.srv import GetGeographicMap_Event as GetGeographicMap_Event
from tfloom_interfaces.interfaces.geographic_msgs.srv import GetGeographicMap_Request as GetGeographicMap_Request
from tfloom_interfaces.interfaces.geographic_msgs.srv import GetGeographicMap_Response as GetGeographicMap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGeographicMap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGeographicMap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGeographicMap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetGeographicMap_Response

__all__ = ["Metaclass_GetGeographicMap", "Metaclass_GetGeographicMap_Event", "Metaclass_GetGeographicMap_Request", "Metaclass_GetGeographicMap_Response", "GetGeographicMap", "GetGeographicMap_Event", "GetGeographicMap_Request", "GetGeographicMap_Response"]
