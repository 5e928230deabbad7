"""The base of publishers, subscriptions, services and clients: an endpoint on the wire, until it is destroyed."""

from __future__ import annotations

import math
import threading
from collections import deque
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

from tfloom.node.executing.entity import Entity
from tfloom.node.log.rcutils_logger import ThrottledWarning
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.node.values.handle import Handle
from tfloom.ros_imports.guard import ros_repr
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import TracebackType

    from typing_extensions import Self

    from tfloom._native import ReadyQueue, Sink
    from tfloom.node.endpoints.arrivals import Arrivals
    from tfloom.node.endpoints.queue_switch import QueueSwitch
    from tfloom.node.log.rcutils_logger import RcutilsLogger
    from tfloom.rosidl.message import Message

__all__ = ["UNREADABLE", "Endpoint", "Receiver", "ReceivingEndpoint", "TakingEndpoint"]

UNREADABLE = object()
"""Returned by `take` for data that can't be decoded: there is nothing to run, but more data may be waiting."""


class Closable(Protocol):
    """An endpoint on the wire."""

    def close(self) -> None:
        """Leave the wire."""


class HasData(Protocol):
    """A sample, request or response from the wire."""

    @property
    def data(self) -> bytes:
        """Encapsulation header and CDR."""


class TakeSource(Closable, Protocol):
    """An endpoint on the wire that receives."""

    def take(self) -> Any:
        """Remove and return the oldest waiting item, or None."""

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` when there may be something to take; None ends this."""


WireEndpoint = TypeVar("WireEndpoint", bound=Closable)
TakingEndpoint = TypeVar("TakingEndpoint", bound=TakeSource)


class Endpoint(Generic[WireEndpoint]):
    """An endpoint on the wire, until it is destroyed."""

    _kind = ""
    """Kind of endpoint for error texts, such as `client`."""

    owner: Any = None
    """The node, as of an `Entity`."""

    on_destroy: Callable[[Any], object] | None = None
    """As of an `Entity`."""

    def __init__(self, endpoint: WireEndpoint, name: str) -> None:
        self._endpoint = endpoint
        self._name = name
        self._destroyed = False

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def handle(self) -> Handle:
        """Proxy of the endpoint, for code that expects rclpy's C handle.

        After the end, it raises InvalidHandle when it is entered.
        """
        return Handle(self, self._alive)

    @property
    def logger_name(self) -> str:
        """Name of the logger of the node that has it.

        Raises:
            InvalidHandle: it was destroyed.
        """
        self._alive()
        name: str = self.owner.get_logger().name
        return name

    def get_logger_name(self) -> str:
        """Return `logger_name`; rclpy's C handle has this name."""
        return self.logger_name

    @property
    def is_destroyed(self) -> bool:
        """Whether it has left the wire."""
        return self._destroyed

    @property
    def wire_endpoint(self) -> WireEndpoint:
        """The endpoint on the wire.

        Raises:
            InvalidHandle: it was destroyed.
        """
        self._alive()
        return self._endpoint

    def _alive(self) -> Self:
        """Return this endpoint.

        Raises:
            InvalidHandle: it was destroyed.
        """
        if self._destroyed:
            raise InvalidHandle(f"cannot use the {self._kind} of {self._name}: it was destroyed")
        return self

    def destroy(self) -> None:
        """Leave the wire. Destroying again does nothing. The node no longer has it then."""
        if not self._destroyed:
            self._destroyed = True
            self._endpoint.close()
            if self.on_destroy is not None:
                self.on_destroy(self)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy()


class ReceivingEndpoint(Endpoint[TakingEndpoint]):
    """An endpoint that receives, and posts to a queue when data has arrived."""

    _attached: tuple[ReadyQueue | None, int] = (None, 0)
    """The queue that this posts to, and its token there."""

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when data has arrived."""
        self._attached = (queue, token)
        if not self._destroyed:
            self._notify(queue, token)

    def detach(self) -> None:
        """Stop posting the token."""
        self._attached = (None, 0)
        if not self._destroyed:
            self._notify(None, 0)

    def _notify(self, queue: ReadyQueue | None, token: int) -> None:
        self._endpoint.notify(queue, token)


class Receiver(ReceivingEndpoint[TakingEndpoint], Entity):
    """A receiving endpoint, whose callback an executor runs.

    Args:
        endpoint: The endpoint on the wire.
        name: Full name of its topic or service.
        incoming_type: Class of the incoming messages.
        logger: Logs a warning about data that can't be decoded.
    """

    _incoming = ("a message", "on")
    """The kind of incoming data, and its preposition, for warnings."""

    takes_on_any_thread = True

    _queue_switch: QueueSwitch | None = None
    """Of an endpoint whose data other threads wait for, too."""
    _sink: Sink | None = None
    """Of a subscription whose messages are pushed into it, without Python."""
    _arrivals: Arrivals | None = None
    """Calls the function that was set to be told of new data. Only its thread takes from the wire then."""

    def __init__(
        self, endpoint: TakingEndpoint, name: str, incoming_type: type[Message], logger: RcutilsLogger
    ) -> None:
        super().__init__(endpoint, name)
        self._incoming_type = incoming_type
        self._warning = ThrottledWarning(logger)
        self._kept: deque[Any] = deque()
        """What `has_next` has found on the wire, and nothing has taken. Changed under `_kept_lock`."""
        self._kept_lock = threading.Lock()
        self._history = math.inf
        """Most items that wait at once, where newer ones replace them."""

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when data has arrived."""
        super().attach(queue, token)
        if self._kept:  # nothing else says that there is some
            queue.post(token)

    def _notify(self, queue: ReadyQueue | None, token: int) -> None:
        if self._queue_switch is None:
            super()._notify(queue, token)
        else:
            self._queue_switch.attach(queue, token)

    def set_on_new_callback(self, callback: Callable[[int], Any]) -> None:
        """Call a function, on a thread, with the number of items that have arrived, whenever there are some.

        The items are messages, requests or responses. Those that wait now are among the first. rclpy's handles have
        this function.

        Args:
            callback: Called with a number above 0.

        Raises:
            InvalidHandle: the endpoint was destroyed.
            TypeError: `callback` isn't callable.
            RCLError: a thread can't be started, or the messages are pushed into a sink.
        """
        # Imported where it is used, because few programs have executors of their own.
        from tfloom.node.endpoints.arrivals import Arrivals
        from tfloom.node.endpoints.queue_switch import QueueSwitch

        if self._sink is not None:
            raise RCLError(
                "failed to set the callback of new messages: the messages are received without Python"
            )
        self._alive()
        if not callable(callback):
            raise TypeError(f"a callback of new data must be callable, got {callback!r}")
        self.clear_on_new_callback()
        if self._queue_switch is None:
            switch = QueueSwitch(super()._notify)  # which finds an endpoint that was replaced
            switch.attach(*self._attached)
            self._queue_switch = switch
        self._arrivals = Arrivals(self._queue_switch, self._collect, len(self._kept), callback)

    def clear_on_new_callback(self) -> None:
        """Call the function that was set to be told of new data no more."""
        arrivals, self._arrivals = self._arrivals, None
        if arrivals is not None:
            arrivals.end()

    def _collect(self) -> int:
        """Take what has arrived from the wire, keep the newest of it, and return how many there were."""
        count = 0
        with self._kept_lock:
            while not self._destroyed and (incoming := self._endpoint.take()) is not None:
                self._kept.append(incoming)
                count += 1
                if len(self._kept) > self._history:
                    self._kept.popleft()
        return count

    def destroy(self) -> None:
        """As of an endpoint; the function that was told of new data is called no more."""
        self.clear_on_new_callback()
        super().destroy()

    def has_next(self) -> bool:
        """Return whether there is an item, which stays here for whoever takes the next."""
        with self._kept_lock:
            is_empty = not self._kept and not self._destroyed and self._arrivals is None
            if is_empty and (incoming := self._endpoint.take()) is not None:
                self._kept.append(incoming)
            return bool(self._kept)

    def take_incoming(self) -> Any:
        """Remove and return the oldest item as the wire has it, or None."""
        kept, take = self._kept, self._endpoint.take
        with self._kept_lock:
            if self._arrivals is not None:
                return kept.popleft() if kept else None
            if not kept:
                return take()
            # What waits here is part of the history, in which newer items have replaced it meanwhile.
            while len(kept) <= self._history and (incoming := take()) is not None:
                kept.append(incoming)
            if len(kept) > self._history:
                kept.popleft()
            return kept.popleft()

    def take(self) -> Any:
        """Remove the oldest item and return it as `run` takes it, `UNREADABLE`, or None."""
        if self._destroyed:
            return None
        is_kept = self._kept or self._arrivals is not None
        incoming = self.take_incoming() if is_kept else self._take()
        if incoming is None:
            return None
        try:
            return self._read(incoming)
        except cdr.DecodeError as error:
            self._warn(incoming, error)
            return UNREADABLE

    def _take(self) -> Any:
        """Remove and return the oldest item on the wire as `_read` takes it, or None."""
        return self._endpoint.take()

    def _read(self, incoming: Any) -> Any:
        """Return an item as `run` takes it.

        Raises:
            DecodeError: it can't be decoded.
        """
        raise NotImplementedError

    def _warn(self, incoming: HasData, error: cdr.DecodeError) -> None:
        what, preposition = self._incoming
        self._warning.log(
            f"Dropped {what} of {len(incoming.data)} bytes {preposition} {self._name} that is not a valid "
            f"{self._incoming_type._TYPE_NAME}: {error}"  # ours
        )
