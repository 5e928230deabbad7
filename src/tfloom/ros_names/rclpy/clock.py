"""Clocks."""

from tfloom.node.clock.clock import Clock, JumpHandle, ROSClock
from tfloom.node.clock.time_jump import ClockChange, JumpThreshold, TimeJump
from tfloom.node.values.clock_type import ClockType

__all__ = ["Clock", "ClockChange", "ClockType", "JumpHandle", "JumpThreshold", "ROSClock", "TimeJump"]
