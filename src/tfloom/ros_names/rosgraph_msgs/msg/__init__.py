"""The messages of rosgraph_msgs."""

from tfloom.interfaces.rosgraph_msgs.msg import *
from tfloom.interfaces.rosgraph_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rosgraph_msgs.msg import _clock as _clock
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rosgraph_msgs.msg")
