"""The classes of controller_manager_msgs/srv/ConfigureController, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ConfigureController as ConfigureController
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ConfigureController_Event as ConfigureController_Event
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ConfigureController_Request as ConfigureController_Request
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ConfigureController_Response as ConfigureController_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ConfigureController
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ConfigureController_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ConfigureController_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ConfigureController_Response

__all__ = ["Metaclass_ConfigureController", "Metaclass_ConfigureController_Event", "Metaclass_ConfigureController_Request", "Metaclass_ConfigureController_Response", "ConfigureController", "ConfigureController_Event", "ConfigureController_Request", "ConfigureController_Response"]
