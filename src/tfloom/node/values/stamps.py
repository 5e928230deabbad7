"""Stamps of messages that the node itself publishes."""

from __future__ import annotations

from tfloom.node.values.constants import S_TO_NS
from tfloom.node.values.exceptions import RCLError
from tfloom.rmw.machine_clock import describe_machine_clock

__all__ = ["check_fits_stamp"]

MIN_STAMP_NS = -(2**31) * S_TO_NS
MAX_STAMP_NS = 2**31 * S_TO_NS - 1
"""The earliest and the latest time that a `builtin_interfaces/msg/Time` can hold: its seconds are an int32."""


def check_fits_stamp(time_ns: int) -> None:
    """Raise an error that names the machine's clock if its time doesn't fit into a message.

    Raises:
        RCLError: it doesn't.
    """
    if MIN_STAMP_NS <= time_ns <= MAX_STAMP_NS:
        return
    raise RCLError(
        f"{describe_machine_clock(time_ns)}, and messages of ROS 2 hold times from 1901 to 19 January 2038 alone. Set "
        "the clock to the present date"
    )
