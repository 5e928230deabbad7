"""A node's health on /diagnostics."""

from tfloom.ros_guard import claim

claim("diagnostic_updater")

from tfloom.node.clock.clock import Clock
from tfloom.node.values.clock_type import ClockType
from tfloom.node.values.time import Time
from tfloom_sensing.diagnosed_publisher import DiagnosedPublisher, HeaderlessTopicDiagnostic, TopicDiagnostic
from tfloom_sensing.diagnostic_status_wrapper import DiagnosticStatus, DiagnosticStatusWrapper, KeyValue
from tfloom_sensing.diagnostic_tasks import CompositeDiagnosticTask, DiagnosticTask, FunctionDiagnosticTask
from tfloom_sensing.diagnostic_updater import DiagnosticArray, DiagnosticTaskVector, Updater
from tfloom_sensing.update_functions import (
    FrequencyStatus,
    FrequencyStatusParam,
    Heartbeat,
    TimeStampStatus,
    TimeStampStatusParam,
)

__all__ = [
    "Clock",
    "ClockType",
    "CompositeDiagnosticTask",
    "DiagnosedPublisher",
    "DiagnosticArray",
    "DiagnosticStatus",
    "DiagnosticStatusWrapper",
    "DiagnosticTask",
    "DiagnosticTaskVector",
    "FrequencyStatus",
    "FrequencyStatusParam",
    "FunctionDiagnosticTask",
    "HeaderlessTopicDiagnostic",
    "Heartbeat",
    "KeyValue",
    "Time",
    "TimeStampStatus",
    "TimeStampStatusParam",
    "TopicDiagnostic",
    "Updater",
]
