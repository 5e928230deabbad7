"""Publishers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Generic, cast

from tfloom.node.endpoints.endpoint import Endpoint
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.node.values.type_support import MsgType, wrong_message
from tfloom.rmw.errors import ClosedError
from tfloom.rosidl.message import EncodeError

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.event_handler import EventHandler
    from tfloom.rmw.base import Writer

__all__ = ["MsgType", "Publisher"]


class Publisher(Endpoint["Writer"], Generic[MsgType]):
    """Publishes messages of one type on one topic; `Node.create_publisher` creates one."""

    _kind = "publisher"

    def __init__(
        self,
        publisher_impl: Writer,
        msg_type: type[MsgType],
        topic: str,
        qos_profile: QoSProfile,
        event_callbacks: None,  # the node creates the event handlers
        callback_group: CallbackGroup,
        *,
        context: Context,
    ) -> None:
        super().__init__(publisher_impl, topic)
        self._context = context
        self.msg_type = msg_type
        self.topic = topic
        """The topic's name as the program gave it; `topic_name` is the full one."""
        self.qos_profile = qos_profile
        self.event_handlers: list[EventHandler] = []
        self.callback_group = callback_group

    def publish(self, msg: MsgType | bytes) -> None:
        """Send a message, or a serialized message: encapsulation header and CDR.

        Raises:
            TypeError: `msg` is of another type.
            EncodeError: a field's value doesn't fit its type; the text names the field.
            RCLError: the context is shut down. A daemon thread ends without it where the program's end has done so.
            ForkedProcessError: this process is a fork of the one that created the publisher.
            InvalidHandle: the publisher was destroyed.
        """
        self._check_exists()
        is_message = isinstance(msg, self.msg_type)
        if not (is_message or isinstance(msg, bytes)):
            raise TypeError(wrong_message(self.msg_type, msg))
        if not self._context.ok():
            self._context.check_not_from_parent_process(f"cannot publish on {self._name}")
            self._context.end_daemon_thread_at_exit()
            raise RCLError("Failed to publish: publisher's context is invalid")
        try:
            if is_message:
                self._endpoint.write_message(msg)
            else:
                self._endpoint.write(cast("bytes", msg))
        except EncodeError as error:
            raise error.with_traceback(None) from None  # the frames of the wire say nothing of the mistake
        except ClosedError:
            self._context.end_daemon_thread_at_exit()
            raise

    def _check_exists(self) -> None:
        if self._destroyed:
            raise InvalidHandle(f"cannot publish on {self._name}: the publisher was destroyed")

    def get_subscription_count(self) -> int:
        """Return the number of connected subscriptions.

        Raises:
            InvalidHandle: it was destroyed.
        """
        return self.wire_endpoint.matched_count()

    @property
    def topic_name(self) -> str:
        """The topic's full name, after remapping.

        Raises:
            InvalidHandle: it was destroyed.
        """
        self._alive()
        return self._name

    @property
    def gid(self) -> bytes:
        """Global id on the wire: 16 bytes."""
        return self._endpoint.gid

    def assert_liveliness(self) -> None:
        """Assert that the publisher is alive; with AUTOMATIC liveliness the wire does this."""
        self.wire_endpoint.assert_liveliness()

    def wait_for_all_acked(self, timeout: Duration = Duration(seconds=-1)) -> bool:
        """Wait until every connected reliable subscription has acknowledged all messages.

        Args:
            timeout: The longest wait; negative: no limit.

        Returns:
            True if all are acknowledged; False after the timeout.
        """
        return self.wire_endpoint.wait_for_acks(timeout.nanoseconds)
