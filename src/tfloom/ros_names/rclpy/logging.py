"""Loggers and their levels."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.log.logging import clear_config as clear_config
from tfloom.node.log.logging import get_logger as get_logger
from tfloom.node.log.logging import get_logger_effective_level as get_logger_effective_level
from tfloom.node.log.logging import get_logger_level as get_logger_level
from tfloom.node.log.logging import get_logging_directory as get_logging_directory
from tfloom.node.log.logging import get_logging_severity_from_string as get_logging_severity_from_string
from tfloom.node.log.logging import initialize as initialize
from tfloom.node.log.logging import set_logger_level as set_logger_level
from tfloom.node.log.logging import shutdown as shutdown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.log.logging_severity import LoggingSeverity as LoggingSeverity
    from tfloom.node.log.rcutils_logger import RcutilsLogger as RcutilsLogger
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LoggingSeverity="tfloom.node.log.logging_severity",
        RcutilsLogger="tfloom.node.log.rcutils_logger",
    )
