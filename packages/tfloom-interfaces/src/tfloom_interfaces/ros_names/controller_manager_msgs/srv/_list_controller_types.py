"""The classes of controller_manager_msgs/srv/ListControllerTypes, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ListControllerTypes as ListControllerTypes
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ListControllerTypes_Event as ListControllerTypes_Event
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ListControllerTypes_Request as ListControllerTypes_Request
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import ListControllerTypes_Response as ListControllerTypes_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListControllerTypes
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListControllerTypes_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListControllerTypes_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListControllerTypes_Response

__all__ = ["Metaclass_ListControllerTypes", "Metaclass_ListControllerTypes_Event", "Metaclass_ListControllerTypes_Request", "Metaclass_ListControllerTypes_Response", "ListControllerTypes", "ListControllerTypes_Event", "ListControllerTypes_Request", "ListControllerTypes_Response"]
