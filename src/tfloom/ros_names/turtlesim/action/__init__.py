"""The actions of turtlesim."""

from tfloom.interfaces.turtlesim.action import *
from tfloom.interfaces.turtlesim.action import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from turtlesim.action import _rotate_absolute as _rotate_absolute
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("turtlesim.action")
