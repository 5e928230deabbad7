"""The classes of composition_interfaces/srv/ListNodes, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.composition_interfaces.srv import ListNodes as ListNodes
from tfloom.interfaces.composition_interfaces.srv import ListNodes_Event as ListNodes_Event
from tfloom.interfaces.composition_interfaces.srv import ListNodes_Request as ListNodes_Request
from tfloom.interfaces.composition_interfaces.srv import ListNodes_Response as ListNodes_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListNodes
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListNodes_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListNodes_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ListNodes_Response

__all__ = ["Metaclass_ListNodes", "Metaclass_ListNodes_Event", "Metaclass_ListNodes_Request", "Metaclass_ListNodes_Response", "ListNodes", "ListNodes_Event", "ListNodes_Request", "ListNodes_Response"]
