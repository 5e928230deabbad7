"""The classes of nav2_msgs/srv/ManageLifecycleNodes, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import ManageLifecycleNodes as ManageLifecycleNodes
from tfloom_interfaces.interfaces.nav2_msgs.srv import ManageLifecycleNodes_Event as ManageLifecycleNodes_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import ManageLifecycleNodes_Request as ManageLifecycleNodes_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import ManageLifecycleNodes_Response as ManageLifecycleNodes_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ManageLifecycleNodes
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ManageLifecycleNodes_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ManageLifecycleNodes_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ManageLifecycleNodes_Response

__all__ = ["Metaclass_ManageLifecycleNodes", "Metaclass_ManageLifecycleNodes_Event", "Metaclass_ManageLifecycleNodes_Request", "Metaclass_ManageLifecycleNodes_Response", "ManageLifecycleNodes", "ManageLifecycleNodes_Event", "ManageLifecycleNodes_Request", "ManageLifecycleNodes_Response"]
