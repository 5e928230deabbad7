"""What publishers, subscriptions, services and clients have in common: an end on the wire, and its end."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

from tfloom.node.executing.entity import Entity
from tfloom.node.log.throttled_warning import ThrottledWarning
from tfloom.node.values.exceptions import InvalidHandle
from tfloom.node.values.handle import Handle
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom._native import ReadyQueue
    from tfloom.node.log.rcutils_logger import RcutilsLogger
    from tfloom.rosidl.message import Message

__all__ = ["UNREADABLE", "Endpoint", "Receiver", "TakingEndpoint"]

UNREADABLE = object()
"""What was taken where something came that couldn't be read: there is nothing to run, but more may wait."""


class Closes(Protocol):
    """An end on the wire."""

    def close(self) -> None:
        """Leave for good."""


class Comes(Protocol):
    """What an end on the wire takes in."""

    @property
    def data(self) -> bytes:
        """Encapsulation header and CDR."""


class Takes(Closes, Protocol):
    """An end on the wire that takes things in."""

    def take(self) -> Any:
        """Remove and return the oldest thing that waits, or None."""

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` when there may be something to take; None ends it."""


End = TypeVar("End", bound=Closes)
TakingEndpoint = TypeVar("TakingEndpoint", bound=Takes)


class Endpoint(Generic[End]):
    """An end on the wire, until it is destroyed."""

    _kind = ""
    """What it is, for texts: `client`."""

    _part_of: Any = None  # as an entity's

    def __init__(self, endpoint: End, name: str) -> None:
        self._endpoint = endpoint
        self._name = name
        self._destroyed = False

    @property
    def handle(self) -> Handle:
        """What stands for the library's own object.

        Raises:
            InvalidHandle: it was destroyed.
        """
        return Handle(self._alive())

    def _alive(self) -> Self:
        """Return this.

        Raises:
            InvalidHandle: it was destroyed.
        """
        if self._destroyed:
            raise InvalidHandle(f"cannot use the {self._kind} of {self._name}: it was destroyed")
        return self

    def destroy(self) -> None:
        """Leave the wire. Destroying again does nothing. The node's `destroy_…` method does it too."""
        if not self._destroyed:
            self._destroyed = True
            self._endpoint.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy()


class Receiver(Endpoint[TakingEndpoint], Entity):
    """An end on the wire whose callback an executor runs with what comes.

    Args:
        endpoint: The end on the wire.
        name: The full name of its topic or service.
        incoming_type: Class of the messages that come.
        logger: Warns of what comes and can't be read.
    """

    _incoming = ("a message", "on")
    """What comes, and its preposition, for texts."""

    def __init__(
        self, endpoint: TakingEndpoint, name: str, incoming_type: type[Message], logger: RcutilsLogger
    ) -> None:
        super().__init__(endpoint, name)
        self._incoming_type = incoming_type
        self._warning = ThrottledWarning(logger)

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when something has come."""
        if not self._destroyed:
            self._endpoint.notify(queue, token)

    def detach(self) -> None:
        """Post no more."""
        if not self._destroyed:
            self._endpoint.notify(None)

    def take(self) -> Any:
        """Return what `run` needs of the oldest thing that has come, `UNREADABLE`, or None."""
        came = None if self._destroyed else self._endpoint.take()
        if came is None:
            return None
        try:
            return self._read(came)
        except cdr.DecodeError as error:
            self._warn(came, error)
            return UNREADABLE

    def _read(self, came: Any) -> Any:
        """Return what `run` needs of what has come.

        Raises:
            DecodeError: it can't be read.
        """
        raise NotImplementedError

    def _warn(self, came: Comes, error: cdr.DecodeError) -> None:
        what, preposition = self._incoming
        self._warning.log(
            f"Dropped {what} of {len(came.data)} bytes {preposition} {self._name} that is no valid "
            f"{self._incoming_type._TYPE_NAME}: {error}"  # ours
        )
