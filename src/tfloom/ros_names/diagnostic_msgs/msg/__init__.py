"""The messages of diagnostic_msgs."""

from tfloom.interfaces.diagnostic_msgs.msg import *
from tfloom.interfaces.diagnostic_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from diagnostic_msgs.msg import _diagnostic_array as _diagnostic_array
    from diagnostic_msgs.msg import _diagnostic_status as _diagnostic_status
    from diagnostic_msgs.msg import _key_value as _key_value
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("diagnostic_msgs.msg")
