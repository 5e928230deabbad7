"""The classes of std_srvs/srv/Trigger, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_srvs.srv import Trigger as Trigger
from tfloom.interfaces.std_srvs.srv import Trigger_Event as Trigger_Event
from tfloom.interfaces.std_srvs.srv import Trigger_Request as Trigger_Request
from tfloom.interfaces.std_srvs.srv import Trigger_Response as Trigger_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Trigger
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Trigger_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Trigger_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Trigger_Response

__all__ = ["Metaclass_Trigger", "Metaclass_Trigger_Event", "Metaclass_Trigger_Request", "Metaclass_Trigger_Response", "Trigger", "Trigger_Event", "Trigger_Request", "Trigger_Response"]
