"""The messages of builtin_interfaces."""

from tfloom.interfaces.builtin_interfaces.msg import *
from tfloom.interfaces.builtin_interfaces.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from builtin_interfaces.msg import _duration as _duration
    from builtin_interfaces.msg import _time as _time
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("builtin_interfaces.msg")
