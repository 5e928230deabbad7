"""The services of lifecycle_msgs."""

from tfloom.interfaces.lifecycle_msgs.srv import *
from tfloom.interfaces.lifecycle_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from lifecycle_msgs.srv import _change_state as _change_state
    from lifecycle_msgs.srv import _get_available_states as _get_available_states
    from lifecycle_msgs.srv import _get_available_transitions as _get_available_transitions
    from lifecycle_msgs.srv import _get_state as _get_state
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("lifecycle_msgs.srv")
