"""The services of rcl_interfaces."""

from tfloom.interfaces.rcl_interfaces.srv import *
from tfloom.interfaces.rcl_interfaces.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rcl_interfaces.srv import _describe_parameters as _describe_parameters
    from rcl_interfaces.srv import _get_logger_levels as _get_logger_levels
    from rcl_interfaces.srv import _get_parameter_types as _get_parameter_types
    from rcl_interfaces.srv import _get_parameters as _get_parameters
    from rcl_interfaces.srv import _list_parameters as _list_parameters
    from rcl_interfaces.srv import _set_logger_levels as _set_logger_levels
    from rcl_interfaces.srv import _set_parameters as _set_parameters
    from rcl_interfaces.srv import _set_parameters_atomically as _set_parameters_atomically
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rcl_interfaces.srv")
