"""Executors."""

from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executor_exceptions import (
    ConditionReachedException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
)
from tfloom.node.executing.executors import (
    MultiThreadedExecutor,
    SingleThreadedExecutor,
    WaitableEntityType,
    await_or_execute,
    get_global_executor,
)
from tfloom.node.values.exceptions import ExternalShutdownException

__all__ = [
    "ConditionReachedException",
    "Executor",
    "ExternalShutdownException",
    "MultiThreadedExecutor",
    "ShutdownException",
    "SingleThreadedExecutor",
    "TimeoutException",
    "TimeoutObject",
    "WaitableEntityType",
    "await_or_execute",
    "get_global_executor",
]
