"""The classes of example_interfaces/srv/AddTwoInts, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.example_interfaces.srv import AddTwoInts as AddTwoInts
from tfloom.interfaces.example_interfaces.srv import AddTwoInts_Event as AddTwoInts_Event
from tfloom.interfaces.example_interfaces.srv import AddTwoInts_Request as AddTwoInts_Request
from tfloom.interfaces.example_interfaces.srv import AddTwoInts_Response as AddTwoInts_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AddTwoInts
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AddTwoInts_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AddTwoInts_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AddTwoInts_Response

__all__ = ["Metaclass_AddTwoInts", "Metaclass_AddTwoInts_Event", "Metaclass_AddTwoInts_Request", "Metaclass_AddTwoInts_Response", "AddTwoInts", "AddTwoInts_Event", "AddTwoInts_Request", "AddTwoInts_Response"]
