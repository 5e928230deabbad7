"""Subscriptions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import Enum
from types import FunctionType, MethodType
from typing import TYPE_CHECKING, Any, Generic, TypedDict, cast

from tfloom.node.context.utilities import get_rmw_implementation_identifier
from tfloom.node.endpoints.endpoint import UNREADABLE, Receiver
from tfloom.node.executing.entity import Entity
from tfloom.node.qos.qos import HistoryPolicy, QoSProfile
from tfloom.node.values.exceptions import RCLError
from tfloom.node.values.handle import Handle
from tfloom.node.values.type_support import MsgType
from tfloom.node.values.wrong_arguments import not_callable
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from typing import TypeAlias

    from tfloom._native import ReadyQueue, Sink
    from tfloom.node.endpoints.content_filter import ContentFilter, ContentFilterOptions
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.event_handler import EventHandler
    from tfloom.node.log.rcutils_logger import RcutilsLogger
    from tfloom.rmw.base import Reader, Sample
    from tfloom.rosidl.message import Message

    SubscriptionCallback: TypeAlias = (
        Callable[[MsgType], Any]
        | Callable[[MsgType, "MessageInfo"], Any]
        | Callable[[MsgType, dict[str, Any]], Any]
    )

__all__ = ["MessageInfo", "MsgType", "PublisherGID", "Subscription", "callback_error", "takes_count"]

_VAR_POSITIONAL = 0x04
"""The flag of a code object that takes `*args`."""
_FED = object()
"""Returned by `take` after messages were pushed into the sink, which need no callback."""


class PublisherGID(TypedDict):
    """Which publisher sent a message."""

    implementation_identifier: str
    """The wire, as RMW_IMPLEMENTATION spells it."""
    data: bytes
    """Global id of the publisher on the wire: 16 bytes."""


class MessageInfo(TypedDict):
    """What a callback learns of a message beside the message."""

    source_timestamp: int
    """When it was sent, by the sender's clock [ns since the epoch]."""
    received_timestamp: int
    """When it was received, by this computer's clock [ns since the epoch]."""
    publication_sequence_number: int | None
    """Its number among those of its publisher, from 1; None where the wire doesn't tell."""
    reception_sequence_number: int | None
    """Its number among those of this subscription, from 0; None where the wire doesn't tell."""
    publisher_gid: PublisherGID | None
    """Its publisher."""


