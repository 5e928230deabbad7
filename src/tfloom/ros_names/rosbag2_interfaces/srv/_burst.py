"""The classes of rosbag2_interfaces/srv/Burst, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import Burst as Burst
from tfloom.interfaces.rosbag2_interfaces.srv import Burst_Event as Burst_Event
from tfloom.interfaces.rosbag2_interfaces.srv import Burst_Request as Burst_Request
from tfloom.interfaces.rosbag2_interfaces.srv import Burst_Response as Burst_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Burst
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Burst_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Burst_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Burst_Response

__all__ = ["Metaclass_Burst", "Metaclass_Burst_Event", "Metaclass_Burst_Request", "Metaclass_Burst_Response", "Burst", "Burst_Event", "Burst_Request", "Burst_Response"]
