"""Synchronization of messages of several topics by their stamps, with message_filters' interface.

Where simulated time jumps backward, as when a recording begins again, filters forget their messages, whose stamps are
now in the future. A `Subscriber` learns of the jump from its node's clock, and tells the filters that its messages go
to; so filters need no node, and may be connected and removed at any time.
"""

from __future__ import annotations

import reprlib
import threading
import weakref
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from heapq import heappop, heappush
from itertools import count, product
from operator import attrgetter
from time import monotonic
from typing import TYPE_CHECKING, Any

from tfloom.common.text import given_text
from tfloom.node.clock.time_jump import ClockChange, JumpThreshold
from tfloom.node.values.callback_errors import call_all
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import ClockType, Time
from tfloom.node.values.wrong_arguments import node_error, not_callable
from tfloom.ros_imports import ros_distro
from tfloom.ros_imports.ros_distro import warn_if_removed
from tfloom.tf2_ros.buffer_core import time_ns

if TYPE_CHECKING:
    from tfloom.node.clock.clock import Clock
    from tfloom.node.clock.time_jump import TimeJump

__all__ = [
    "ApproximateTimeSynchronizer",
    "Cache",
    "Chain",
    "JumpBack",
    "SimpleFilter",
    "Subscriber",
    "TimeSequencer",
    "TimeSynchronizer",
]

BACKWARD = JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-1), on_clock_change=True)
MAX_MARGIN_NS = 1_000_000_000
"""How long messages from before a jump are ignored, and how near their stamps are to the old time [ns]."""


class SimpleFilter:
    """Base of filters: calls callbacks with messages."""

    _clock: Clock | None = None
    """The clock for the arrival time of messages without a header; None: the system's clock."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = {}
        """Changed by one call at a time and copied by one, because messages come on other threads."""
        self._numbers = count()

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:
        """Register `cb(*messages, *args)` and return its number; TypeError if it can't be called."""
        if not callable(cb):
            raise TypeError(f"registerCallback() needs a callback, {not_callable(cb)}")
        number = next(self._numbers)
        self.callbacks[number] = cb, args
        return number

    def unregisterCallback(self, conn: int) -> None:
        """Remove a callback, by its number."""
        self.callbacks.pop(conn, None)

    def signalMessage(self, *msg: Any) -> None:
        """Call all callbacks; if one raises, the others first."""
        call_all([partial(callback, *msg, *args) for callback, args in list(self.callbacks.values())])

    def clear_after_jump(self, jump: JumpBack) -> None:
        """Forget the messages from before a jump of time, here and in all filters that this one's messages go to."""
        if jump.reaches(self):
            for filter_ in self._outputs():
                filter_.clear_after_jump(jump)

    def _outputs(self) -> list[Any]:
        """Return the filters that messages go to from here."""
        callbacks = [callback for callback, _ in list(self.callbacks.values())]
        owners = [getattr(getattr(callback, "func", callback), "__self__", None) for callback in callbacks]
        return [owner for owner in owners if hasattr(owner, "clear_after_jump")]


