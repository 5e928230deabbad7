"""The classes of turtlesim/srv/SetPen, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.turtlesim.srv import SetPen as SetPen
from tfloom.interfaces.turtlesim.srv import SetPen_Event as SetPen_Event
from tfloom.interfaces.turtlesim.srv import SetPen_Request as SetPen_Request
from tfloom.interfaces.turtlesim.srv import SetPen_Response as SetPen_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetPen
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetPen_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetPen_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetPen_Response

__all__ = ["Metaclass_SetPen", "Metaclass_SetPen_Event", "Metaclass_SetPen_Request", "Metaclass_SetPen_Response", "SetPen", "SetPen_Event", "SetPen_Request", "SetPen_Response"]
