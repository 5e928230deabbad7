"""The classes of moveit_msgs/srv/ServoCommandType, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import ServoCommandType as ServoCommandType
from tfloom_interfaces.interfaces.moveit_msgs.srv import ServoCommandType_Event as ServoCommandType_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import ServoCommandType_Request as ServoCommandType_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import ServoCommandType_Response as ServoCommandType_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ServoCommandType
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ServoCommandType_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ServoCommandType_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ServoCommandType_Response

__all__ = ["Metaclass_ServoCommandType", "Metaclass_ServoCommandType_Event", "Metaclass_ServoCommandType_Request", "Metaclass_ServoCommandType_Response", "ServoCommandType", "ServoCommandType_Event", "ServoCommandType_Request", "ServoCommandType_Response"]
