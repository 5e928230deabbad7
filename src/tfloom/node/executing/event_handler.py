"""Callbacks for the events of publishers and subscriptions."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.node.executing.entity import Entity
from tfloom.node.executing.waitable import NumberOfEntities
from tfloom.node.values.exceptions import InvalidHandle
from tfloom.node.values.handle import Handle, unwrap_handle
from tfloom.rmw.errors import UnsupportedEventError
from tfloom.rmw.events import Count, Event, IncompatibleQoS, LivelinessChanged, Matched, Status
from tfloom.rmw.shared.qos_mismatch import mismatch_text

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom._native import ReadyQueue
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.event_types import QoSPublisherEventType, QoSSubscriptionEventType
    from tfloom.node.log.rcutils_logger import RcutilsLogger
    from tfloom.rmw.base import Graph

__all__ = [
    "EventHandler",
    "IncompatibleTypeInfo",
    "PublisherEventCallbacks",
    "QoSEventHandler",
    "QoSLivelinessChangedInfo",
    "QoSLivelinessLostInfo",
    "QoSMessageLostInfo",
    "QoSOfferedDeadlineMissedInfo",
    "QoSOfferedIncompatibleQoSInfo",
    "QoSPublisherMatchedInfo",
    "QoSRequestedDeadlineMissedInfo",
    "QoSRequestedIncompatibleQoSInfo",
    "QoSSubscriptionMatchedInfo",
    "SubscriptionEventCallbacks",
    "UnsupportedEventTypeError",
]

UnsupportedEventTypeError = UnsupportedEventError

# The statuses passed to callbacks, by the names that programs use in annotations.
IncompatibleTypeInfo = Count
QoSLivelinessChangedInfo = LivelinessChanged
QoSLivelinessLostInfo = Count
QoSMessageLostInfo = Count
QoSOfferedDeadlineMissedInfo = Count
QoSOfferedIncompatibleQoSInfo = IncompatibleQoS
QoSPublisherMatchedInfo = Matched
QoSRequestedDeadlineMissedInfo = Count
QoSRequestedIncompatibleQoSInfo = IncompatibleQoS
QoSSubscriptionMatchedInfo = Matched

StatusCallback = Callable[[Any], Any]


class Watched(Protocol):
    """A writer or reader with events."""

    gid: bytes

    def notify_event(self, event: Event, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` when the status of `event` may have changed."""

    def take_event(self, event: Event) -> Status | None:
        """Return the status of `event` if it has changed, else None."""


