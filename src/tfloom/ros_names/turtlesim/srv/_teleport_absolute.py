"""The classes of turtlesim/srv/TeleportAbsolute, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.turtlesim.srv import TeleportAbsolute as TeleportAbsolute
from tfloom.interfaces.turtlesim.srv import TeleportAbsolute_Event as TeleportAbsolute_Event
from tfloom.interfaces.turtlesim.srv import TeleportAbsolute_Request as TeleportAbsolute_Request
from tfloom.interfaces.turtlesim.srv import TeleportAbsolute_Response as TeleportAbsolute_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TeleportAbsolute
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TeleportAbsolute_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TeleportAbsolute_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TeleportAbsolute_Response

__all__ = ["Metaclass_TeleportAbsolute", "Metaclass_TeleportAbsolute_Event", "Metaclass_TeleportAbsolute_Request", "Metaclass_TeleportAbsolute_Response", "TeleportAbsolute", "TeleportAbsolute_Event", "TeleportAbsolute_Request", "TeleportAbsolute_Response"]
