"""The classes of rosbag2_interfaces/srv/Stop, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import Stop as Stop
from tfloom.interfaces.rosbag2_interfaces.srv import Stop_Event as Stop_Event
from tfloom.interfaces.rosbag2_interfaces.srv import Stop_Request as Stop_Request
from tfloom.interfaces.rosbag2_interfaces.srv import Stop_Response as Stop_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Stop
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Stop_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Stop_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Stop_Response

__all__ = ["Metaclass_Stop", "Metaclass_Stop_Event", "Metaclass_Stop_Request", "Metaclass_Stop_Response", "Stop", "Stop_Event", "Stop_Request", "Stop_Response"]
