"""The actions of tf2_msgs."""

from tfloom.interfaces.tf2_msgs.action import *
from tfloom.interfaces.tf2_msgs.action import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tf2_msgs.action import _lookup_transform as _lookup_transform
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("tf2_msgs.action")
