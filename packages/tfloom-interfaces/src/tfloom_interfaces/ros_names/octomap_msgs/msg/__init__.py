"""The messages of octomap_msgs."""

from tfloom_interfaces.interfaces.octomap_msgs.msg import *
from tfloom_interfaces.interfaces.octomap_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from octomap_msgs.msg import _octomap as _octomap
    from octomap_msgs.msg import _octomap_with_pose as _octomap_with_pose
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("octomap_msgs.msg")
