"""Executors."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.executing.executor import Executor as Executor
from tfloom.node.executing.executor_exceptions import ConditionReachedException as ConditionReachedException
from tfloom.node.executing.executor_exceptions import ShutdownException as ShutdownException
from tfloom.node.executing.executor_exceptions import TimeoutException as TimeoutException
from tfloom.node.executing.executor_exceptions import TimeoutObject as TimeoutObject
from tfloom.node.executing.executors import MultiThreadedExecutor as MultiThreadedExecutor
from tfloom.node.executing.executors import SingleThreadedExecutor as SingleThreadedExecutor
from tfloom.node.executing.executors import WaitableEntityType as WaitableEntityType
from tfloom.node.executing.executors import await_or_execute as await_or_execute
from tfloom.node.executing.executors import get_global_executor as get_global_executor
from tfloom.node.values.exceptions import ExternalShutdownException as ExternalShutdownException

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.clock.clock import Clock as Clock
    from tfloom.node.context.context import Context as Context
    from tfloom.node.context.utilities import get_default_context as get_default_context
    from tfloom.node.context.utilities import timeout_sec_to_nsec as timeout_sec_to_nsec
    from tfloom.node.endpoints.client import Client as Client
    from tfloom.node.endpoints.service import Service as Service
    from tfloom.node.endpoints.subscription import Subscription as Subscription
    from tfloom.node.executing.guard_condition import GuardCondition as GuardCondition
    from tfloom.node.executing.signals import SignalHandlerGuardCondition as SignalHandlerGuardCondition
    from tfloom.node.executing.task import Future as Future
    from tfloom.node.executing.task import Task as Task
    from tfloom.node.executing.timer import Timer as Timer
    from tfloom.node.executing.waitable import NumberOfEntities as NumberOfEntities
    from tfloom.node.executing.waitable import Waitable as Waitable
    from tfloom.node.values.clock_type import ClockType as ClockType
    from tfloom.node.values.exceptions import InvalidHandle as InvalidHandle
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Client="tfloom.node.endpoints.client",
        Clock="tfloom.node.clock.clock",
        ClockType="tfloom.node.values.clock_type",
        Context="tfloom.node.context.context",
        Future="tfloom.node.executing.task",
        GuardCondition="tfloom.node.executing.guard_condition",
        InvalidHandle="tfloom.node.values.exceptions",
        NumberOfEntities="tfloom.node.executing.waitable",
        Service="tfloom.node.endpoints.service",
        SignalHandlerGuardCondition="tfloom.node.executing.signals",
        Subscription="tfloom.node.endpoints.subscription",
        Task="tfloom.node.executing.task",
        Timer="tfloom.node.executing.timer",
        Waitable="tfloom.node.executing.waitable",
        get_default_context="tfloom.node.context.utilities",
        timeout_sec_to_nsec="tfloom.node.context.utilities",
    )