class WatchedEvent:
    """An event of a publisher or subscription, which posts a token when its status may have changed.

    Args:
        parent: The `handle` of a publisher or subscription, or its endpoint on the wire.
        event_type: The event.

    Raises:
        UnsupportedEventTypeError: the endpoint has no such event, or the wire does not report it.
        InvalidHandle: the endpoint was destroyed.
    """

    def __init__(
        self,
        parent: Watched | Handle,
        event_type: Event | QoSPublisherEventType | QoSSubscriptionEventType,
    ) -> None:
        self._event = event_type if isinstance(event_type, Event) else _wire_event(event_type)
        self._endpoint: Watched = (
            unwrap_handle(parent).wire_endpoint if isinstance(parent, Handle) else parent
        )
        self._destroyed = False
        self._endpoint.notify_event(self._event, None)  # raises if there is no such event

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when the status has changed."""
        if not self._destroyed:
            self._endpoint.notify_event(self._event, queue, token)

    def detach(self) -> None:
        """Stop posting the token."""
        if not self._destroyed:
            self._endpoint.notify_event(self._event, None)

    def take(self) -> Any:
        """Return the status if it has changed, else None."""
        if self._destroyed:
            return None
        status = self._endpoint.take_event(self._event)
        if isinstance(status, IncompatibleQoS):
            # Imported here, because few programs have such an event.
            from tfloom.node.executing.event_types import rmw_qos_policy_kind_t

            return status._replace(last_policy_kind=rmw_qos_policy_kind_t(status.last_policy_kind))
        return status


class EventHandler(WatchedEvent, Entity):
    """Calls a callback with the status of one event each time that it changes.

    Args:
        callback_group: Group of the callback.
        callback: Called with the status, on a thread of the executor.
        event_type: The event.
        parent_impl: The `handle` of a publisher or subscription, or its endpoint on the wire.

    Raises:
        UnsupportedEventTypeError: the endpoint has no such event, or the wire does not report it.
        InvalidHandle: the endpoint was destroyed.
    """

    posts_when_attached = True

    def __init__(
        self,
        *,
        callback_group: CallbackGroup,
        callback: StatusCallback,
        event_type: Event | QoSPublisherEventType | QoSSubscriptionEventType,
        parent_impl: Watched | Handle,
    ) -> None:
        self.callback_group = callback_group
        self.callback = callback
        self.event_type = event_type
        super().__init__(parent_impl, event_type)

    def run(self, taken: Any) -> Any:
        """Call the callback with the status."""
        return self.callback(taken)

    def __enter__(self) -> Self:
        if self._destroyed:
            raise InvalidHandle("cannot use an event handler that was destroyed")
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        """Do nothing; `destroy` ends it."""

    def get_num_entities(self) -> NumberOfEntities:
        """Return that it waits for one event."""
        return NumberOfEntities(num_events=1)

    def destroy(self) -> None:
        """Take no more changes of the status."""
        self._destroyed = True


class _TypeHandler(EventHandler):
    """Calls a callback when an endpoint of this program uses the topic with another type.

    The wires don't report such peers, so those of other programs stay unnoticed.
    """

    def __init__(
        self, callback_group: CallbackGroup, callback: StatusCallback, *, is_publisher: bool
    ) -> None:
        self.callback_group = callback_group
        self._is_publisher = is_publisher
        self.callback = callback
        self._lock = threading.Lock()
        """Guards the numbers and the queue."""
        self._count = self._change = 0
        self._queue: tuple[ReadyQueue, int] | None = None
        self._destroyed = False

    if not TYPE_CHECKING:  # an attribute of the base, which most programs have no use for

        @property
        def event_type(self) -> QoSPublisherEventType | QoSSubscriptionEventType:
            """The event, by rclpy's name."""
            from tfloom.node.executing import event_types

            if self._is_publisher:
                return event_types.QoSPublisherEventType.RCL_PUBLISHER_INCOMPATIBLE_TYPE
            return event_types.QoSSubscriptionEventType.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE

    def report(self) -> None:
        """Count an endpoint of another type. Any thread may call this."""
        with self._lock:
            self._count += 1
            self._change += 1
            if self._queue is not None:
                queue, token = self._queue
                queue.post(token)

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when an endpoint was counted."""
        with self._lock:
            self._queue = (queue, token)
            queue.post(token)

    def detach(self) -> None:
        """Stop posting the token."""
        with self._lock:
            self._queue = None

    def take(self) -> Any:
        """Return how many endpoints were counted, if there are new ones, else None."""
        with self._lock:
            change, self._change = self._change, 0
            return Count(self._count, change) if change and not self._destroyed else None


_TypeHandler.__name__ = EventHandler.__name__  # which programs compare and print


def report_other_type(handlers: Iterable[EventHandler]) -> None:
    """Count an endpoint of another type in those of an endpoint's handlers that wait for one."""
    for handler in handlers:
        if isinstance(handler, _TypeHandler):
            handler.report()


def _ignore(status: Count) -> None:
    """Do nothing: the node has logged the two types when the second endpoint was created."""


def _wire_event(event_type: QoSPublisherEventType | QoSSubscriptionEventType) -> Event:
    # Imported here, because most programs have no use for rclpy's event types.
    from tfloom.node.executing.event_types import wire_event

    return wire_event(event_type)


class QoSEventHandler(EventHandler):
    """Deprecated name of EventHandler; creating one, or deriving from it, gives a warning."""

    def __init_subclass__(cls, **kwargs: Any) -> None:
        _warn_of_old_name()
        super().__init_subclass__(**kwargs)

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        _warn_of_old_name()
        super().__init__(*args, **kwargs)


def _warn_of_old_name() -> None:
    import warnings

    warnings.warn(
        "QoSEventHandler is deprecated, use EventHandler instead.", DeprecationWarning, stacklevel=3
    )


