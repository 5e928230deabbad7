"""The actions of action_tutorials_interfaces."""

from tfloom_interfaces.interfaces.action_tutorials_interfaces.action import *
from tfloom_interfaces.interfaces.action_tutorials_interfaces.action import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from action_tutorials_interfaces.action import _fibonacci as _fibonacci
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("action_tutorials_interfaces.action")
