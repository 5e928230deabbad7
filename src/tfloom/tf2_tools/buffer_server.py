"""buffer_server: keep all transforms of the last minutes, and look them up for other programs."""

from __future__ import annotations

import math
import sys

from tfloom.node import spin
from tfloom.node.duration import Duration
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.node.utilities import remove_ros_args
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.buffer_server import BufferServer
from tfloom.tf2_ros.transform_listener import TransformListener

USAGE = "usage: buffer_server [--ros-args -p buffer_size:=SECONDS]"
ACTION = "tf2_buffer_server"
DEFAULT_SIZE_S = 120.0
LONGEST_S = 9e9
"""The longest time that fits into 64 bits of nanoseconds, about [s]."""


class TfBuffer(Node):
    """Listens to /tf and /tf_static, and serves the action `tf2_buffer_server`.

    The parameter `buffer_size` is how far back each frame's history reaches [s].

    Raises:
        ValueError: `buffer_size` is no length of time.
    """

    def __init__(self) -> None:
        super().__init__("tf_buffer")
        size_s = float(self.declare_parameter("buffer_size", DEFAULT_SIZE_S).value)
        if not (math.isfinite(size_s) and 0.0 <= size_s <= LONGEST_S):
            raise ValueError(
                f"the parameter buffer_size must be a number of seconds from 0 to {LONGEST_S:g}, not {size_s:g}"
            )
        self.buffer = Buffer(Duration(seconds=size_s))
        self.listener = TransformListener(self.buffer, self)
        self.server = BufferServer(self.buffer, self, ACTION)


def main(args: list[str] | None = None) -> int:
    """Serve until stopped; return the exit code."""
    args = sys.argv[1:] if args is None else args
    if words := remove_ros_args(args):
        print(f"buffer_server takes no argument like {words[0]!r}\n{USAGE}", file=sys.stderr)
        return 2
    try:
        return run_program(args, lambda: spin(TfBuffer()))
    except ValueError as error:
        print(f"buffer_server: {error}", file=sys.stderr)
        return 1
