"""The services that read and set logger levels."""

from typing import TYPE_CHECKING

from tfloom.interfaces.rcl_interfaces.msg import LoggerLevel as LoggerLevel
from tfloom.interfaces.rcl_interfaces.msg import SetLoggerLevelsResult as SetLoggerLevelsResult
from tfloom.interfaces.rcl_interfaces.srv import GetLoggerLevels as GetLoggerLevels
from tfloom.interfaces.rcl_interfaces.srv import SetLoggerLevels as SetLoggerLevels
from tfloom.node.builtin.logging_service import *
from tfloom.node.log.logging_severity import LoggingSeverity as LoggingSeverity

if TYPE_CHECKING:
    from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        qos_profile_services_default="tfloom.node.qos.qos",
    )
