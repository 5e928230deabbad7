"""The classes of std_srvs/srv/Empty, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_srvs.srv import Empty as Empty
from tfloom.interfaces.std_srvs.srv import Empty_Event as Empty_Event
from tfloom.interfaces.std_srvs.srv import Empty_Request as Empty_Request
from tfloom.interfaces.std_srvs.srv import Empty_Response as Empty_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Empty
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Empty_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Empty_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Empty_Response

__all__ = ["Metaclass_Empty", "Metaclass_Empty_Event", "Metaclass_Empty_Request", "Metaclass_Empty_Response", "Empty", "Empty_Event", "Empty_Request", "Empty_Response"]
