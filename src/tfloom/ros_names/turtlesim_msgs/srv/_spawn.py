"""The classes of turtlesim_msgs/srv/Spawn, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.turtlesim_msgs.srv import Spawn as Spawn
from tfloom.interfaces.turtlesim_msgs.srv import Spawn_Event as Spawn_Event
from tfloom.interfaces.turtlesim_msgs.srv import Spawn_Request as Spawn_Request
from tfloom.interfaces.turtlesim_msgs.srv import Spawn_Response as Spawn_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spawn
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spawn_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spawn_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Spawn_Response

__all__ = ["Metaclass_Spawn", "Metaclass_Spawn_Event", "Metaclass_Spawn_Request", "Metaclass_Spawn_Response", "Spawn", "Spawn_Event", "Spawn_Request", "Spawn_Response"]
