"""A message filter of several inputs that passes on all messages, in the order of their stamps."""

from __future__ import annotations

import threading
from bisect import insort
from collections.abc import Callable, Sequence
from itertools import count
from typing import Any, NamedTuple

from tfloom.node.clock.clock import Clock
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import ClockType
from tfloom.node.values.wrong_arguments import node_error
from tfloom.tf2_ros.buffer_core import time_ns
from tfloom.tf2_ros.message_filters import JumpBack, SimpleFilter

__all__ = ["InputAligner", "QueueStatus"]


class QueueStatus(NamedTuple):
    """What has become of the messages of an input."""

    active: bool
    """Whether messages of other inputs wait for its next one."""
    queue_size: int
    """Number of messages that wait."""
    msgs_processed: int
    """Number of messages that were passed on."""
    msgs_dropped: int
    """Number of messages that came after one with a later stamp was passed on."""


class _Input:
    """The waiting messages of one input, and whose turn it is."""

    def __init__(self) -> None:
        self.waiting: list[tuple[int, int, Any]] = []
        """Stamps [ns], numbers in order of arrival, and messages, sorted."""
        self.period_ns = 0
        self.expected_ns: int | None = None
        """The least stamp that its next message may have [ns]; None: nothing waits for it."""
        self.processed = 0
        self.dropped = 0
        self.signal = SimpleFilter()


