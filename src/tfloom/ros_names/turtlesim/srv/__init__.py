"""The services of turtlesim."""

from tfloom.interfaces.turtlesim.srv import *
from tfloom.interfaces.turtlesim.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from turtlesim.srv import _kill as _kill
    from turtlesim.srv import _set_pen as _set_pen
    from turtlesim.srv import _spawn as _spawn
    from turtlesim.srv import _teleport_absolute as _teleport_absolute
    from turtlesim.srv import _teleport_relative as _teleport_relative
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("turtlesim.srv")
