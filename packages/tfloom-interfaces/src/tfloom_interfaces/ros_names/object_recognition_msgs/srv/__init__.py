"""The services of object_recognition_msgs."""

from tfloom_interfaces.interfaces.object_recognition_msgs.srv import *
from tfloom_interfaces.interfaces.object_recognition_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from object_recognition_msgs.srv import _get_object_information as _get_object_information
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("object_recognition_msgs.srv")
