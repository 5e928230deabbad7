"""The classes of rosbag2_interfaces/srv/TogglePaused, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import TogglePaused as TogglePaused
from tfloom.interfaces.rosbag2_interfaces.srv import TogglePaused_Event as TogglePaused_Event
from tfloom.interfaces.rosbag2_interfaces.srv import TogglePaused_Request as TogglePaused_Request
from tfloom.interfaces.rosbag2_interfaces.srv import TogglePaused_Response as TogglePaused_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TogglePaused
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TogglePaused_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TogglePaused_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TogglePaused_Response

__all__ = ["Metaclass_TogglePaused", "Metaclass_TogglePaused_Event", "Metaclass_TogglePaused_Request", "Metaclass_TogglePaused_Response", "TogglePaused", "TogglePaused_Event", "TogglePaused_Request", "TogglePaused_Response"]
