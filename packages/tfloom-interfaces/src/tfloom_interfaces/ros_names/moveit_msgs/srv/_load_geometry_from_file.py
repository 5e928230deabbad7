"""The classes of moveit_msgs/srv/LoadGeometryFromFile, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import LoadGeometryFromFile as LoadGeometryFromFile
from tfloom_interfaces.interfaces.moveit_msgs.srv import LoadGeometryFromFile_Event as LoadGeometryFromFile_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import LoadGeometryFromFile_Request as LoadGeometryFromFile_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import LoadGeometryFromFile_Response as LoadGeometryFromFile_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadGeometryFromFile
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadGeometryFromFile_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadGeometryFromFile_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LoadGeometryFromFile_Response

__all__ = ["Metaclass_LoadGeometryFromFile", "Metaclass_LoadGeometryFromFile_Event", "Metaclass_LoadGeometryFromFile_Request", "Metaclass_LoadGeometryFromFile_Response", "LoadGeometryFromFile", "LoadGeometryFromFile_Event", "LoadGeometryFromFile_Request", "LoadGeometryFromFile_Response"]
