"""The sending end of a topic."""

from __future__ import annotations

from typing import TYPE_CHECKING, Generic, TypeVar

from tfloom.node.duration import Duration
from tfloom.node.exceptions import InvalidHandle, RCLError
from tfloom.node.qos import QoSProfile
from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom.node.callback_groups import CallbackGroup
    from tfloom.node.context import Context
    from tfloom.node.event_handler import EventHandler
    from tfloom.rmw.base import Writer

__all__ = ["MsgType", "Publisher"]

MsgType = TypeVar("MsgType", bound=Message)


class Publisher(Generic[MsgType]):
    """Publishes messages of one type on one topic; `Node.create_publisher` makes one."""

    def __init__(
        self,
        publisher_impl: Writer,
        msg_type: type[MsgType],
        topic: str,
        qos_profile: QoSProfile,
        event_callbacks: None,  # noqa: ARG002  # the node watches
        callback_group: CallbackGroup,
        *,
        context: Context,
    ) -> None:
        self._writer = publisher_impl
        self._context = context
        self._destroyed = False
        self.msg_type = msg_type
        self.topic = topic
        self.qos_profile = qos_profile
        self.event_handlers: list[EventHandler] = []
        self.callback_group = callback_group

    def publish(self, msg: MsgType | bytes) -> None:
        """Send a message, or bytes that hold one: encapsulation header and CDR.

        Raises:
            TypeError: `msg` is of another type.
            EncodeError: a field's value doesn't fit its type; the text names the field.
            RCLError: the context is shut down.
            InvalidHandle: the publisher was destroyed.
        """
        if isinstance(msg, self.msg_type):
            data = cdr.encode(msg)
        elif isinstance(msg, bytes):
            data = msg
        else:
            raise TypeError(f"Expected {self.msg_type}, got {type(msg)}")
        if self._destroyed:
            raise InvalidHandle(f"cannot publish on {self.topic}: the publisher was destroyed")
        if not self._context.ok():
            raise RCLError("Failed to publish: publisher's context is invalid")
        self._writer.write(data)

    def get_subscription_count(self) -> int:
        """Return how many subscriptions are connected now."""
        return 0 if self._destroyed else self._writer.matched_count()

    @property
    def topic_name(self) -> str:
        """The topic's full name, after remapping."""
        return self.topic

    @property
    def handle(self) -> Self:
        """What stands for the library's own publisher: this object.

        Raises:
            InvalidHandle: the publisher was destroyed.
        """
        if self._destroyed:
            raise InvalidHandle(f"cannot use the publisher on {self.topic}: it was destroyed")
        return self

    @property
    def gid(self) -> bytes:
        """Who it is on the wire: 16 octets."""
        return self._writer.gid

    def destroy(self) -> None:
        """Leave the topic. Destroying again does nothing. `Node.destroy_publisher` does it too."""
        if not self._destroyed:
            self._destroyed = True
            self._writer.close()

    def assert_liveliness(self) -> None:
        """Say that the publisher lives; with AUTOMATIC liveliness the wire says so by itself."""
        self.handle._writer.assert_liveliness()  # noqa: SLF001

    def wait_for_all_acked(self, timeout: Duration = Duration(seconds=-1)) -> bool:  # noqa: B008  # immutable
        """Wait until every connected reliable subscription has all that was published.

        Args:
            timeout: The longest wait; negative: for ever.

        Returns:
            False after the timeout.
        """
        return self.handle._writer.wait_for_acks(timeout.nanoseconds)  # noqa: SLF001

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy()
