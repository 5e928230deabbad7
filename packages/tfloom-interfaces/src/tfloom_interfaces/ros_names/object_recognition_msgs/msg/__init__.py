"""The messages of object_recognition_msgs."""

from tfloom_interfaces.interfaces.object_recognition_msgs.msg import *
from tfloom_interfaces.interfaces.object_recognition_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from object_recognition_msgs.msg import _object_information as _object_information
    from object_recognition_msgs.msg import _object_type as _object_type
    from object_recognition_msgs.msg import _recognized_object as _recognized_object
    from object_recognition_msgs.msg import _recognized_object_array as _recognized_object_array
    from object_recognition_msgs.msg import _table as _table
    from object_recognition_msgs.msg import _table_array as _table_array
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("object_recognition_msgs.msg")
