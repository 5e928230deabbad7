"""The actions of example_interfaces."""

from tfloom.interfaces.example_interfaces.action import *
from tfloom.interfaces.example_interfaces.action import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from example_interfaces.action import _fibonacci as _fibonacci
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("example_interfaces.action")
