"""The messages of ackermann_msgs."""

from tfloom_interfaces.interfaces.ackermann_msgs.msg import *
from tfloom_interfaces.interfaces.ackermann_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ackermann_msgs.msg import _ackermann_drive as _ackermann_drive
    from ackermann_msgs.msg import _ackermann_drive_stamped as _ackermann_drive_stamped
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("ackermann_msgs.msg")
