"""Measurements of a topic's rate, bandwidth and delay, for nodes that subscribe themselves."""

from __future__ import annotations

import math
import threading
import time
from collections import deque
from collections.abc import Callable
from itertools import pairwise
from typing import Any

from tfloom.cli.topic.bw import bandwidth_text
from tfloom.cli.topic.rates import spread
from tfloom.node.node import Node
from tfloom.node.values.time import Time

__all__ = ["DEFAULT_WINDOW_SIZE", "ROSTopicBandwidth", "ROSTopicDelay", "ROSTopicHz"]

DEFAULT_WINDOW_SIZE = 10_000
MAX_WINDOW_SIZE = 50_000
"""The window of a negative size."""


class _Arrivals:
    """The newest arrivals of messages on one topic."""

    def __init__(self, size: int) -> None:
        self.stamps_ns: deque[int] = deque(maxlen=size)
        self.last_printed_ns = 0
        """The newest arrival at the last report."""


class _Measurement:
    """What each measurement has: the size of its window, a clock, and a lock."""

    def __init__(self, node: Node, window_size: int) -> None:
        self.window_size = window_size
        self._clock = node.get_clock()
        self.lock = threading.Lock()


class ROSTopicHz(_Measurement):
    """The rate of topics, from the arrivals of their messages. It may be used from several threads.

    Args:
        node: Its clock tells when messages arrive.
        window_size: Number of the newest messages that count; below 0: a large one.
        filter_expr: Says of a message whether it counts; by default all do.
        use_wtime: Whether this machine's time counts in place of the node's.
    """

    def __init__(
        self,
        node: Node,
        window_size: int,
        filter_expr: Callable[[Any], bool] | None = None,
        use_wtime: bool = False,
    ) -> None:
        super().__init__(node, MAX_WINDOW_SIZE if window_size < 0 else max(window_size, 1))
        self.filter_expr = filter_expr
        self.use_wtime = use_wtime
        self._arrivals: dict[str | None, _Arrivals] = {}
        """By topic; guarded by `lock`."""

    def _of(self, topic: str | None) -> _Arrivals:
        return self._arrivals.setdefault(topic, _Arrivals(self.window_size))

    def get_last_printed_tn(self, topic: str | None = None) -> int:
        """Return the newest arrival that `get_hz` has reported [ns]; 0 without one."""
        with self.lock:
            return self._of(topic).last_printed_ns

    def get_times(self, topic: str | None = None) -> list[int]:
        """Return the times between the arrivals in the window [ns]."""
        with self.lock:
            return [later - earlier for earlier, later in pairwise(self._of(topic).stamps_ns)]

    def callback_hz(self, m: Any, topic: str | None = None) -> None:
        """Count a message that has just arrived, as a subscription's callback does."""
        if self.filter_expr is not None and not self.filter_expr(m):
            return
        now_ns = time.time_ns() if self.use_wtime else self._clock.now().nanoseconds
        with self.lock:
            stamps_ns = self._of(topic).stamps_ns
            if stamps_ns and now_ns < stamps_ns[-1]:  # a simulation has started again
                stamps_ns.clear()
            if now_ns or self.use_wtime:  # simulated time is 0 until it is known
                stamps_ns.append(now_ns)

    def get_hz(self, topic: str | None = None) -> tuple[float, float, float, float, int] | None:
        """Return rate [1/ns], least and greatest period and their deviation [ns], and the number of messages.

        Returns:
            None if nothing has arrived since the last call, or one message only.
        """
        with self.lock:
            arrivals = self._of(topic)
            stamps_ns = list(arrivals.stamps_ns)
            if len(stamps_ns) < 2 or stamps_ns[-1] == arrivals.last_printed_ns:
                return None
            arrivals.last_printed_ns = stamps_ns[-1]
        mean, least, greatest, deviation = spread([later - earlier for earlier, later in pairwise(stamps_ns)])
        return 1 / mean if mean > 0 else 0.0, least, greatest, deviation, len(stamps_ns)

    def print_hz(self, topic: str | None = None) -> None:
        """Print the rate, if anything has arrived since the last time."""
        if (measured := self.get_hz(topic)) is not None:
            _print_times(f"average rate: {measured[0] * 1e9:.3f}", *measured[1:])


