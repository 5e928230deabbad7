"""The classes of nav2_msgs/srv/Toggle, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import Toggle as Toggle
from tfloom_interfaces.interfaces.nav2_msgs.srv import Toggle_Event as Toggle_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import Toggle_Request as Toggle_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import Toggle_Response as Toggle_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Toggle
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Toggle_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Toggle_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Toggle_Response

__all__ = ["Metaclass_Toggle", "Metaclass_Toggle_Event", "Metaclass_Toggle_Request", "Metaclass_Toggle_Response", "Toggle", "Toggle_Event", "Toggle_Request", "Toggle_Response"]
