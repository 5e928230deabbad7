"""The messages of rcl_interfaces."""

from tfloom.interfaces.rcl_interfaces.msg import *
from tfloom.interfaces.rcl_interfaces.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rcl_interfaces.msg import _floating_point_range as _floating_point_range
    from rcl_interfaces.msg import _integer_range as _integer_range
    from rcl_interfaces.msg import _list_parameters_result as _list_parameters_result
    from rcl_interfaces.msg import _log as _log
    from rcl_interfaces.msg import _logger_level as _logger_level
    from rcl_interfaces.msg import _parameter as _parameter
    from rcl_interfaces.msg import _parameter_descriptor as _parameter_descriptor
    from rcl_interfaces.msg import _parameter_event as _parameter_event
    from rcl_interfaces.msg import _parameter_event_descriptors as _parameter_event_descriptors
    from rcl_interfaces.msg import _parameter_type as _parameter_type
    from rcl_interfaces.msg import _parameter_value as _parameter_value
    from rcl_interfaces.msg import _set_logger_levels_result as _set_logger_levels_result
    from rcl_interfaces.msg import _set_parameters_result as _set_parameters_result
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rcl_interfaces.msg")
