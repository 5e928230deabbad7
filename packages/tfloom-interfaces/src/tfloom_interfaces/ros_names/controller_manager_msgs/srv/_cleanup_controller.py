"""The classes of controller_manager_msgs/srv/CleanupController, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.srv import CleanupController as CleanupController
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import CleanupController_Event as CleanupController_Event
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import CleanupController_Request as CleanupController_Request
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import CleanupController_Response as CleanupController_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CleanupController
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CleanupController_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CleanupController_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CleanupController_Response

__all__ = ["Metaclass_CleanupController", "Metaclass_CleanupController_Event", "Metaclass_CleanupController_Request", "Metaclass_CleanupController_Response", "CleanupController", "CleanupController_Event", "CleanupController_Request", "CleanupController_Response"]
