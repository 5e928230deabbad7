"""The messages of unique_identifier_msgs."""

from tfloom.interfaces.unique_identifier_msgs.msg import *
from tfloom.interfaces.unique_identifier_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from unique_identifier_msgs.msg import _uuid as _uuid
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("unique_identifier_msgs.msg")
