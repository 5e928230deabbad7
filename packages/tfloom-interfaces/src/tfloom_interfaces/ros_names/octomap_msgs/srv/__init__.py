"""The services of octomap_msgs."""

from tfloom_interfaces.interfaces.octomap_msgs.srv import *
from tfloom_interfaces.interfaces.octomap_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from octomap_msgs.srv import _bounding_box_query as _bounding_box_query
    from octomap_msgs.srv import _get_octomap as _get_octomap
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("octomap_msgs.srv")
