"""The classes of nav2_msgs/srv/IsPathValid, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import IsPathValid as IsPathValid
from tfloom_interfaces.interfaces.nav2_msgs.srv import IsPathValid_Event as IsPathValid_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import IsPathValid_Request as IsPathValid_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import IsPathValid_Response as IsPathValid_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IsPathValid
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IsPathValid_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IsPathValid_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IsPathValid_Response

__all__ = ["Metaclass_IsPathValid", "Metaclass_IsPathValid_Event", "Metaclass_IsPathValid_Request", "Metaclass_IsPathValid_Response", "IsPathValid", "IsPathValid_Event", "IsPathValid_Request", "IsPathValid_Response"]
