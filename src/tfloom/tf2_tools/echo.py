"""tf2_echo: print the transform between two frames repeatedly."""

from __future__ import annotations

import math
import re
import sys
import time
from typing import cast

from tfloom.common.terminal import report
from tfloom.node.client_library import ok
from tfloom.node.context.utilities import remove_ros_args
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.tf2.errors import TransformException
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener
from tfloom.tf2_tools.text import transform_text

USAGE = """\
Usage: tf2_echo source_frame target_frame [echo_rate]

This will echo the transform from the coordinate frame of the source_frame
to the coordinate frame of the target_frame. 
Note: This is the transform to get data from target_frame into the source_frame.
Default echo rate is 1 if echo_rate is not given."""  # noqa: W291  # as the reference prints it

NO_NUMBER = 2
TRAILING_TEXT = 3
"""Exit codes for a rate that is not a number, and for one with text after the number."""
POLL_S = 0.05
"""The longest wait between two checks for shutdown."""

_NUMBER = re.compile(
    r"\s*[-+]?(?:\d+\.?\d*(?:e[-+]?\d+)?|\.\d+(?:e[-+]?\d+)?|inf(?:inity)?|nan)", re.IGNORECASE
)


class RateError(ValueError):
    """The echo rate is invalid."""

    def __init__(self, text: str, exit_code: int) -> None:
        super().__init__(text)
        self.exit_code = exit_code


def parse_rate(text: str) -> float:
    """Return an echo rate [Hz].

    Raises:
        RateError: `text` is not a number, has text after the number, or the number is not above zero.
    """
    match = _NUMBER.match(text)
    if match is None or match.end() < len(text):
        message = f"Failed to convert rate argument '{text}' to a floating-point number"
        raise RateError(message, TRAILING_TEXT if match else NO_NUMBER)
    rate = float(text)
    if not (math.isfinite(rate) and rate > 0.0):
        raise RateError(f"The echo rate has to be above zero, and '{text}' isn't", NO_NUMBER)
    return rate


class Echo:
    """Prints source_from_target from a node's subscriptions to /tf and /tf_static.

    Args:
        node: The node that subscribes, and logs while there is nothing to print.
        source_frame: Frame to express the transform in.
        target_frame: Frame whose pose is printed.
    """

    def __init__(self, node: Node, source_frame: str, target_frame: str) -> None:
        self._node = node
        self._frames = source_frame, target_frame
        self._buffer = Buffer()
        self._listener = TransformListener(self._buffer, node, spin_thread=True)

    def run(self, rate_hz: float) -> None:
        """Wait until the transform is available, then print it at this rate until shutdown."""
        self._wait()
        due = time.monotonic()
        while ok():
            print(self._text(), flush=True)
            due = max(due + 1.0 / rate_hz, time.monotonic())
            while ok() and (left := due - time.monotonic()) > 0.0:
                time.sleep(min(left, POLL_S))

    def _wait(self) -> None:
        source, target = self._frames
        latest = Time()
        while ok():
            answer = self._buffer.can_transform(source, target, latest, return_debug_tuple=True)
            is_available, reason = cast("tuple[bool, str]", answer)
            if is_available:
                return
            self._node.get_logger().info(
                f"Waiting for transform {source} ->  {target}: {reason}", throttle_duration_sec=1.0
            )
            self._buffer.can_transform(source, target, latest, timeout=Duration(seconds=POLL_S))

    def _text(self) -> str:
        try:
            stamped = self._buffer.lookup_transform(*self._frames, Time())
        except TransformException as error:
            now_s = self._node.get_clock().now().nanoseconds / 1e9
            frames = self._buffer.all_frames_as_string()
            return (
                f"Failure at {now_s:.3f}\nException thrown:{error}\nThe current list of frames is:\n{frames}"
            )
        stamp, transform = stamped.header.stamp, stamped.transform
        where, turn = transform.translation, transform.rotation
        return transform_text(
            stamp.sec * 1_000_000_000 + stamp.nanosec,
            (where.x, where.y, where.z),
            (turn.x, turn.y, turn.z, turn.w),
        )


def main(args: list[str] | None = None) -> int:
    """Echo the transform of the command line until stopped; return the exit code."""
    args = sys.argv[1:] if args is None else args
    words = remove_ros_args(args)
    if len(words) not in {2, 3}:
        print(USAGE)
        return 1
    try:
        rate_hz = parse_rate(words[2]) if words[2:] else 1.0
    except RateError as error:
        report(error)
        return error.exit_code
    return run_program(args, lambda: Echo(Node("tf2_echo"), words[0], words[1]).run(rate_hz))
