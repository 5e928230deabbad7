"""The actions of turtlesim_msgs."""

from tfloom.interfaces.turtlesim_msgs.action import *
from tfloom.interfaces.turtlesim_msgs.action import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from turtlesim_msgs.action import _rotate_absolute as _rotate_absolute
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("turtlesim_msgs.action")
