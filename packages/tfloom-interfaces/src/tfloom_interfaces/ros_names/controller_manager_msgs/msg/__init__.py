"""The messages of controller_manager_msgs."""

from tfloom_interfaces.interfaces.controller_manager_msgs.msg import *
from tfloom_interfaces.interfaces.controller_manager_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from controller_manager_msgs.msg import _chain_connection as _chain_connection
    from controller_manager_msgs.msg import _controller_manager_activity as _controller_manager_activity
    from controller_manager_msgs.msg import _controller_state as _controller_state
    from controller_manager_msgs.msg import _hardware_component_state as _hardware_component_state
    from controller_manager_msgs.msg import _hardware_interface as _hardware_interface
    from controller_manager_msgs.msg import _named_lifecycle_state as _named_lifecycle_state
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("controller_manager_msgs.msg")
