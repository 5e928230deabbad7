"""The classes of rosbag2_interfaces/srv/Resume, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import Resume as Resume
from tfloom.interfaces.rosbag2_interfaces.srv import Resume_Event as Resume_Event
from tfloom.interfaces.rosbag2_interfaces.srv import Resume_Request as Resume_Request
from tfloom.interfaces.rosbag2_interfaces.srv import Resume_Response as Resume_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Resume
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Resume_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Resume_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Resume_Response

__all__ = ["Metaclass_Resume", "Metaclass_Resume_Event", "Metaclass_Resume_Request", "Metaclass_Resume_Response", "Resume", "Resume_Event", "Resume_Request", "Resume_Response"]