class JumpBack:
    """A jump of time on its way through filters.

    Args:
        clock: The clock, after it.
        jump_ns: The jump, which is negative; 0: the clock has another source now.
    """

    def __init__(self, clock: Clock, jump_ns: int) -> None:
        # Messages that were sent before the jump may still arrive for a short time.
        margin_ns = min(-jump_ns // 2, MAX_MARGIN_NS)
        self._clock = clock
        self._ignored_from_ns = clock.now_ns() - jump_ns - margin_ns
        self._until_s = monotonic() + margin_ns / 1e9
        self._reached: set[int] = set()

    def reaches(self, filter_: object) -> bool:
        """Return whether a filter learns of it for the first time: there may be several ways to it."""
        number = id(filter_)
        is_first = number not in self._reached
        self._reached.add(number)
        return is_first

    def has_overtaken(self, stamp_ns: int) -> bool:
        """Return whether a message that has arrived after the jump was sent before it."""
        start_ns = self._ignored_from_ns
        return stamp_ns >= start_ns and monotonic() < self._until_s and self._clock.now_ns() < start_ns


def clear_with(clock: Clock, filter_: SimpleFilter) -> None:
    """Have a filter, and those that its messages go to, forget their messages when a clock jumps backward."""
    alive = weakref.ref(filter_)  # because the clock outlives it

    def on_jump(jump: TimeJump) -> None:
        filter_ = alive()
        if filter_ is not None:
            is_other_source = jump.clock_change != ClockChange.ROS_TIME_NO_CHANGE
            filter_.clear_after_jump(JumpBack(clock, 0 if is_other_source else jump.delta.nanoseconds))

    handle = clock.create_jump_callback(BACKWARD, post_callback=on_jump)
    weakref.finalize(filter_, handle.unregister)


class Subscriber(SimpleFilter):
    """Passes on the messages of a topic.

    Args:
        args: Node, type and topic, and the other arguments of `Node.create_subscription` but the callback; the
            history's default depth is 10.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        if len(args) < 3:
            raise TypeError(f"Subscriber needs a node, a type and a topic, got {len(args)} arguments")
        self.node, self.type, self.topic, *others = args
        if (error := node_error("Subscriber", self.node)) is not None:
            raise error
        kwargs.setdefault("qos_profile", 10)
        if others:
            kwargs["qos_profile"] = others[0]
        self._clock = self.node.get_clock()
        clear_with(self._clock, self)
        self.sub = self.node.create_subscription(self.type, self.topic, self.callback, **kwargs)

    def callback(self, msg: Any) -> None:
        """Pass a message on."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """Return the topic's name as given."""
        return str(self.topic)

    def __getattr__(self, name: str) -> Any:
        """Return an attribute of the subscription."""
        if name == "sub":
            raise AttributeError(name)
        return getattr(self.sub, name)


class Cache(SimpleFilter):
    """Keeps the last messages in order of time, and passes each on.

    Args:
        f: The input filter; None: messages come from `add` alone.
        cache_size: Most messages to keep.
        allow_headerless: Whether a message without a header is stamped with its time of arrival, by the clock of the
            subscriber's node.
    """

    def __init__(self, f: Any, cache_size: int = 1, allow_headerless: bool = False) -> None:
        super().__init__()
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Time] = []
        self._lock = threading.Lock()
        """Guards both lists, between messages, jumps of time and questions."""
        self._jump: JumpBack | None = None
        self.cache_size = cache_size
        self.allow_headerless = allow_headerless
        self.connectInput(f)

    def connectInput(self, f: Any) -> None:
        """Connect to an input filter."""
        if f is not None:
            self._clock = getattr(f, "_clock", None)
            self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Keep a message, and pass it on."""
        stamp = _stamp(msg, self.allow_headerless, self._clock)
        if stamp is None:
            return
        if not hasattr(stamp, "nanoseconds"):
            stamp = Time(nanoseconds=time_ns(stamp), clock_type=ClockType.ROS_TIME)
        with self._lock:
            if self._jump is not None and self._jump.has_overtaken(stamp.nanoseconds):
                return
            place = bisect_right([time.nanoseconds for time in self.cache_times], stamp.nanoseconds)
            self.cache_times.insert(place, stamp)
            self.cache_msgs.insert(place, msg)
            if len(self.cache_msgs) > self.cache_size:
                del self.cache_msgs[0], self.cache_times[0]
        self.signalMessage(msg)

    def clear_after_jump(self, jump: JumpBack) -> None:
        """Forget all messages, and those that are sent before the jump and arrive now; see `SimpleFilter`."""
        with self._lock:
            self._jump = jump
            self.cache_msgs.clear()
            self.cache_times.clear()
        super().clear_after_jump(jump)

    def _kept(self) -> tuple[list[int], list[Any]]:
        """Return the times [ns] and the messages, which belong together."""
        with self._lock:
            times, messages = self.cache_times.copy(), self.cache_msgs.copy()
        return [time.nanoseconds for time in times], messages

    def getInterval(self, from_stamp: Any, to_stamp: Any) -> list[Any]:
        """Return the messages from one time to another, both included, oldest first."""
        times, messages = self._kept()
        return messages[
            bisect_left(times, from_stamp.nanoseconds) : bisect_right(times, to_stamp.nanoseconds)
        ]

    def getElemAfterTime(self, stamp: Any) -> Any:
        """Return the oldest message at a time or after it, or None."""
        times, messages = self._kept()
        place = bisect_left(times, stamp.nanoseconds)
        return messages[place] if place < len(messages) else None

    def getElemBeforeTime(self, stamp: Any) -> Any:
        """Return the newest message at a time or before it, or None."""
        times, messages = self._kept()
        place = bisect_right(times, stamp.nanoseconds)
        return messages[place - 1] if place else None

    def getLatestTime(self) -> Time | None:
        """Return the newest time, or None."""
        with self._lock:
            return self.cache_times[-1] if self.cache_times else None

    def getLastestTime(self) -> Time | None:
        """Return the newest time, or None; from Kilted on, warn that the name is deprecated."""
        warn_if_removed("message_filters.Cache.getLastestTime")
        return self.getLatestTime()

    def getOldestTime(self) -> Time | None:
        """Return the oldest time, or None."""
        with self._lock:
            return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        """Return the newest message, or None."""
        with self._lock:
            return self.cache_msgs[-1] if self.cache_msgs else None


class Chain(SimpleFilter):
    """A sequence of filters: messages enter the first and leave the last.

    Args:
        message_filter: The input filter; None: messages come from `add` alone.
    """

    def __init__(self, message_filter: Any = None) -> None:
        super().__init__()
        self.incoming_connection: int | None = None
        self._filters: dict[int, Any] = {}
        self._output: int | None = None
        if message_filter is not None:
            self.connectInput(message_filter)

    def connectInput(self, message_filter: Any) -> None:
        """Connect to an input filter.

        Raises:
            RuntimeError: the chain is connected to another filter.
        """
        if self.incoming_connection is not None:
            raise RuntimeError("Already connected")
        self._clock = getattr(message_filter, "_clock", None)
        self.incoming_connection = message_filter.registerCallback(self.add)

    def add(self, message: Any) -> None:
        """Add a message to the first filter; without filters, pass it on at once."""
        if self._filters:
            self._filters[0].add(message)
        else:
            self.signalMessage(message)

    def _outputs(self) -> list[SimpleFilter]:
        """Return the chain's own filters, and those that messages go to from the last."""
        return [
            *(f for f in list(self._filters.values()) if isinstance(f, SimpleFilter)),
            *super()._outputs(),
        ]

    def addFilter(self, message_filter: Any) -> None:
        """Append a filter, which has `add` and `registerCallback`."""
        number = len(self._filters)
        if number > 0:
            last = self._filters[number - 1]
            last.callbacks.pop(self._output)
            last.registerCallback(message_filter.add)
        self._filters[number] = message_filter
        self._output = message_filter.registerCallback(self.signalMessage)

    def getFilter(self, index: int) -> Any:
        """Return a filter by its index, from 0; KeyError if there is none."""
        return self._filters[index]


