"""The services that read and set logger levels."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.builtin.logging_service import LoggingService as LoggingService
from tfloom.node.builtin.logging_service import TOPIC_SEPARATOR_STRING as TOPIC_SEPARATOR_STRING

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import LoggerLevel as LoggerLevel
    from tfloom.interfaces.rcl_interfaces.msg import SetLoggerLevelsResult as SetLoggerLevelsResult
    from tfloom.interfaces.rcl_interfaces.srv import GetLoggerLevels as GetLoggerLevels
    from tfloom.interfaces.rcl_interfaces.srv import SetLoggerLevels as SetLoggerLevels
    from tfloom.node.log.logging_severity import LoggingSeverity as LoggingSeverity
    from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        GetLoggerLevels="tfloom.interfaces.rcl_interfaces.srv",
        LoggerLevel="tfloom.interfaces.rcl_interfaces.msg",
        LoggingSeverity="tfloom.node.log.logging_severity",
        SetLoggerLevels="tfloom.interfaces.rcl_interfaces.srv",
        SetLoggerLevelsResult="tfloom.interfaces.rcl_interfaces.msg",
        qos_profile_services_default="tfloom.node.qos.qos",
    )
