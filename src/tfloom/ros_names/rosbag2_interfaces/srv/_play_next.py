"""The classes of rosbag2_interfaces/srv/PlayNext, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import PlayNext as PlayNext
from tfloom.interfaces.rosbag2_interfaces.srv import PlayNext_Event as PlayNext_Event
from tfloom.interfaces.rosbag2_interfaces.srv import PlayNext_Request as PlayNext_Request
from tfloom.interfaces.rosbag2_interfaces.srv import PlayNext_Response as PlayNext_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlayNext
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlayNext_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlayNext_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlayNext_Response

__all__ = ["Metaclass_PlayNext", "Metaclass_PlayNext_Event", "Metaclass_PlayNext_Request", "Metaclass_PlayNext_Response", "PlayNext", "PlayNext_Event", "PlayNext_Request", "PlayNext_Response"]
