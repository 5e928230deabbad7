"""The classes of composition_interfaces/srv/LoadNode, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.composition_interfaces.srv import LoadNode as LoadNode
from tfloom.interfaces.composition_interfaces.srv import LoadNode_Event as LoadNode_Event
from tfloom.interfaces.composition_interfaces.srv import LoadNode_Request as LoadNode_Request
from tfloom.interfaces.composition_interfaces.srv import LoadNode_Response as LoadNode_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadNode
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadNode_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadNode_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadNode_Response

__all__ = ["Metaclass_LoadNode", "Metaclass_LoadNode_Event", "Metaclass_LoadNode_Request", "Metaclass_LoadNode_Response", "LoadNode", "LoadNode_Event", "LoadNode_Request", "LoadNode_Response"]
