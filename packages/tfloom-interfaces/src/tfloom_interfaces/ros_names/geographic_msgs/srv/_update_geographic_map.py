"""The classes of geographic_msgs/srv/UpdateGeographicMap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.geographic_msgs.srv import UpdateGeographicMap as UpdateGeographicMap
from tfloom_interfaces.interfaces.geographic_msgs.srv import UpdateGeographicMap_Event as UpdateGeographicMap_Event
from tfloom_interfaces.interfaces.geographic_msgs.srv import UpdateGeographicMap_Request as UpdateGeographicMap_Request
from tfloom_interfaces.interfaces.geographic_msgs.srv import UpdateGeographicMap_Response as UpdateGeographicMap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UpdateGeographicMap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UpdateGeographicMap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UpdateGeographicMap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UpdateGeographicMap_Response

__all__ = ["Metaclass_UpdateGeographicMap", "Metaclass_UpdateGeographicMap_Event", "Metaclass_UpdateGeographicMap_Request", "Metaclass_UpdateGeographicMap_Response", "UpdateGeographicMap", "UpdateGeographicMap_Event", "UpdateGeographicMap_Request", "UpdateGeographicMap_Response"]