class TimeSequencer(SimpleFilter):
    """Passes on messages in the order of their stamps, each when its stamp is older than a delay.

    A message that comes after one with a later stamp was passed on is dropped. The time is that of the node's clock.

    Args:
        input_filter: The input filter; None: messages come from `add` alone.
        delay: How old a stamp must be, a Duration or seconds. Longer than messages are late.
        update_rate: Time between two looks at the waiting messages, a Duration or seconds.
        queue_size: Most messages that wait; of more, the oldest is dropped.
        node: The node whose clock counts and whose executor calls the callbacks.
        msg_stamp_attr: Attributes from a message to its stamp, with dots between.

    Raises:
        TypeError: `node` is not a node.
        ValueError: `queue_size` is below 1, `delay` is negative, or `update_rate` is not above zero.
    """

    def __init__(
        self,
        input_filter: Any,
        delay: Duration | float,
        update_rate: Duration | float,
        queue_size: int,
        node: Any,
        msg_stamp_attr: str = "header.stamp",
    ) -> None:
        super().__init__()
        if (error := node_error("TimeSequencer", node)) is not None:
            raise error
        self._delay_ns, period_ns = _nanoseconds(delay), _nanoseconds(update_rate)
        if queue_size < 1 or self._delay_ns < 0 or period_ns <= 0:
            raise ValueError(
                "TimeSequencer needs a queue size of 1 or more, a delay that isn't negative and an update rate above "
                f"zero, got {queue_size}, {self._delay_ns / 1e9:g} s and {period_ns / 1e9:g} s"
            )
        self.queue_size = queue_size
        self._clock = node.get_clock()
        self._stamp_of = attrgetter(msg_stamp_attr)
        self._lock = threading.Lock()
        """Guards the members below, between messages, looks and jumps of time."""
        self._waiting: list[tuple[int, int, Any]] = []
        """A heap of stamps [ns], numbers in order of arrival, and messages."""
        self._arrivals = count()
        self._last_ns: int | None = None
        """Stamp of the last message that was passed on."""
        self._input: Any = None
        self.incoming_connection: Any = None
        self._jump: JumpBack | None = None
        # By a clock that can't jump or stand still: what is due depends on the node's.
        from tfloom.node.clock.clock import Clock

        self._timer = node.create_timer(
            period_ns / 1e9, self._pass_on_due, clock=Clock(clock_type=ClockType.STEADY_TIME)
        )
        clear_with(node.get_clock(), self)
        if input_filter is not None:
            self.connectInput(input_filter)

    def connectInput(self, input_filter: Any) -> None:
        """Connect to an input filter, in place of the last one."""
        if self._input is not None:
            self._input.unregisterCallback(self.incoming_connection)
        self._input = input_filter
        self.incoming_connection = input_filter.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Keep a message until it is due."""
        stamp_ns = time_ns(self._stamp_of(msg))
        with self._lock:
            if self._last_ns is not None and stamp_ns < self._last_ns:
                return
            if self._jump is not None and self._jump.has_overtaken(stamp_ns):
                return
            heappush(self._waiting, (stamp_ns, next(self._arrivals), msg))
            if len(self._waiting) > self.queue_size:
                heappop(self._waiting)

    def _pass_on_due(self) -> None:
        # One at a time and outside the lock, because a callback may add messages.
        while (message := self._take_due()) is not None:
            self.signalMessage(message)

    def _take_due(self) -> Any:
        """Remove and return the message with the earliest stamp if it is due, or None."""
        clock = self._clock
        with self._lock:
            if clock is None or not self._waiting or self._waiting[0][0] > clock.now_ns() - self._delay_ns:
                return None
            self._last_ns, _, message = heappop(self._waiting)
            return message

    def clear_after_jump(self, jump: JumpBack) -> None:
        """Forget all messages, and those that are sent before the jump and arrive now; see `SimpleFilter`."""
        with self._lock:
            self._jump = jump
            self._last_ns = None
            self._waiting.clear()
        super().clear_after_jump(jump)


def _nanoseconds(time: Duration | float) -> int:
    return time.nanoseconds if isinstance(time, Duration) else round(time * 1e9)


class TimeSynchronizer(SimpleFilter):
    """Passes on messages of several filters together, if they have exactly the same stamp.

    Args:
        fs: The filters.
        queue_size: Most messages of each to keep; the oldest are dropped.
    """

    allow_headerless = False
    """Whether a message without a header is stamped with its time of arrival."""
    sync_arrival_time = False
    """Whether each message is."""

    def __init__(self, fs: Sequence[Any], queue_size: int) -> None:
        if (error := _filters_error(fs)) is not None:
            raise error
        if not hasattr(queue_size, "__float__"):
            raise TypeError(
                f"{type(self).__name__} needs a queue size, as 10, got {reprlib.repr(queue_size)} of class "
                f"{type(queue_size).__name__}"
            )
        super().__init__()
        self.queue_size = queue_size
        self.lock = threading.Lock()
        self._jump: JumpBack | None = None
        self.connectInput(fs)

    def connectInput(self, fs: Sequence[Any]) -> None:
        """Connect to these filters, in this order."""
        self.queues: list[dict[int, Any]] = [{} for _ in fs]
        clocks = (getattr(f, "_clock", None) for f in fs)
        self._clock = next((clock for clock in clocks if clock is not None), None)
        self.input_connections = [
            f.registerCallback(self.add, queue, index)
            for index, (f, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        """Keep a message, and pass it on with those of the other filters that match it, if all have one."""
        stamp = _stamp(msg, self.allow_headerless, self._clock, by_arrival=self.sync_arrival_time)
        if stamp is None:
            return
        at = time_ns(stamp)
        sent_ns = at
        if my_queue_index is not None:
            at += self._offset_ns(my_queue_index)
        # Choose and remove under the lock, because other filters add messages on other threads, and a message must be
        # in one set only. Call the callbacks after it, because they may add messages.
        with self.lock:
            if self._jump is not None and self._jump.has_overtaken(sent_ns):
                return
            my_queue[at] = msg
            while len(my_queue) > self.queue_size:
                del my_queue[min(my_queue)]
            # A message older than all of a full queue is not kept, so it may be gone already.
            chosen = self._match(my_queue, at) if at in my_queue else None
            matched = [queue.pop(at) for queue, at in zip(self.queues, chosen, strict=True)] if chosen else []
        if matched:
            self.signalMessage(*matched)

    def clear_after_jump(self, jump: JumpBack) -> None:
        """Forget all messages, and those that are sent before the jump and arrive now; see `SimpleFilter`."""
        with self.lock:
            self._jump = jump
            for queue in self.queues:
                queue.clear()
        super().clear_after_jump(jump)

    def _offset_ns(self, index: int) -> int:
        """Return what is added to the stamps of a queue before they are compared [ns]."""
        return 0

    def _match(self, own: dict[int, Any], stamp: int) -> tuple[int, ...] | None:
        """Return the stamps in the queues of a set with a message of the queue `own`; None if there is no such set."""
        return (stamp,) * len(self.queues) if all(stamp in queue for queue in self.queues) else None


def _filters_error(filters: Any) -> TypeError | AttributeError | None:
    """Return the error of what a synchronizer got in place of filters, or None if it got some."""
    meant = "write [Subscriber(node, Image, 'image'), …]"
    if not isinstance(filters, Iterable):
        given = given_text(filters)
        return TypeError(f"a synchronizer needs a list of filters, got {given}: {meant}")
    for given_filter in filters:
        if not hasattr(given_filter, "registerCallback"):
            given = given_text(given_filter)
            return AttributeError(
                f"a synchronizer needs filters, which have registerCallback, got {given}: {meant}"
            )
    return None


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Passes on messages of several filters together, if their stamps are near each other; each message once.

    Args:
        fs: The filters.
        queue_size: Most messages of each to keep.
        slop: Upper limit for the difference of stamps, exclusive [s]; 0: equal stamps only.
        allow_headerless: Whether a message without a header is stamped with its time of arrival, by the clock of the
            subscribers' node. From Kilted on, `queue_offset` is before it in the order of arguments.
        queue_offset: What is added to the stamps of each filter's messages before they are compared [ns], a number for
            each filter; False: nothing.
        sync_arrival_time: Whether each message counts by its time of arrival.
    """

    def __init__(
        self,
        fs: Sequence[Any],
        queue_size: int,
        slop: float,
        allow_headerless: bool = False,
        *,
        queue_offset: Sequence[int] | bool = False,
        sync_arrival_time: bool = False,
    ) -> None:
        self.queue_offset: Sequence[int] = ()
        super().__init__(fs, queue_size)
        if (error := _offset_error(queue_offset, len(self.queues))) is not None:
            raise error
        self.queue_offset = () if isinstance(queue_offset, bool) else tuple(queue_offset)
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless
        self.sync_arrival_time = sync_arrival_time

    def _offset_ns(self, index: int) -> int:
        return self.queue_offset[index] if self.queue_offset else 0

    def _match(self, own: dict[int, Any], stamp: int) -> tuple[int, ...] | None:
        slop = self.slop.nanoseconds or 1
        choices = [
            [stamp]
            if queue is own
            else sorted((at for at in queue if abs(at - stamp) < slop), key=lambda at: abs(at - stamp))
            for queue in self.queues
        ]
        # The nearest of each first; any two of a set must be near each other.
        return next((stamps for stamps in product(*choices) if max(stamps) - min(stamps) < slop), None)


