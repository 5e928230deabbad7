"""buffer_server: keep all transforms of the last minutes, and serve lookups of other programs."""

from __future__ import annotations

import math

from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.parameters.exceptions import InvalidParameterValueException
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.values.duration import Duration
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.buffer_server import BufferServer
from tfloom.tf2_ros.transform_listener import TransformListener

DESCRIPTION = (
    "Keep all transforms of the last two minutes (--ros-args -p buffer_size:=120.0 [s]), and serve lookups: "
    "action tf2_buffer_server, tf2_msgs/action/LookupTransform."
)
ACTION = "tf2_buffer_server"
DEFAULT_SIZE_S = 120.0
MAX_DURATION_S = 9e9
"""The longest time that fits into 64 bits of nanoseconds, about [s]."""


class TfBuffer(Node):
    """Subscribes to /tf and /tf_static, and serves the action `tf2_buffer_server`.

    The parameter `buffer_size` is the length of each frame's history [s].

    Raises:
        InvalidParameterValueException: `buffer_size` is not a valid duration.
    """

    def __init__(self) -> None:
        super().__init__("tf_buffer")
        size_s = float(self.declare_parameter("buffer_size", DEFAULT_SIZE_S).value)
        if not (math.isfinite(size_s) and 0.0 <= size_s <= MAX_DURATION_S):
            reason = f"must be a number of seconds from 0 to {MAX_DURATION_S:g}"
            raise InvalidParameterValueException("buffer_size", size_s, reason)
        self.buffer = Buffer(Duration(seconds=size_s))
        self.listener = TransformListener(self.buffer, self)
        self.server = BufferServer(self.buffer, self, ACTION)


def main(args: list[str] | None = None) -> int:
    """Serve until stopped; return the exit code."""
    expect_no_arguments("buffer_server", DESCRIPTION, args)
    return run_program(args, lambda: spin(TfBuffer()))
