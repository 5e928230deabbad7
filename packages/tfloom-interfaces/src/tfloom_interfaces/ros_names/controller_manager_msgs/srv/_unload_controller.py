"""The classes of controller_manager_msgs/srv/UnloadController, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.srv import UnloadController as UnloadController
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import UnloadController_Event as UnloadController_Event
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import UnloadController_Request as UnloadController_Request
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import UnloadController_Response as UnloadController_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UnloadController
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UnloadController_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UnloadController_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UnloadController_Response

__all__ = ["Metaclass_UnloadController", "Metaclass_UnloadController_Event", "Metaclass_UnloadController_Request", "Metaclass_UnloadController_Response", "UnloadController", "UnloadController_Event", "UnloadController_Request", "UnloadController_Response"]
