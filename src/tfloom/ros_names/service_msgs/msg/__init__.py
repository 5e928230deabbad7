"""The messages of service_msgs."""

from tfloom.interfaces.service_msgs.msg import *
from tfloom.interfaces.service_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from service_msgs.msg import _service_event_info as _service_event_info
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("service_msgs.msg")
