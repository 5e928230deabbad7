"""The actions of object_recognition_msgs."""

from tfloom_interfaces.interfaces.object_recognition_msgs.action import *
from tfloom_interfaces.interfaces.object_recognition_msgs.action import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from object_recognition_msgs.action import _object_recognition as _object_recognition
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("object_recognition_msgs.action")
