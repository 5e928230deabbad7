"""The messages of stereo_msgs."""

from tfloom.interfaces.stereo_msgs.msg import *
from tfloom.interfaces.stereo_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from stereo_msgs.msg import _disparity_image as _disparity_image
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("stereo_msgs.msg")
