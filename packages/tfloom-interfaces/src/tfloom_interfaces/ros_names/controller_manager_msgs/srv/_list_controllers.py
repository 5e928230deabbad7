"""The classes of controller_manager_msgs/srv/ListControllers, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ListControllers as ListControllers
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ListControllers_Event as ListControllers_Event
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ListControllers_Request as ListControllers_Request
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ListControllers_Response as ListControllers_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListControllers
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListControllers_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListControllers_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListControllers_Response

__all__ = ["Metaclass_ListControllers", "Metaclass_ListControllers_Event", "Metaclass_ListControllers_Request", "Metaclass_ListControllers_Response", "ListControllers", "ListControllers_Event", "ListControllers_Request", "ListControllers_Response"]
