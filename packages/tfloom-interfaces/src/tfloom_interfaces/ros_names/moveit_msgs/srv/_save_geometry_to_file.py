"""The classes of moveit_msgs/srv/SaveGeometryToFile, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import SaveGeometryToFile as SaveGeometryToFile
from tfloom_interfaces.interfaces.moveit_msgs.srv import SaveGeometryToFile_Event as SaveGeometryToFile_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import SaveGeometryToFile_Request as SaveGeometryToFile_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import SaveGeometryToFile_Response as SaveGeometryToFile_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SaveGeometryToFile
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SaveGeometryToFile_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SaveGeometryToFile_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SaveGeometryToFile_Response

__all__ = ["Metaclass_SaveGeometryToFile", "Metaclass_SaveGeometryToFile_Event", "Metaclass_SaveGeometryToFile_Request", "Metaclass_SaveGeometryToFile_Response", "SaveGeometryToFile", "SaveGeometryToFile_Event", "SaveGeometryToFile_Request", "SaveGeometryToFile_Response"]
