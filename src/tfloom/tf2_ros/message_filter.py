"""A filter that holds messages until they can be transformed."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from enum import IntEnum
from functools import partial
from typing import TYPE_CHECKING, Any

from tfloom.node.log.logging import get_logger
from tfloom.node.values.callback_errors import call_all
from tfloom.node.values.exceptions import InvalidHandle
from tfloom.tf2_ros.buffer_core import duration_ns, time_ns
from tfloom.tf2_ros.deadlines import call_after
from tfloom.tf2_ros.message_filters import JumpBack, SimpleFilter, clear_with

if TYPE_CHECKING:
    from tfloom.node.executing.guard_condition import GuardCondition
    from tfloom.node.node import Node
    from tfloom.tf2_ros.buffer_core import BufferCore

__all__ = ["FilterFailureReason", "MessageFilter", "get_filter_failure_reason_string"]


class FilterFailureReason(IntEnum):
    """Why a message was dropped."""

    Unknown = 0
    OutTheBack = 1
    """Its stamp is older than the buffer's history."""
    EmptyFrameID = 2
    """Its frame id is empty."""
    NoTransformFound = 3
    """`buffer_timeout` has passed."""
    QueueFull = 4
    """The queue was full of newer messages."""


_TEXTS = {
    FilterFailureReason.Unknown: "unknown",
    FilterFailureReason.OutTheBack: "the timestamp on the message is earlier than all the data in the transform cache",
    FilterFailureReason.EmptyFrameID: "the frame id of the message is empty",
    FilterFailureReason.NoTransformFound: "did not find a valid transform, this usually happens at startup ...",
    FilterFailureReason.QueueFull: "discarding message because the queue is full",
}


def get_filter_failure_reason_string(reason: int) -> str:
    """Return a reason's name."""
    names = {reason.value: reason.name for reason in FilterFailureReason}
    return names.get(int(reason), "Invalid Failure Reason")


class _Held:
    """A held message, the requests for its transforms, and how often the filter was cleared before it came."""

    def __init__(self, message: Any, missing: int, clears: int) -> None:
        self.message = message
        self.missing = missing
        self.clears = clears
        self.handles: list[int] = []
        self.is_settled = False


