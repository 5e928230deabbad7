"""The services of action_msgs."""

from tfloom.interfaces.action_msgs.srv import *
from tfloom.interfaces.action_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from action_msgs.srv import _cancel_goal as _cancel_goal
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("action_msgs.srv")
