"""Time: a point in time on one clock."""

from tfloom.node.values.clock_type import ClockType as ClockType
from tfloom.node.values.duration import Duration as Duration
from tfloom.node.values.time import *
