"""The classes of sensor_msgs/srv/SetCameraInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.srv import SetCameraInfo as SetCameraInfo
from tfloom.interfaces.sensor_msgs.srv import SetCameraInfo_Event as SetCameraInfo_Event
from tfloom.interfaces.sensor_msgs.srv import SetCameraInfo_Request as SetCameraInfo_Request
from tfloom.interfaces.sensor_msgs.srv import SetCameraInfo_Response as SetCameraInfo_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetCameraInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetCameraInfo_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetCameraInfo_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SetCameraInfo_Response

__all__ = ["Metaclass_SetCameraInfo", "Metaclass_SetCameraInfo_Event", "Metaclass_SetCameraInfo_Request", "Metaclass_SetCameraInfo_Response", "SetCameraInfo", "SetCameraInfo_Event", "SetCameraInfo_Request", "SetCameraInfo_Response"]
