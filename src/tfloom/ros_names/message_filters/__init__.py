"""Synchronize messages of several topics by their stamps."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.message_filters import ApproximateTimeSynchronizer as ApproximateTimeSynchronizer
from tfloom.tf2_ros.message_filters import Cache as Cache
from tfloom.tf2_ros.message_filters import SimpleFilter as SimpleFilter
from tfloom.tf2_ros.message_filters import Subscriber as Subscriber
from tfloom.tf2_ros.message_filters import TimeSynchronizer as TimeSynchronizer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.clock.clock import ROSClock as ROSClock
    from tfloom.node.log.logging_severity import LoggingSeverity as LoggingSeverity
    from tfloom.node.values.duration import Duration as Duration
    from tfloom.node.values.time import Time as Time
    from tfloom.tf2_ros.message_filters import Chain as Chain
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Chain="tfloom.tf2_ros.message_filters",
        Duration="tfloom.node.values.duration",
        LoggingSeverity="tfloom.node.log.logging_severity",
        ROSClock="tfloom.node.clock.clock",
        Time="tfloom.node.values.time",
    )
