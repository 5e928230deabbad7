"""Messages of several topics brought together by their stamps: what message_filters offers."""

from __future__ import annotations

import threading
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence
from itertools import product
from typing import Any

from tfloom.node.duration import Duration
from tfloom.node.time import Time

__all__ = ["ApproximateTimeSynchronizer", "Cache", "SimpleFilter", "Subscriber", "TimeSynchronizer"]

S_TO_NS = 1_000_000_000


class SimpleFilter:
    """Hands messages on to callbacks."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = {}

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:  # noqa: N802, message_filters' name
        """Have `cb(*messages, *args)` called; returns a number for it."""
        number = len(self.callbacks)
        self.callbacks[number] = cb, args
        return number

    def signalMessage(self, *msg: Any) -> None:  # noqa: N802, message_filters' name
        """Call all callbacks."""
        for callback, args in self.callbacks.values():
            callback(*msg, *args)


class Subscriber(SimpleFilter):
    """Hands on the messages of a topic.

    Args:
        args: The node, the type and the topic, and what else `Node.create_subscription` takes; the callback is the
            filter's own, and the history's depth is 10 unless said otherwise.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        self.node, self.type, self.topic, *others = args
        kwargs.setdefault("qos_profile", 10)
        if others:
            kwargs["qos_profile"] = others[0]
        self.sub = self.node.create_subscription(self.type, self.topic, self.callback, **kwargs)

    def callback(self, msg: Any) -> None:
        """Hand a message on."""
        self.signalMessage(msg)

    def getTopic(self) -> str:  # noqa: N802, message_filters' name
        """Return the topic, as it was given."""
        return str(self.topic)

    def __getattr__(self, name: str) -> Any:
        """Give what the subscription has."""
        if name == "sub":
            raise AttributeError(name)
        return getattr(self.sub, name)


class Cache(SimpleFilter):
    """Keeps the last messages in order of time, and hands each on.

    Args:
        f: The filter whose messages to keep; None: those of `add`.
        cache_size: How many.
        allow_headerless: Whether a message without a header gets the time of its arrival.
    """

    def __init__(self, f: Any, cache_size: int = 1, allow_headerless: bool = False) -> None:
        super().__init__()
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Time] = []
        self.cache_size = cache_size
        self.allow_headerless = allow_headerless
        self.connectInput(f)

    def connectInput(self, f: Any) -> None:  # noqa: N802, message_filters' name
        """Take the messages of a filter."""
        if f is not None:
            self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Keep a message, and hand it on."""
        stamp = _stamp_ns(msg, self.allow_headerless)
        if stamp is None:
            return
        place = bisect_right([time.nanoseconds for time in self.cache_times], stamp)
        self.cache_times.insert(place, Time(nanoseconds=stamp))
        self.cache_msgs.insert(place, msg)
        if len(self.cache_msgs) > self.cache_size:
            del self.cache_msgs[0], self.cache_times[0]
        self.signalMessage(msg)

    def getInterval(self, from_stamp: Any, to_stamp: Any) -> list[Any]:  # noqa: N802, message_filters' name
        """Return the messages from one time to another, both included, oldest first."""
        times = [time.nanoseconds for time in self.cache_times]
        return self.cache_msgs[
            bisect_left(times, from_stamp.nanoseconds) : bisect_right(times, to_stamp.nanoseconds)
        ]

    def getElemAfterTime(self, stamp: Any) -> Any:  # noqa: N802, message_filters' name
        """Return the oldest message at a time or after it, or None."""
        place = bisect_left([time.nanoseconds for time in self.cache_times], stamp.nanoseconds)
        return self.cache_msgs[place] if place < len(self.cache_msgs) else None

    def getElemBeforeTime(self, stamp: Any) -> Any:  # noqa: N802, message_filters' name
        """Return the newest message at a time or before it, or None."""
        place = bisect_right([time.nanoseconds for time in self.cache_times], stamp.nanoseconds)
        return self.cache_msgs[place - 1] if place else None

    def getLastestTime(self) -> Time | None:  # noqa: N802, message_filters' name, as it is spelt
        """Return the newest time, or None."""
        return self.cache_times[-1] if self.cache_times else None

    def getOldestTime(self) -> Time | None:  # noqa: N802, message_filters' name
        """Return the oldest time, or None."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:  # noqa: N802, message_filters' name
        """Return the newest message, or None."""
        return self.cache_msgs[-1] if self.cache_msgs else None


