"""The messages of tf2_msgs."""

from tfloom.interfaces.tf2_msgs.msg import *
from tfloom.interfaces.tf2_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tf2_msgs.msg import _tf2_error as _tf2_error
    from tf2_msgs.msg import _tf_message as _tf_message
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("tf2_msgs.msg")
