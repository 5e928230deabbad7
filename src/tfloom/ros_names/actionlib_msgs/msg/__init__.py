"""The messages of actionlib_msgs."""

from tfloom.interfaces.actionlib_msgs.msg import *
from tfloom.interfaces.actionlib_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from actionlib_msgs.msg import _goal_id as _goal_id
    from actionlib_msgs.msg import _goal_status as _goal_status
    from actionlib_msgs.msg import _goal_status_array as _goal_status_array
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("actionlib_msgs.msg")