class MessageFilter(SimpleFilter):
    """Passes on the messages of a filter when the buffer can transform them into one or several frames.

    Callbacks run on the executor that spins the node; without a node, on the thread that adds the message or the
    missing transform.

    Args:
        f: The input filter, such as a `message_filters.Subscriber`; None: messages come from `add` alone.
        buffer: The buffer to look up in.
        target_frame: The frame, or all of the frames, that messages must be transformable into.
        queue_size: Most messages to hold; the oldest are dropped. 0: no limit.
        node: Node whose executor runs the callbacks; None: that of the filter's node, if it has one.
        buffer_timeout: The longest time to hold a message, by the steady clock; None: no limit.
    """

    def __init__(
        self,
        f: Any,
        buffer: BufferCore,
        target_frame: str | Sequence[str],
        queue_size: int,
        node: Node | None = None,
        buffer_timeout: Any = None,
    ) -> None:
        super().__init__()
        self._buffer = buffer
        self._queue_size = queue_size
        self._timeout_s = None if buffer_timeout is None else duration_ns(buffer_timeout) / 1e9
        self._tolerance_ns = 0
        self._targets: list[str] = []
        self._failure_callbacks: list[Callable[[Any, FilterFailureReason], Any]] = []
        self._lock = threading.Lock()
        self._held: dict[int, _Held] = {}  # by identity, oldest first
        self._clears = 0
        self._jump: JumpBack | None = None
        self._calls: deque[Callable[[], None]] = deque()
        self._guard: GuardCondition | None = None
        self.setTargetFrames([target_frame] if isinstance(target_frame, str) else target_frame)
        if f is None and node is not None:
            clear_with(node.get_clock(), self)
        node = getattr(f, "node", None) if node is None else node
        if node is not None:
            self._guard = node.create_guard_condition(self._call_all)
        if f is not None:
            self.connectInput(f)

    def connectInput(self, f: Any) -> None:
        """Connect to an input filter."""
        self.incoming_connection = f.registerCallback(self.add)

    def setTargetFrame(self, target_frame: str) -> None:
        """Set the frame that messages must be transformable into, starting with the next message."""
        self.setTargetFrames([target_frame])

    def setTargetFrames(self, target_frames: Sequence[str]) -> None:
        """Set the frames that messages must be transformable into, starting with the next message."""
        self._targets = [frame.removeprefix("/") for frame in target_frames]

    def getTargetFramesString(self) -> str:
        """Return the frames that messages must be transformable into, a space after each."""
        return "".join(f"{frame} " for frame in self._targets)

    def setTolerance(self, tolerance: Any) -> None:
        """Also require the transform at this duration after the stamp, starting with the next message."""
        self._tolerance_ns = duration_ns(tolerance)

    def setQueueSize(self, new_queue_size: int) -> None:
        """Set the most messages to hold; 0: no limit."""
        self._queue_size = new_queue_size

    def getQueueSize(self) -> int:
        """Return the most messages that are held."""
        return self._queue_size

    def registerFailureCallback(self, callback: Callable[[Any, FilterFailureReason], Any]) -> None:
        """Register `callback(message, reason)` for each message that is dropped."""
        self._failure_callbacks.append(callback)

    def clear(self) -> None:
        """Drop all held messages, and those that wait for the executor."""
        with self._lock:
            self._clears += 1
            forgotten = list(self._held.values())
            self._held.clear()
            for held in forgotten:
                held.is_settled = True
        for held in forgotten:
            self._cancel(held)

    def clear_after_jump(self, jump: JumpBack) -> None:
        """Drop all held messages, and those that are sent before the jump and arrive now; see `SimpleFilter`."""
        self._jump = jump
        self.clear()
        super().clear_after_jump(jump)

    def add(self, msg: Any) -> None:
        """Add a message, which is passed on as soon as the buffer can transform it."""
        clears = self._clears
        header = msg.header
        frame = header.frame_id.removeprefix("/")
        if not frame:
            self._drop(msg, FilterFailureReason.EmptyFrameID)
            return
        stamp = time_ns(header.stamp)
        jump = self._jump
        if jump is not None and jump.has_overtaken(stamp):
            return
        stamps = (stamp, stamp + self._tolerance_ns) if self._tolerance_ns else (stamp,)
        queries = [(target, frame, at) for target in self._targets for at in stamps]
        # A request may be answered at once, on another thread, while the others are still being made. So the count of
        # what is missing starts at one more than the requests; `_hold` takes that one away when all are made.
        held = _Held(msg, len(queries) + 1, clears)
        for query in queries:
            handle = self._buffer.add_request(*query, partial(self._answer, held))
            if handle is None:
                self._answer(held, 0, False)
                break
            if handle == 0:
                self._answer(held, 0, True)
            else:
                held.handles.append(handle)
        self._hold(held)

    def _hold(self, held: _Held) -> None:
        # A message is settled once, by whoever is first under the lock: its last transform, a failure, the timeout, the
        # queue's limit or `clear`. All the others find `is_settled` and do nothing. Callbacks run after the lock is
        # released, because they may add messages.
        crowded_out = []
        with self._lock:
            held.missing -= 1
            if held.clears != self._clears:
                held.is_settled = True
            is_settled = held.is_settled
            is_ready = not is_settled and held.missing == 0
            if is_ready:
                held.is_settled = True
            elif not is_settled:
                self._held[id(held)] = held
                while 0 < self._queue_size < len(self._held):
                    oldest = self._held.pop(next(iter(self._held)))
                    oldest.is_settled = True
                    crowded_out.append(oldest)
        for evicted in crowded_out:
            self._cancel(evicted)
            self._drop(evicted.message, FilterFailureReason.QueueFull)
        if is_settled:
            self._cancel(held)  # the requests made after the failure, or before `clear`
        elif is_ready:
            self.signalMessage(held.message)
        elif self._timeout_s is not None:
            try:
                call_after(self._timeout_s, partial(self._fail, held, FilterFailureReason.NoTransformFound))
            except RuntimeError:  # no thread: without its timeout, the message must not be held
                self._fail(held, FilterFailureReason.Unknown)
                raise

    def _answer(self, held: _Held, _handle: int, is_available: bool) -> None:
        if not is_available:
            self._fail(held, FilterFailureReason.OutTheBack)
            return
        with self._lock:
            held.missing -= 1
            if held.is_settled or held.missing > 0:
                return
            held.is_settled = True
            self._held.pop(id(held), None)
        self._call(partial(self._pass_on, held))

    def _pass_on(self, held: _Held) -> None:
        if held.clears == self._clears:
            self.signalMessage(held.message)

    def _fail(self, held: _Held, reason: FilterFailureReason) -> None:
        with self._lock:
            if held.is_settled:
                return
            held.is_settled = True
            self._held.pop(id(held), None)
        self._cancel(held)
        self._drop(held.message, reason)

    def _cancel(self, held: _Held) -> None:
        for handle in list(held.handles):
            self._buffer.cancel_request(handle)

    def _drop(self, message: Any, reason: FilterFailureReason) -> None:
        header = message.header
        get_logger("tf2_ros_message_filter").info(
            f"Message Filter dropping message: frame '{header.frame_id}' at time {time_ns(header.stamp) / 1e9:.3f} "
            f"for reason '{_TEXTS[reason]}'"
        )
        call_all(
            [partial(self._call, partial(callback, message, reason)) for callback in self._failure_callbacks]
        )

    def _call(self, function: Callable[[], Any]) -> None:
        if self._guard is None:
            function()
            return
        self._calls.append(function)
        try:
            self._guard.trigger()
        except InvalidHandle:  # the node was destroyed, and with it what would run them
            self._calls.clear()

    def _call_all(self) -> None:
        while self._calls:
            try:
                self._calls.popleft()()
            except BaseException:
                if self._calls and self._guard is not None:
                    self._guard.trigger()  # the other messages are passed on by the next spin
                raise
