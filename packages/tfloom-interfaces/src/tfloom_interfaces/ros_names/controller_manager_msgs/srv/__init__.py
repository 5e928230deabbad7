"""The services of controller_manager_msgs."""

from tfloom_interfaces.interfaces.controller_manager_msgs.srv import *
from tfloom_interfaces.interfaces.controller_manager_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from controller_manager_msgs.srv import _cleanup_controller as _cleanup_controller
    from controller_manager_msgs.srv import _configure_controller as _configure_controller
    from controller_manager_msgs.srv import _list_controller_types as _list_controller_types
    from controller_manager_msgs.srv import _list_controllers as _list_controllers
    from controller_manager_msgs.srv import _list_hardware_components as _list_hardware_components
    from controller_manager_msgs.srv import _list_hardware_interfaces as _list_hardware_interfaces
    from controller_manager_msgs.srv import _load_controller as _load_controller
    from controller_manager_msgs.srv import _reload_controller_libraries as _reload_controller_libraries
    from controller_manager_msgs.srv import _set_hardware_component_state as _set_hardware_component_state
    from controller_manager_msgs.srv import _switch_controller as _switch_controller
    from controller_manager_msgs.srv import _unload_controller as _unload_controller
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("controller_manager_msgs.srv")
