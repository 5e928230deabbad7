"""The classes of rosbag2_interfaces/srv/SplitBagfile, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import SplitBagfile as SplitBagfile
from tfloom.interfaces.rosbag2_interfaces.srv import SplitBagfile_Event as SplitBagfile_Event
from tfloom.interfaces.rosbag2_interfaces.srv import SplitBagfile_Request as SplitBagfile_Request
from tfloom.interfaces.rosbag2_interfaces.srv import SplitBagfile_Response as SplitBagfile_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SplitBagfile
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SplitBagfile_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SplitBagfile_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SplitBagfile_Response

__all__ = ["Metaclass_SplitBagfile", "Metaclass_SplitBagfile_Event", "Metaclass_SplitBagfile_Request", "Metaclass_SplitBagfile_Response", "SplitBagfile", "SplitBagfile_Event", "SplitBagfile_Request", "SplitBagfile_Response"]
