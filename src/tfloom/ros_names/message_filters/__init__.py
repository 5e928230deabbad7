"""Synchronize messages of several topics by their stamps."""

from typing import TYPE_CHECKING

from tfloom.node.log.logging_severity import LoggingSeverity as LoggingSeverity
from tfloom.node.values.duration import Duration as Duration
from tfloom.node.values.time import Time as Time
from tfloom.tf2_ros.message_filters import *

if TYPE_CHECKING:
    from tfloom.node.clock.clock import ROSClock as ROSClock
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ROSClock="tfloom.node.clock.clock",
    )
