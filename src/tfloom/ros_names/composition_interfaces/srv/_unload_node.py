"""The classes of composition_interfaces/srv/UnloadNode, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.composition_interfaces.srv import UnloadNode as UnloadNode
from tfloom.interfaces.composition_interfaces.srv import UnloadNode_Event as UnloadNode_Event
from tfloom.interfaces.composition_interfaces.srv import UnloadNode_Request as UnloadNode_Request
from tfloom.interfaces.composition_interfaces.srv import UnloadNode_Response as UnloadNode_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UnloadNode
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UnloadNode_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UnloadNode_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UnloadNode_Response

__all__ = ["Metaclass_UnloadNode", "Metaclass_UnloadNode_Event", "Metaclass_UnloadNode_Request", "Metaclass_UnloadNode_Response", "UnloadNode", "UnloadNode_Event", "UnloadNode_Request", "UnloadNode_Response"]
