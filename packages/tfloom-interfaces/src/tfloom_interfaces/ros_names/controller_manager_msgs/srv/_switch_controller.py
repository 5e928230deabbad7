"""The classes of controller_manager_msgs/srv/SwitchController, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.srv import SwitchController as SwitchController
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import SwitchController_Event as SwitchController_Event
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import SwitchController_Request as SwitchController_Request
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import SwitchController_Response as SwitchController_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SwitchController
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SwitchController_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SwitchController_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SwitchController_Response

__all__ = ["Metaclass_SwitchController", "Metaclass_SwitchController_Event", "Metaclass_SwitchController_Request", "Metaclass_SwitchController_Response", "SwitchController", "SwitchController_Event", "SwitchController_Request", "SwitchController_Response"]