def _offset_error(offsets: Any, count: int) -> TypeError | ValueError | None:
    """Return the error of what was given as the offsets of so many filters, or None if they can be used."""
    if offsets is True:
        return ValueError(
            "queue_offset=True says nothing: from Kilted on, the fourth argument is a list of nanoseconds; for that of "
            "Jazzy write allow_headerless=True"
        )
    if offsets is False:
        return None
    if not isinstance(offsets, Iterable) or not all(isinstance(offset, int) for offset in offsets):
        return TypeError(f"queue_offset must be a list of int [ns], got {given_text(offsets)}")
    if len(list(offsets)) != count:
        return ValueError(
            f"queue_offset needs a number for each of {count} filters, got {len(list(offsets))}"
        )
    return None


_init_by_jazzy = ApproximateTimeSynchronizer.__init__


def _init_since_kilted(
    self: ApproximateTimeSynchronizer,
    fs: Sequence[Any],
    queue_size: int,
    slop: float,
    queue_offset: Sequence[int] | bool = False,
    allow_headerless: bool = False,
    sync_arrival_time: bool = False,
) -> None:
    _init_by_jazzy(
        self,
        fs,
        queue_size,
        slop,
        allow_headerless,
        queue_offset=queue_offset,
        sync_arrival_time=sync_arrival_time,
    )


if ros_distro.FOURTH_OF_APPROXIMATE == "queue_offset":
    ApproximateTimeSynchronizer.__init__ = _init_since_kilted  # type: ignore[assignment,method-assign]


def _stamp(msg: Any, allow_headerless: bool, clock: Clock | None, *, by_arrival: bool = False) -> Any:
    """Return a message's stamp; for one without a header, the present time, or None with a warning."""
    stamp = None if by_arrival else getattr(getattr(msg, "header", None), "stamp", None)
    if stamp is not None:
        return stamp
    if not allow_headerless and not by_arrival:
        from tfloom.node.log.logging import get_logger

        get_logger("message_filters").warning(
            f"dropped a {type(msg).__name__} without a header: allow_headerless=True stamps it with its time of arrival"
        )
        return None
    from tfloom.node.clock.clock import Clock

    return (clock or Clock(clock_type=ClockType.ROS_TIME)).now()
