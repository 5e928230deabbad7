"""The classes of map_msgs/srv/SetMapProjections, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.map_msgs.srv import SetMapProjections as SetMapProjections
from tfloom_interfaces.interfaces.map_msgs.srv import SetMapProjections_Event as SetMapProjections_Event
from tfloom_interfaces.interfaces.map_msgs.srv import SetMapProjections_Request as SetMapProjections_Request
from tfloom_interfaces.interfaces.map_msgs.srv import SetMapProjections_Response as SetMapProjections_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetMapProjections
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetMapProjections_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetMapProjections_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetMapProjections_Response

__all__ = ["Metaclass_SetMapProjections", "Metaclass_SetMapProjections_Event", "Metaclass_SetMapProjections_Request", "Metaclass_SetMapProjections_Response", "SetMapProjections", "SetMapProjections_Event", "SetMapProjections_Request", "SetMapProjections_Response"]