class Subscription(Receiver["Reader"], Generic[MsgType]):
    """Calls its callback with each message of one topic; `Node.create_subscription` creates one."""

    _kind = "subscription"

    class CallbackType(Enum):
        """The arguments of the callback."""

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
        event_callbacks: None,  # the node creates the event handlers
        *,
        logger: RcutilsLogger,
    ) -> None:
        super().__init__(subscription_impl, topic, msg_type, logger)
        self.msg_type = msg_type
        self.topic = topic
        """The topic's name as the program gave it; `topic_name` is the full one."""
        self.callback = callback
        self.callback_group = callback_group
        self.qos_profile = qos_profile
        if qos_profile.history == HistoryPolicy.KEEP_LAST:
            self._history = max(qos_profile.depth, 1)
        self.raw = raw
        self.event_handlers: list[EventHandler] = []
        self._filter: ContentFilter | None = None
        self._is_filter_announced = False
        """Whether writers were told of a filter, so that they must be told of the next one, or of none."""
        self._accepted: tuple[Sample | None, Any] = (None, None)
        """The sample that the filter has accepted last, and its message. Replaced whole."""

    @property
    def callback(self) -> Callable[..., Any]:
        """Called with each message, and with its info if it takes two arguments."""
        return self._callback

    @callback.setter
    def callback(self, callback: Callable[..., Any]) -> None:
        if (error := callback_error(callback)) is not None:
            raise error
        takes_message = takes_count(callback, 1)
        kinds = Subscription.CallbackType
        self._callback_type = kinds.MessageOnly if takes_message else kinds.WithMessageInfo
        self._callback = callback
        self._with_info = self._callback_type is Subscription.CallbackType.WithMessageInfo

    def feed(self, sink: Sink) -> None:
        """Push the bytes of every message into `sink`, on the wire's thread, from now on.

        The callback is no longer called, and no message object is built. The messages end an executor's `spin_once`,
        as a callback does, but wake no other spin.
        """
        if self._sink is not None:
            self._sink.notify(None, 0)
        self._sink = sink
        if self._attached[0] is not None:
            sink.notify(*self._attached)
        self._endpoint.feed(sink)

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when data is received; for `spin_once` only, if it is pushed into a sink."""
        super().attach(queue, token)
        if self._sink is not None:
            self._sink.notify(queue, token)

    def detach(self) -> None:
        """Stop posting the token."""
        super().detach()
        if self._sink is not None:
            self._sink.notify(None, 0)

    def has_next(self) -> bool:
        """Return whether there is a message, or one was pushed into the sink."""
        return super().has_next() if self._sink is None else Entity.has_next(self)

    def take(self) -> Any:
        """Return what `run` needs of the oldest message, `UNREADABLE` or `_FED`, or None."""
        if self._sink is None:
            return super().take()
        return _FED if self._sink.take_pushed() else None

    set_on_new_message_callback = Receiver.set_on_new_callback
    clear_on_new_message_callback = Receiver.clear_on_new_callback

    # Content filters

    @property
    def is_cft_supported(self) -> bool:
        """Whether it can have a content filter: always, because the messages are filtered here."""
        return True

    @property
    def is_cft_enabled(self) -> bool:
        """Whether it has a content filter.

        Raises:
            InvalidHandle: it was destroyed, as below.
        """
        self._alive()
        return self._filter is not None

    def set_content_filter(self, filter_expression: str, expression_parameters: list[str]) -> None:
        """Receive only the messages for which an expression is true, from now on.

        Args:
            filter_expression: As `data > %0 AND header.frame_id LIKE 'base%'`; empty: receive all.
            expression_parameters: The literals that stand for `%0`, `%1` …, texts in single quotes.

        Raises:
            RCLError: the expression can't be used with these messages; the filter is as before.
            TypeError: the expression is not a text, or the parameters are not a list of texts.
        """
        from tfloom.node.endpoints.content_filter import ContentFilter, ContentFilterOptions, FilterError

        self._alive()
        options = ContentFilterOptions(filter_expression, expression_parameters)
        try:
            content_filter = ContentFilter(self.msg_type, options)
        except FilterError as error:
            raise RCLError(f"Failed to set cft expression parameters: {error}") from None
        self.filter_by(content_filter if filter_expression else None)

    def get_content_filter(self) -> ContentFilterOptions:
        """Return the expression and its parameters.

        Raises:
            RCLError: there is no content filter.
        """
        self._alive()
        if self._filter is None:
            raise RCLError("Failed to get cft expression parameters: the subscription has no content filter")
        return self._filter.options

    def filter_by(self, content_filter: ContentFilter | None) -> None:
        """Receive only what a compiled filter accepts; None: all."""
        if content_filter is not None:
            self.filter_samples(self._accepts)
        self._filter = content_filter
        is_announced = content_filter is not None and content_filter.is_announced
        if is_announced or self._is_filter_announced:
            options = content_filter.options if content_filter is not None and is_announced else ("", [])
            self._endpoint.announce_filter(*options)
            self._is_filter_announced = True

    def filter_samples(self, accepts: Callable[[Sample], bool]) -> None:
        """Take only the samples that a function accepts, in place of an earlier one."""
        # Imported where it is used, as above, because few programs filter.
        from tfloom.node.endpoints.content_filter import FilteringReader

        if isinstance(self._endpoint, FilteringReader):
            self._endpoint.accepts = accepts
            return
        self._endpoint = cast("Reader", FilteringReader(self._endpoint, accepts))
        if self._queue_switch is not None:
            self._queue_switch.refresh()
        elif self._attached[0] is not None:
            self._endpoint.notify(*self._attached)

    def _accepts(self, sample: Sample) -> bool:
        content_filter = self._filter
        if content_filter is None:
            return True
        try:
            message = cdr.decode(self.msg_type, sample.data)
        except cdr.DecodeError as error:
            self._warn(sample, error)
            return False
        if not content_filter.accepts(message):
            return False
        self._accepted = (sample, message)
        return True

    def _message(self, sample: Sample) -> Any:
        """Return the message of a sample, which the filter may have decoded."""
        accepted, message = self._accepted
        if accepted is not sample:
            data: Any = sample.data  # a message, if the wire has decoded it
            return cdr.decode(self.msg_type, data) if type(data) is bytes else data
        self._accepted = (None, None)
        return message

    def belongings(self) -> Sequence[Entity]:
        """Return the handlers of its events."""
        return self.event_handlers

    def get_publisher_count(self) -> int:
        """Return the number of connected publishers.

        Raises:
            InvalidHandle: it was destroyed.
        """
        return self.wire_endpoint.matched_count()

    @property
    def handle(self) -> Handle:
        """As of every endpoint."""
        return SubscriptionHandle(self, self._alive)

    @property
    def topic_name(self) -> str:
        """The topic's full name, after remapping.

        Raises:
            InvalidHandle: it was destroyed.
        """
        self._alive()
        return self._name

    def _take(self) -> Any:
        return self._endpoint.take() if self.raw else self._endpoint.take_decoded(self.msg_type)

    def _read(self, incoming: Sample) -> Any:
        """Return the arguments for the callback."""
        message = incoming.data if self.raw else self._message(incoming)
        return (message, _message_info(incoming)) if self._with_info else (message,)

    def run(self, taken: Any) -> Any:
        """Call the callback."""
        return None if taken is UNREADABLE or taken is _FED else self._callback(*taken)


class SubscriptionHandle(Handle):
    """Proxy returned by `Subscription.handle`, by which a program takes messages itself."""

    __slots__ = ()

    def take_message(self, pymsg_type: type[Message], raw: bool) -> tuple[Any, MessageInfo] | None:
        """Return the oldest message, or its bytes if `raw`, and its info; None if there is none.

        Raises:
            InvalidHandle: the subscription was destroyed.
            DecodeError: the message can't be decoded.
        """
        with self:
            incoming = self.take_incoming()
        if incoming is None:
            return None
        return incoming.data if raw else cdr.decode(pymsg_type, incoming.data), _message_info(incoming)


def _message_info(sample: Sample) -> MessageInfo:
    return {
        "source_timestamp": sample.source_stamp_ns,
        "received_timestamp": sample.received_stamp_ns,
        "publication_sequence_number": sample.publication_sequence_number,
        "reception_sequence_number": sample.reception_sequence_number,
        "publisher_gid": {
            "implementation_identifier": get_rmw_implementation_identifier(),
            "data": sample.publisher_gid,
        },
    }


def callback_error(callback: Any) -> RuntimeError | None:
    """Return the error of a subscription's callback that takes neither one argument nor two."""
    if callable(callback):
        if takes_count(callback, 1) or takes_count(callback, 2):
            return None
        given = f"got {callback!r}"
    else:
        given = not_callable(callback)
    return RuntimeError(
        "Subscription.__init__(): callback should be either be callable with one argument"
        f"(to get only the message) or two (to get message and message info); {given}"
    )


def takes_count(callback: Callable[..., Any], count: int) -> bool:
    """Return whether `callback` can be called with `count` positional arguments; True if its signature is unknown."""
    function = callback.__func__ if isinstance(callback, MethodType) else callback
    if not isinstance(function, FunctionType) or hasattr(function, "__wrapped__"):
        return _binds(callback, count)
    code = function.__code__
    bound = 1 if isinstance(callback, MethodType) else 0
    most = code.co_argcount - bound
    least = most - len(function.__defaults__ or ())
    required_keywords = code.co_kwonlyargcount - len(function.__kwdefaults__ or ())
    return (
        least <= count and (count <= most or bool(code.co_flags & _VAR_POSITIONAL)) and required_keywords == 0
    )


def _binds(callback: Callable[..., Any], count: int) -> bool:
    from inspect import signature

    try:
        signature(callback).bind(*range(count))
    except TypeError:
        return False
    except ValueError:
        pass  # a built-in without a signature, as `print` before Python 3.11
    return True
