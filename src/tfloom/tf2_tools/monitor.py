"""tf2_monitor: the delays and rates of transforms, every ten seconds."""

from __future__ import annotations

import sys
import time
from collections import deque
from collections.abc import Iterable

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.client_library import ok, spin_once
from tfloom.node.context.utilities import remove_ros_args
from tfloom.node.log.logging import get_logger
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.node.qos.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.tf2.errors import TransformException
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener

NODE = "tf2_monitor_main"
USAGE = "TF_Monitor: usage: tf2_monitor framea frameb"
WRONG_USAGE = 255
"""Exit code; the reference returns -1."""
AUTHORITY = "<no authority available>"
"""Shown as the publisher, because messages don't contain its name."""
ROUNDS = 21
ROUND_S = 0.5
"""Results are printed after this many rounds of this length [s]."""
MAX_SAMPLES = 1000
LOW_PASS = 0.01
MIN_SPAN_S = 1e-8
"""The least time over which a rate is computed [s]."""
DEPTH = 100


class Delays:
    """The last thousand delays of a frame or publisher [s]."""

    def __init__(self) -> None:
        self._samples: deque[float] = deque(maxlen=MAX_SAMPLES)

    def add(self, delay_s: float) -> None:
        """Add a delay to those from which the mean is formed."""
        self._samples.append(delay_s)

    @property
    def average_s(self) -> float:
        """The mean of these delays."""
        return sum(self._samples) / len(self._samples)

    @property
    def greatest_s(self) -> float:
        """The greatest; not below 0."""
        return max(0.0, *self._samples)


class NetDelay:
    """Age of a chain's latest transform: a slow average, and the greatest [s]."""

    def __init__(self) -> None:
        self.average_s = 0.0
        self.greatest_s = 0.0
        self._is_empty = True

    def add(self, delay_s: float) -> None:
        """Take in a delay: the first one as the average, each further one with the low-pass's part of it."""
        self.average_s = delay_s if self._is_empty else LOW_PASS * delay_s + (1.0 - LOW_PASS) * self.average_s
        self.greatest_s = max(self.greatest_s, delay_s)
        self._is_empty = False


class Statistics:
    """Statistics of the received transforms, by frame and in all."""

    def __init__(self) -> None:
        self._frames: dict[str, Delays] = {}
        self._all = Delays()
        self._arrivals_s: deque[float] = deque(maxlen=MAX_SAMPLES)

    def add(self, stamps_s: Iterable[tuple[str, float]], now_s: float) -> None:
        """Add a message: child frame and stamp of each of its transforms, and its time of arrival [s since epoch]."""
        delays = [(frame, now_s - stamp_s) for frame, stamp_s in stamps_s]
        for frame, delay_s in delays:
            self._frames.setdefault(frame, Delays()).add(delay_s)
        self._all.add(sum(delay_s for _, delay_s in delays) / max(1, len(delays)))
        self._arrivals_s.append(now_s)

    def text(self, chain: Iterable[str] | None = None) -> str:
        """Return the report on the frames in `chain`, or on all, and on their publishers."""
        frames = self._frames if chain is None else self._frames.keys() & set(chain)
        lines = ["", "Frames:"]
        lines += [
            f"Frame: {frame}, published by {AUTHORITY}, Average Delay: {self._frames[frame].average_s:g}, "
            f"Max Delay: {self._frames[frame].greatest_s:g}"
            for frame in sorted(frames)
        ]
        lines += ["", "All Broadcasters:"]
        if self._arrivals_s:
            span_s = max(MIN_SPAN_S, self._arrivals_s[-1] - self._arrivals_s[0])
            lines.append(
                f"Node: {AUTHORITY} {len(self._arrivals_s) / span_s:g} Hz, Average Delay: {self._all.average_s:g} "
                f"Max Delay: {self._all.greatest_s:g}"
            )
        return "\n".join(lines)


