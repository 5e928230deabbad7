"""The messages of turtlesim_msgs."""

from tfloom.interfaces.turtlesim_msgs.msg import *
from tfloom.interfaces.turtlesim_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from turtlesim_msgs.msg import _color as _color
    from turtlesim_msgs.msg import _pose as _pose
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("turtlesim_msgs.msg")
