"""The receiving end of a topic."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from tfloom.node.callback_arguments import takes
from tfloom.node.entity import Entity
from tfloom.node.exceptions import InvalidHandle
from tfloom.node.qos import QoSProfile
from tfloom.node.throttled_warning import ThrottledWarning
from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom._native import ReadyQueue, Sink
    from tfloom.node.callback_groups import CallbackGroup
    from tfloom.node.event_handler import EventHandler
    from tfloom.node.rcutils_logger import RcutilsLogger
    from tfloom.rmw.base import Reader, Sample

__all__ = ["MsgType", "Subscription"]

MsgType = TypeVar("MsgType", bound=Message)
_UNREADABLE = object()


class Subscription(Entity, Generic[MsgType]):
    """Has its callback run with each message of one topic; `Node.create_subscription` makes one."""

    class CallbackType(Enum):
        """What the callback takes."""

        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self,
        subscription_impl: Reader,
        msg_type: type[MsgType],
        topic: str,
        callback: Callable[..., Any],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
        raw: bool,
        event_callbacks: None,  # noqa: ARG002  # the node watches
        *,
        logger: RcutilsLogger,
    ) -> None:
        self._reader = subscription_impl
        self._destroyed = False
        self._warning = ThrottledWarning(logger)
        self._decode = cdr.decode
        self.msg_type = msg_type
        self.topic = topic
        self.callback = callback
        self.callback_group = callback_group
        self.qos_profile = qos_profile
        self.raw = raw
        self.event_handlers: list[EventHandler] = []

    @property
    def callback(self) -> Callable[..., Any]:
        """What is called with each message, and with its info if it takes two arguments."""
        return self._callback

    @callback.setter
    def callback(self, callback: Callable[..., Any]) -> None:
        if takes(callback, 1):
            self._callback_type = Subscription.CallbackType.MessageOnly
        elif takes(callback, 2):
            self._callback_type = Subscription.CallbackType.WithMessageInfo
        else:
            raise RuntimeError(
                "Subscription.__init__(): callback should be either be callable with one argument"
                "(to get only the message) or two (to get message and message info)"
            )
        self._callback = callback
        self._with_info = self._callback_type is Subscription.CallbackType.WithMessageInfo

    def feed(self, sink: Sink) -> None:
        """Push the bytes of every message into `sink`, on the wire's thread, from now on.

        No callback runs any more, and no message object is built.
        """
        self._reader.feed(sink)

    def get_publisher_count(self) -> int:
        """Return how many publishers are connected now."""
        return 0 if self._destroyed else self._reader.matched_count()

    @property
    def topic_name(self) -> str:
        """The topic's full name, after remapping."""
        return self.topic

    @property
    def handle(self) -> Self:
        """What stands for the library's own subscription: this object.

        Raises:
            InvalidHandle: the subscription was destroyed.
        """
        if self._destroyed:
            raise InvalidHandle(f"cannot use the subscription of {self.topic}: it was destroyed")
        return self

    def destroy(self) -> None:
        """Leave the topic. Destroying again does nothing. `Node.destroy_subscription` does it too."""
        if not self._destroyed:
            self._destroyed = True
            self._reader.close()

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when messages have come."""
        if not self._destroyed:
            self._reader.notify(queue, token)

    def detach(self) -> None:
        """Post no more."""
        if not self._destroyed:
            self._reader.notify(None)

    def take(self) -> Any:
        """Return the arguments for the callback with the oldest message, or None."""
        if self._destroyed:
            return None
        sample = self._reader.take()
        if sample is None:
            return None
        if self.raw:
            message: Any = sample.data
        else:
            try:
                message = self._decode(self.msg_type, sample.data)
            except cdr.DecodeError as error:
                self._warn(sample, error)
                return _UNREADABLE
        return (message, _info(sample)) if self._with_info else (message,)

    def run(self, taken: Any) -> Any:
        """Call the callback."""
        return None if taken is _UNREADABLE else self._callback(*taken)

    def _warn(self, sample: Sample, error: cdr.DecodeError) -> None:
        name = self.msg_type._TYPE_NAME  # ours
        self._warning.log(
            f"Dropped a message of {len(sample.data)} bytes on {self.topic} that is no valid {name}: {error}"
        )

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy()


def _info(sample: Sample) -> dict[str, Any]:
    return {
        "source_timestamp": sample.source_stamp_ns,
        "received_timestamp": sample.received_stamp_ns,
        "publication_sequence_number": None,
        "reception_sequence_number": None,
    }
