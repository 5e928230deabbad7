"""The classes of rosbag2_interfaces/srv/IsPaused, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import IsPaused as IsPaused
from tfloom.interfaces.rosbag2_interfaces.srv import IsPaused_Event as IsPaused_Event
from tfloom.interfaces.rosbag2_interfaces.srv import IsPaused_Request as IsPaused_Request
from tfloom.interfaces.rosbag2_interfaces.srv import IsPaused_Response as IsPaused_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IsPaused
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IsPaused_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IsPaused_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IsPaused_Response

__all__ = ["Metaclass_IsPaused", "Metaclass_IsPaused_Event", "Metaclass_IsPaused_Request", "Metaclass_IsPaused_Response", "IsPaused", "IsPaused_Event", "IsPaused_Request", "IsPaused_Response"]