class TimeSynchronizer(SimpleFilter):
    """Hands on messages of several filters that have the very same stamp, together.

    Args:
        fs: The filters.
        queue_size: How many messages of each to keep; the oldest go first.
    """

    def __init__(self, fs: Sequence[Any], queue_size: int) -> None:
        super().__init__()
        self.queue_size = queue_size
        self.lock = threading.Lock()
        self.connectInput(fs)

    def connectInput(self, fs: Sequence[Any]) -> None:  # noqa: N802, message_filters' name
        """Take the messages of these filters, in this order."""
        self.queues: list[dict[int, Any]] = [{} for _ in fs]
        self.input_connections = [
            f.registerCallback(self.add, queue, index)
            for index, (f, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:  # noqa: ARG002
        """Keep a message, and hand on what is complete."""
        with self.lock:
            stamp = _stamp_ns(msg, allow_headerless=False)
            if stamp is None:
                return
            _keep(my_queue, stamp, msg, self.queue_size)
            complete = stamp if all(stamp in queue for queue in self.queues) else None
            matched = [] if complete is None else [queue.pop(stamp) for queue in self.queues]
        if matched:
            self.signalMessage(*matched)


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Hands on messages of several filters whose stamps are near each other, together; each message once.

    Args:
        fs: The filters.
        queue_size: How many messages of each to keep.
        slop: By how much the stamps may differ [s].
        allow_headerless: Whether a message without a header gets the time of its arrival.
    """

    def __init__(
        self, fs: Sequence[Any], queue_size: int, slop: float, allow_headerless: bool = False
    ) -> None:
        super().__init__(fs, queue_size)
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        """Keep a message, and hand on the nearest to it of each other filter, if all are near enough."""
        stamp = _stamp_ns(msg, self.allow_headerless)
        if stamp is None:
            return
        with self.lock:
            _keep(my_queue, stamp, msg, self.queue_size)
            index = self.queues.index(my_queue) if my_queue_index is None else my_queue_index
            chosen = self._match(index, stamp)
            matched = [queue.pop(at) for queue, at in zip(self.queues, chosen, strict=True)] if chosen else []
        if matched:
            self.signalMessage(*matched)

    def _match(self, index: int, stamp: int) -> tuple[int, ...] | None:
        slop = self.slop.nanoseconds
        choices = [
            [stamp]
            if other == index
            else sorted((at for at in queue if abs(at - stamp) <= slop), key=lambda at: abs(at - stamp))
            for other, queue in enumerate(self.queues)
        ]
        # The nearest of each first; any two of the set have to be near each other.
        return next((stamps for stamps in product(*choices) if max(stamps) - min(stamps) <= slop), None)


def _keep(queue: dict[int, Any], stamp: int, msg: Any, size: int) -> None:
    queue[stamp] = msg
    while len(queue) > size:
        del queue[min(queue)]


def _stamp_ns(msg: Any, allow_headerless: bool) -> int | None:
    """Return a message's stamp; the time now for one without a header, or None with a warning."""
    header = getattr(msg, "header", None)
    if header is not None and hasattr(header, "stamp"):
        return int(header.stamp.sec) * S_TO_NS + int(header.stamp.nanosec)
    if not allow_headerless:
        from tfloom.node.logging import get_logger

        get_logger("message_filters").warning(
            f"dropped a {type(msg).__name__} without a header: allow_headerless=True gives it the time of its arrival"
        )
        return None
    from tfloom.node.clock import ROSClock

    return ROSClock().now_ns()
