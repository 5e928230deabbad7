"""The messages of action_msgs."""

from tfloom.interfaces.action_msgs.msg import *
from tfloom.interfaces.action_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from action_msgs.msg import _goal_info as _goal_info
    from action_msgs.msg import _goal_status as _goal_status
    from action_msgs.msg import _goal_status_array as _goal_status_array
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("action_msgs.msg")