class InputAligner:
    """Passes on the messages of several filters in the order of their stamps, each to the callbacks of its own input.

    A message waits until no other input can have one with an earlier stamp: until each has a later one, or its period
    says so. An input without messages is left out of this before its first one, and once the others are ahead of it by
    the timeout. Messages are passed on by `dispatchMessages`, which a timer calls after `setupDispatchTimer`.

    Args:
        timeout: How much later than the next message of an input those of others may be, by their stamps.
        filters: The inputs, which `connectInput` takes, too.
    """

    def __init__(self, timeout: Duration, filters: Sequence[Any] | None = None) -> None:
        self._timeout_ns = timeout.nanoseconds
        self._name = ""
        self._lock = threading.Lock()
        """Guards the inputs' messages and the members below."""
        self._inputs: list[_Input] = []
        self._connections: list[tuple[Any, Any]] = []
        self._arrivals = count()
        self._newest_ns: int | None = None
        self._last_ns: int | None = None
        """Stamp of the last message that was passed on [ns]."""
        self._jump: JumpBack | None = None
        self._is_dispatching = False
        self._is_asked = False
        """Whether `dispatchMessages` was called while it was running."""
        if filters is not None:
            self.connectInput(filters)

    def connectInput(self, filters: Sequence[Any]) -> None:
        """Connect to filters, in place of those before, with their messages and callbacks."""
        self.disconnectAll()
        with self._lock:
            self._inputs = [_Input() for _ in filters]
            self._newest_ns = self._last_ns = None
        self._connections = [
            (input_filter, input_filter.registerCallback(self.add, index))
            for index, input_filter in enumerate(filters)
        ]

    def disconnectAll(self) -> None:
        """Receive nothing more from the filters; what waits is kept."""
        connections, self._connections = self._connections, []
        for input_filter, connection in connections:
            input_filter.unregisterCallback(connection)

    def registerCallback(self, index: int, callback: Callable[..., Any], *args: Any) -> int:
        """Register `callback(message, *args)` for the messages of an input, and return its number.

        Raises:
            IndexError: there is no such input.
            TypeError: it can't be called.
        """
        return self._input(index).signal.registerCallback(callback, *args)

    def setInputPeriod(self, index: int, period: Duration) -> None:
        """Set the least time between two stamps of an input, by which others need not wait for its next message.

        Raises:
            IndexError: there is no such input.
        """
        chosen = self._input(index)
        with self._lock:
            chosen.period_ns = period.nanoseconds

    def setupDispatchTimer(self, node: Any, update_rate: Duration) -> None:
        """Call `dispatchMessages` at intervals, on the executor of a node.

        Raises:
            TypeError: `node` is not a node.
        """
        if (error := node_error("setupDispatchTimer", node)) is not None:
            raise error
        # By a clock that can't jump or stand still, as a simulated one does.
        clock = Clock(clock_type=ClockType.STEADY_TIME)
        self._timer = node.create_timer(update_rate.nanoseconds / 1e9, self.dispatchMessages, clock=clock)

    def getQueueStatus(self, index: int) -> QueueStatus:
        """Return what has become of the messages of an input.

        Raises:
            IndexError: there is no such input.
        """
        asked = self._input(index)
        with self._lock:
            return QueueStatus(
                asked.expected_ns is not None, len(asked.waiting), asked.processed, asked.dropped
            )

    def setName(self, name: str) -> None:
        """Set a name, which is returned by `getName` alone."""
        self._name = name

    def getName(self) -> str:
        """Return the name; empty without one."""
        return self._name

    def add(self, msg: Any, queue_index: int) -> None:
        """Keep a message of an input until its turn.

        Raises:
            IndexError: there is no such input.
        """
        stamp_ns = time_ns(msg.header.stamp)
        receiving = self._input(queue_index)
        with self._lock:
            if self._jump is not None and self._jump.has_overtaken(stamp_ns):
                return
            if self._last_ns is not None and stamp_ns < self._last_ns:
                receiving.dropped += 1
                return
            insort(receiving.waiting, (stamp_ns, next(self._arrivals), msg))
            receiving.expected_ns = receiving.waiting[0][0]
            self._newest_ns = max(stamp_ns, self._newest_ns or stamp_ns)

    def dispatchMessages(self) -> None:
        """Pass on the messages whose turn it is; if a callback raises, after it the next call goes on."""
        # One thread at a time passes messages on, because two would mix their order; the other one leaves it to this.
        # The callbacks are called outside of the lock, because they may add messages.
        with self._lock:
            self._is_asked = True
            if self._is_dispatching:
                return
            self._is_dispatching = True
        try:
            while (turn := self._take_next()) is not None:
                signal, message = turn
                signal.signalMessage(message)
        except BaseException:
            with self._lock:
                self._is_dispatching = False
            raise

    def _take_next(self) -> tuple[SimpleFilter, Any] | None:
        """Remove and return the next message, with what calls its callbacks; None if it isn't anybody's turn."""
        with self._lock:
            while self._is_asked:
                active = [each for each in self._inputs if each.expected_ns is not None]
                first = min(active, key=_turn, default=None)
                if first is None or not (first.waiting or self._times_out(first)):
                    self._is_asked = False
                elif first.waiting:
                    return first.signal, self._removed(first)
            self._is_dispatching = False
            return None

    def _times_out(self, late: _Input) -> bool:
        """Leave out an input without a message, if others are ahead of it by the timeout; return whether it is."""
        if self._newest_ns is None or late.expected_ns is None:
            return False
        if self._newest_ns - late.expected_ns <= self._timeout_ns:
            return False
        late.expected_ns = None
        return True

    def _removed(self, first: _Input) -> Any:
        stamp_ns, _, message = first.waiting.pop(0)
        first.processed += 1
        first.expected_ns = first.waiting[0][0] if first.waiting else stamp_ns + first.period_ns
        self._last_ns = stamp_ns
        return message

    def _input(self, index: int) -> _Input:
        inputs = self._inputs
        if not 0 <= index < len(inputs):
            raise IndexError(f"there is no input {index}: there are {len(inputs)}, from 0")
        return inputs[index]

    def clear_after_jump(self, jump: JumpBack) -> None:
        """Forget all messages, and those that are sent before the jump and arrive now; see `SimpleFilter`."""
        if not jump.reaches(self):
            return
        with self._lock:
            self._jump = jump
            self._newest_ns = self._last_ns = None
            for each in self._inputs:
                each.waiting.clear()
                each.expected_ns = None
        for each in self._inputs:
            each.signal.clear_after_jump(jump)


def _turn(each: _Input) -> tuple[int, bool]:
    """Return by what inputs are compared: of two with one stamp, that with a message is first."""
    return each.expected_ns or 0, not each.waiting