class Monitor(Node):
    """Collects statistics of /tf and /tf_static, of all frames or of the chain between two.

    Args:
        pair: The two frames; None: all.
    """

    def __init__(self, pair: tuple[str, str] | None = None) -> None:
        super().__init__(NODE)
        self._pair = pair
        self._statistics = Statistics()
        self._net = NetDelay()
        self._buffer = Buffer()
        self._listener = TransformListener(self._buffer, self) if pair is not None else None
        static = QoSProfile(history=HistoryPolicy.KEEP_ALL, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(TFMessage, "/tf", self._on_transforms, QoSProfile(depth=DEPTH))
        self.create_subscription(TFMessage, "/tf_static", self._on_transforms, static)

    def _on_transforms(self, message: TFMessage) -> None:
        stamps_s = (
            (transform.child_frame_id, _seconds(transform.header.stamp)) for transform in message.transforms
        )
        self._statistics.add(stamps_s, self._now_s())

    def _now_s(self) -> float:
        return self.get_clock().now().nanoseconds / 1e9

    def run(self, rounds: int = ROUNDS, round_s: float = ROUND_S) -> None:
        """Print the results after each `rounds` rounds of `round_s` until shutdown."""
        if self._pair is not None:
            self._wait_for_chain(*self._pair)
        what = "all frames" if self._pair is None else " -> ".join(self._pair)
        print(f"Gathering data on {what} for 10 seconds...", flush=True)
        while ok():
            for _ in range(rounds):
                self._look()
                self._spin_for(round_s)
            if ok():
                print(self.text(), flush=True)

    def _wait_for_chain(self, frame_a: str, frame_b: str) -> None:
        print(
            f"Waiting for transform chain to become available between {frame_a} and {frame_b} ",
            end="",
            flush=True,
        )
        while ok() and not self._buffer.can_transform(frame_a, frame_b, Time(), Duration(seconds=1.0)):
            print(".", end="", flush=True)
        print(flush=True)

    def _look(self) -> None:
        """Add the present age of the pair's transform, unless it is static and has no stamp."""
        if self._pair is None:
            return
        try:
            stamp_s = self._buffer.get_latest_common_time(*self._pair).nanoseconds / 1e9
        except TransformException:  # there is no chain yet
            return
        self._net.add(self._now_s() - stamp_s if stamp_s else 0.0)

    def _spin_for(self, duration_s: float) -> None:
        end_s = time.monotonic() + duration_s
        while ok() and (left_s := end_s - time.monotonic()) > 0.0:
            spin_once(self, timeout_sec=left_s)

    def text(self) -> str:
        """Return the results so far."""
        if self._pair is None:
            return f"\n\n\nRESULTS: for all Frames\n{self._statistics.text()}"
        chain = self._chain(*self._pair)
        return (
            f"\n\n\nRESULTS: for {' to '.join(self._pair)}\nChain is: {' -> '.join(chain)}\n"
            f"Net delay     avg = {self._net.average_s:g}: max = {self._net.greatest_s:g}\n"
            f"{self._statistics.text(chain)}"
        )

    def _chain(self, frame_a: str, frame_b: str) -> list[str]:
        """Return the frames whose transforms lie between the two: up from the first, then down to the second."""
        try:
            to_b, from_a = self._buffer.branches(frame_b, frame_a, 0)
        except TransformException:
            return []
        return [*from_a, *reversed(to_b)]


def _seconds(stamp: TimeMessage) -> float:
    return stamp.sec + stamp.nanosec / 1e9


def main(args: list[str] | None = None) -> int:
    """Monitor until stopped; return the exit code."""
    args = sys.argv[1:] if args is None else args
    words = remove_ros_args(args)
    if len(words) not in {0, 2}:
        get_logger(NODE).info(USAGE)
        return WRONG_USAGE
    pair = (words[0], words[1]) if words else None
    return run_program(args, lambda: Monitor(pair).run())
