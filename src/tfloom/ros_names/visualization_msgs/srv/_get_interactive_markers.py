"""The classes of visualization_msgs/srv/GetInteractiveMarkers, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.srv import GetInteractiveMarkers as GetInteractiveMarkers
from tfloom.interfaces.visualization_msgs.srv import GetInteractiveMarkers_Event as GetInteractiveMarkers_Event
from tfloom.interfaces.visualization_msgs.srv import GetInteractiveMarkers_Request as GetInteractiveMarkers_Request
from tfloom.interfaces.visualization_msgs.srv import GetInteractiveMarkers_Response as GetInteractiveMarkers_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetInteractiveMarkers
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetInteractiveMarkers_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetInteractiveMarkers_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetInteractiveMarkers_Response

__all__ = ["Metaclass_GetInteractiveMarkers", "Metaclass_GetInteractiveMarkers_Event", "Metaclass_GetInteractiveMarkers_Request", "Metaclass_GetInteractiveMarkers_Response", "GetInteractiveMarkers", "GetInteractiveMarkers_Event", "GetInteractiveMarkers_Request", "GetInteractiveMarkers_Response"]
