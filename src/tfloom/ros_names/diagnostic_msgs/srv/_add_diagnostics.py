"""The classes of diagnostic_msgs/srv/AddDiagnostics, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.diagnostic_msgs.srv import AddDiagnostics as AddDiagnostics
from tfloom.interfaces.diagnostic_msgs.srv import AddDiagnostics_Event as AddDiagnostics_Event
from tfloom.interfaces.diagnostic_msgs.srv import AddDiagnostics_Request as AddDiagnostics_Request
from tfloom.interfaces.diagnostic_msgs.srv import AddDiagnostics_Response as AddDiagnostics_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AddDiagnostics
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AddDiagnostics_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AddDiagnostics_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AddDiagnostics_Response

__all__ = ["Metaclass_AddDiagnostics", "Metaclass_AddDiagnostics_Event", "Metaclass_AddDiagnostics_Request", "Metaclass_AddDiagnostics_Response", "AddDiagnostics", "AddDiagnostics_Event", "AddDiagnostics_Request", "AddDiagnostics_Response"]
