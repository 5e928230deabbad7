"""The messages of turtlesim."""

from tfloom.interfaces.turtlesim.msg import *
from tfloom.interfaces.turtlesim.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from turtlesim.msg import _color as _color
    from turtlesim.msg import _pose as _pose
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("turtlesim.msg")
