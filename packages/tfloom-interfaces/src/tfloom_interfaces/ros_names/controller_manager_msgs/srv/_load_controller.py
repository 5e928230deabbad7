"""The classes of controller_manager_msgs/srv/LoadController, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.srv import LoadController as LoadController
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import LoadController_Event as LoadController_Event
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import LoadController_Request as LoadController_Request
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import LoadController_Response as LoadController_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadController
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadController_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadController_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadController_Response

__all__ = ["Metaclass_LoadController", "Metaclass_LoadController_Event", "Metaclass_LoadController_Request", "Metaclass_LoadController_Response", "LoadController", "LoadController_Event", "LoadController_Request", "LoadController_Response"]
