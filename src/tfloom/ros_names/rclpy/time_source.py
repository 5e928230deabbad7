"""Simulated time."""

from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult as SetParametersResult
from tfloom.node.builtin.time_source import *
from tfloom.node.clock.clock import ROSClock as ROSClock
from tfloom.node.parameters.parameter import Parameter as Parameter
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.node.qos.qos import ReliabilityPolicy as ReliabilityPolicy
from tfloom.node.values.clock_type import ClockType as ClockType
from tfloom.node.values.time import Time as Time