class _EventCallbacks:
    """The callbacks of one publisher or subscription, with a default for incompatible QoS."""

    is_publisher: bool
    _liveliness: Event

    def __init__(
        self,
        *,
        deadline: StatusCallback | None = None,
        liveliness: StatusCallback | None = None,
        incompatible_qos: StatusCallback | None = None,
        incompatible_type: StatusCallback | None = None,
        matched: StatusCallback | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.liveliness = liveliness
        self.incompatible_qos = incompatible_qos
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def _callbacks_by_event(self) -> dict[Event, StatusCallback | None]:
        return {
            Event.DEADLINE_MISSED: self.deadline,
            Event.INCOMPATIBLE_QOS: self.incompatible_qos,
            self._liveliness: self.liveliness,
            Event.MATCHED: self.matched,
        }

    def create_event_handlers(
        self,
        callback_group: CallbackGroup,
        endpoint: Watched,
        topic_name: str,
        *,
        logger: RcutilsLogger,
        graph: Graph,
    ) -> list[EventHandler]:
        """Return the handlers for an endpoint.

        By default, a warning is logged about peers of incompatible QoS. Of endpoints of another type the node warns
        itself.

        Raises:
            UnsupportedEventTypeError: the wire doesn't support an event that there is a callback for.
        """
        callbacks = self._callbacks_by_event()
        if self.use_default_callbacks and self.incompatible_qos is None:
            callbacks[Event.INCOMPATIBLE_QOS] = lambda status: logger.warning(
                mismatch_text(status, topic_name, endpoint.gid, graph, is_publisher=self.is_publisher)
            )
        handlers = [
            EventHandler(
                callback_group=callback_group, callback=callback, event_type=event, parent_impl=endpoint
            )
            for event, callback in callbacks.items()
            if callback is not None
        ]
        incompatible_type = self.incompatible_type or (_ignore if self.use_default_callbacks else None)
        if incompatible_type is not None:
            handlers.append(_TypeHandler(callback_group, incompatible_type, is_publisher=self.is_publisher))
        return handlers


class PublisherEventCallbacks(_EventCallbacks):
    """Callbacks for the status of a publisher's events.

    Args:
        deadline: It did not publish before its deadline.
        liveliness: It did not assert its liveliness within its lease.
        incompatible_qos: A subscription requests more than it offers.
        incompatible_type: A subscription of this program is of another type. The wires here report no others.
        matched: A subscription has connected or disconnected.
        use_default_callbacks: Whether to warn of incompatible QoS where `incompatible_qos` isn't given.
    """

    is_publisher = True
    _liveliness = Event.LIVELINESS_LOST


class SubscriptionEventCallbacks(_EventCallbacks):
    """Callbacks for the status of a subscription's events.

    Args:
        deadline: No message arrived before the deadline.
        incompatible_qos: A publisher offers less than it requests.
        liveliness: A publisher has lost or regained its liveliness.
        message_lost: Messages were lost. Cyclone reports few of them.
        incompatible_type: A publisher of this program is of another type. The wires here report no others.
        matched: A publisher has connected or disconnected.
        use_default_callbacks: Whether to warn of incompatible QoS where `incompatible_qos` isn't given.
    """

    is_publisher = False
    _liveliness = Event.LIVELINESS_CHANGED

    def __init__(
        self,
        *,
        deadline: StatusCallback | None = None,
        incompatible_qos: StatusCallback | None = None,
        liveliness: StatusCallback | None = None,
        message_lost: StatusCallback | None = None,
        incompatible_type: StatusCallback | None = None,
        matched: StatusCallback | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        super().__init__(
            deadline=deadline,
            liveliness=liveliness,
            incompatible_qos=incompatible_qos,
            incompatible_type=incompatible_type,
            matched=matched,
            use_default_callbacks=use_default_callbacks,
        )
        self.message_lost = message_lost

    def _callbacks_by_event(self) -> dict[Event, StatusCallback | None]:
        return {**super()._callbacks_by_event(), Event.MESSAGE_LOST: self.message_lost}