class ROSTopicBandwidth(_Measurement):
    """The bandwidth of a topic, from its serialized messages. It may be used from several threads.

    Args:
        node: Its clock tells when messages arrive.
        window_size: Number of the newest messages that count.
    """

    def __init__(self, node: Node, window_size: int = 100) -> None:
        super().__init__(node, max(window_size, 1))
        self._samples: deque[tuple[int, int]] = deque(maxlen=self.window_size)
        """Arrival [ns] and size [bytes]; guarded by `lock`."""

    def callback(self, data: bytes) -> None:
        """Count a serialized message that has just arrived, as the callback of a raw subscription does."""
        now_ns = self._clock.now().nanoseconds
        with self.lock:
            if self._samples and now_ns < self._samples[-1][0]:
                self._samples.clear()
            self._samples.append((now_ns, len(data)))

    def get_bw(self) -> tuple[float, int, float, int, int] | None:
        """Return bytes per second, number of messages, and their mean, least and greatest size [bytes].

        Returns:
            None if fewer than two messages have arrived.
        """
        measured = self._measure()
        if measured is None:
            return None
        sizes, duration_s = measured
        per_second = sum(sizes) / duration_s if duration_s > 0 else math.inf
        return per_second, len(sizes), sum(sizes) / len(sizes), min(sizes), max(sizes)

    def print_bw(self) -> None:
        """Print the bandwidth, if two messages have arrived."""
        if (measured := self._measure()) is not None:
            sizes, duration_s = measured
            print(bandwidth_text([float(size) for size in sizes], duration_s))

    def _measure(self) -> tuple[list[int], float] | None:
        """Return the sizes in the window [bytes], and the time since its first arrival [s]; None below two messages."""
        with self.lock:
            samples = list(self._samples)
        if len(samples) < 2:
            return None
        return [size for _, size in samples], (self._clock.now().nanoseconds - samples[0][0]) * 1e-9


class ROSTopicDelay(_Measurement):
    """The delay of a topic's messages: the time of their arrival minus that in their header.

    Args:
        node: Its clock tells when messages arrive.
        window_size: Number of the newest messages that count.
    """

    def __init__(self, node: Node, window_size: int) -> None:
        super().__init__(node, max(window_size, 1))
        self._delays_ns: deque[int] = deque(maxlen=self.window_size)
        """Guarded by `lock`, as is `_is_new`."""
        self._is_new = False

    def callback_delay(self, msg: Any) -> None:
        """Count a message that has just arrived, as a subscription's callback does.

        Raises:
            RuntimeError: it has no header.
        """
        if not hasattr(msg, "header"):
            raise RuntimeError("msg does not have header")
        delay_ns = self._clock.now().nanoseconds - Time.from_msg(msg.header.stamp).nanoseconds
        with self.lock:
            self._delays_ns.append(delay_ns)
            self._is_new = True

    def get_delay(self) -> tuple[float, float, float, float, int] | None:
        """Return mean, least and greatest delay and their deviation [ns], and the number of messages.

        Returns:
            None if nothing has arrived since the last call.
        """
        with self.lock:
            is_new, self._is_new = self._is_new, False
            delays_ns = [float(delay_ns) for delay_ns in self._delays_ns]
        return (*spread(delays_ns), len(delays_ns)) if is_new else None

    def print_delay(self) -> None:
        """Print the delay, if anything has arrived since the last time."""
        if (measured := self.get_delay()) is not None:
            _print_times(f"average delay: {measured[0] * 1e-9:.3f}", *measured[1:])


def _print_times(average: str, least: float, greatest: float, deviation: float, number: int) -> None:
    """Print a line with the average, and one with the extremes and the spread of times [ns]."""
    print(
        f"{average}\n\tmin: {least * 1e-9:.3f}s max: {greatest * 1e-9:.3f}s "
        f"std dev: {deviation * 1e-9:.5f}s window: {number}"
    )
