"""The services of tf2_msgs."""

from tfloom.interfaces.tf2_msgs.srv import *
from tfloom.interfaces.tf2_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tf2_msgs.srv import _frame_graph as _frame_graph
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("tf2_msgs.srv")
