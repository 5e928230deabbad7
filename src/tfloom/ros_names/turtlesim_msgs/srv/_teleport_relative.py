"""The classes of turtlesim_msgs/srv/TeleportRelative, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.turtlesim_msgs.srv import TeleportRelative as TeleportRelative
from tfloom.interfaces.turtlesim_msgs.srv import TeleportRelative_Event as TeleportRelative_Event
from tfloom.interfaces.turtlesim_msgs.srv import TeleportRelative_Request as TeleportRelative_Request
from tfloom.interfaces.turtlesim_msgs.srv import TeleportRelative_Response as TeleportRelative_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TeleportRelative
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TeleportRelative_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TeleportRelative_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TeleportRelative_Response

__all__ = ["Metaclass_TeleportRelative", "Metaclass_TeleportRelative_Event", "Metaclass_TeleportRelative_Request", "Metaclass_TeleportRelative_Response", "TeleportRelative", "TeleportRelative_Event", "TeleportRelative_Request", "TeleportRelative_Response"]
