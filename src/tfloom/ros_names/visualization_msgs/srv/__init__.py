"""The services of visualization_msgs."""

from tfloom.interfaces.visualization_msgs.srv import *
from tfloom.interfaces.visualization_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from visualization_msgs.srv import _get_interactive_markers as _get_interactive_markers
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("visualization_msgs.srv")
