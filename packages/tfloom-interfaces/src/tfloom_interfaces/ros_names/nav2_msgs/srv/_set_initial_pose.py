"""The classes of nav2_msgs/srv/SetInitialPose, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import SetInitialPose as SetInitialPose
from tfloom_interfaces.interfaces.nav2_msgs.srv import SetInitialPose_Event as SetInitialPose_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import SetInitialPose_Request as SetInitialPose_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import SetInitialPose_Response as SetInitialPose_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetInitialPose
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetInitialPose_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetInitialPose_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetInitialPose_Response

__all__ = ["Metaclass_SetInitialPose", "Metaclass_SetInitialPose_Event", "Metaclass_SetInitialPose_Request", "Metaclass_SetInitialPose_Response", "SetInitialPose", "SetInitialPose_Event", "SetInitialPose_Request", "SetInitialPose_Response"]
