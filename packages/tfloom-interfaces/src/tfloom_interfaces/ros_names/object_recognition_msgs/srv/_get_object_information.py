"""The classes of object_recognition_msgs/srv/GetObjectInformation, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.object_recognition_msgs.srv import GetObjectInformation as GetObjectInformation
from tfloom_interfaces.interfaces.object_recognition_msgs.srv import GetObjectInformation_Event as GetObjectInformation_Event
from tfloom_interfaces.interfaces.object_recognition_msgs.srv import GetObjectInformation_Request as GetObjectInformation_Request
from tfloom_interfaces.interfaces.object_recognition_msgs.srv import GetObjectInformation_Response as GetObjectInformation_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetObjectInformation
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetObjectInformation_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetObjectInformation_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetObjectInformation_Response

__all__ = ["Metaclass_GetObjectInformation", "Metaclass_GetObjectInformation_Event", "Metaclass_GetObjectInformation_Request", "Metaclass_GetObjectInformation_Response", "GetObjectInformation", "GetObjectInformation_Event", "GetObjectInformation_Request", "GetObjectInformation_Response"]
