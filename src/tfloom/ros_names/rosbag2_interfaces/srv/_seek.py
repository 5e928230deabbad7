"""The classes of rosbag2_interfaces/srv/Seek, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import Seek as Seek
from tfloom.interfaces.rosbag2_interfaces.srv import Seek_Event as Seek_Event
from tfloom.interfaces.rosbag2_interfaces.srv import Seek_Request as Seek_Request
from tfloom.interfaces.rosbag2_interfaces.srv import Seek_Response as Seek_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Seek
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Seek_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Seek_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Seek_Response

__all__ = ["Metaclass_Seek", "Metaclass_Seek_Event", "Metaclass_Seek_Request", "Metaclass_Seek_Response", "Seek", "Seek_Event", "Seek_Request", "Seek_Response"]
