"""The classes of rosbag2_interfaces/srv/Play, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import Play as Play
from tfloom.interfaces.rosbag2_interfaces.srv import Play_Event as Play_Event
from tfloom.interfaces.rosbag2_interfaces.srv import Play_Request as Play_Request
from tfloom.interfaces.rosbag2_interfaces.srv import Play_Response as Play_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Play
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Play_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Play_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Play_Response

__all__ = ["Metaclass_Play", "Metaclass_Play_Event", "Metaclass_Play_Request", "Metaclass_Play_Response", "Play", "Play_Event", "Play_Request", "Play_Response"]
