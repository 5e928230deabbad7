"""The messages of lifecycle_msgs."""

from tfloom.interfaces.lifecycle_msgs.msg import *
from tfloom.interfaces.lifecycle_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from lifecycle_msgs.msg import _state as _state
    from lifecycle_msgs.msg import _transition as _transition
    from lifecycle_msgs.msg import _transition_description as _transition_description
    from lifecycle_msgs.msg import _transition_event as _transition_event
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("lifecycle_msgs.msg")
