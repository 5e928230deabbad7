"""The classes of control_msgs/srv/SetOdometry, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.srv import SetOdometry as SetOdometry
from tfloom_interfaces.interfaces.control_msgs.srv import SetOdometry_Event as SetOdometry_Event
from tfloom_interfaces.interfaces.control_msgs.srv import SetOdometry_Request as SetOdometry_Request
from tfloom_interfaces.interfaces.control_msgs.srv import SetOdometry_Response as SetOdometry_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetOdometry
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetOdometry_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetOdometry_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetOdometry_Response

__all__ = ["Metaclass_SetOdometry", "Metaclass_SetOdometry_Event", "Metaclass_SetOdometry_Request", "Metaclass_SetOdometry_Response", "SetOdometry", "SetOdometry_Event", "SetOdometry_Request", "SetOdometry_Response"]
