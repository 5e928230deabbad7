"""The services of nav_msgs."""

from tfloom.interfaces.nav_msgs.srv import *
from tfloom.interfaces.nav_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from nav_msgs.srv import _get_map as _get_map
    from nav_msgs.srv import _get_plan as _get_plan
    from nav_msgs.srv import _load_map as _load_map
    from nav_msgs.srv import _set_map as _set_map
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("nav_msgs.srv")
