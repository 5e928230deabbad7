"""Simulated time."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.builtin.time_source import CLOCK_TOPIC as CLOCK_TOPIC
from tfloom.node.builtin.time_source import TimeSource as TimeSource
from tfloom.node.builtin.time_source import USE_SIM_TIME_NAME as USE_SIM_TIME_NAME

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult as SetParametersResult
    from tfloom.node.clock.clock import ROSClock as ROSClock
    from tfloom.node.parameters.parameter import Parameter as Parameter
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.qos.qos import ReliabilityPolicy as ReliabilityPolicy
    from tfloom.node.values.clock_type import ClockType as ClockType
    from tfloom.node.values.time import Time as Time
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ClockType="tfloom.node.values.clock_type",
        Parameter="tfloom.node.parameters.parameter",
        QoSProfile="tfloom.node.qos.qos",
        ROSClock="tfloom.node.clock.clock",
        ReliabilityPolicy="tfloom.node.qos.qos",
        SetParametersResult="tfloom.interfaces.rcl_interfaces.msg",
        Time="tfloom.node.values.time",
    )
