"""The classes of diagnostic_msgs/srv/SelfTest, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.diagnostic_msgs.srv import SelfTest as SelfTest
from tfloom.interfaces.diagnostic_msgs.srv import SelfTest_Event as SelfTest_Event
from tfloom.interfaces.diagnostic_msgs.srv import SelfTest_Request as SelfTest_Request
from tfloom.interfaces.diagnostic_msgs.srv import SelfTest_Response as SelfTest_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SelfTest
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SelfTest_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SelfTest_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SelfTest_Response

__all__ = ["Metaclass_SelfTest", "Metaclass_SelfTest_Event", "Metaclass_SelfTest_Request", "Metaclass_SelfTest_Response", "SelfTest", "SelfTest_Event", "SelfTest_Request", "SelfTest_Response"]
