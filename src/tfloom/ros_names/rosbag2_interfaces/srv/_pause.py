"""The classes of rosbag2_interfaces/srv/Pause, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import Pause as Pause
from tfloom.interfaces.rosbag2_interfaces.srv import Pause_Event as Pause_Event
from tfloom.interfaces.rosbag2_interfaces.srv import Pause_Request as Pause_Request
from tfloom.interfaces.rosbag2_interfaces.srv import Pause_Response as Pause_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pause
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pause_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pause_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pause_Response

__all__ = ["Metaclass_Pause", "Metaclass_Pause_Event", "Metaclass_Pause_Request", "Metaclass_Pause_Response", "Pause", "Pause_Event", "Pause_Request", "Pause_Response"]
