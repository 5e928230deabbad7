"""Names of rclpy's compiled module that programs use: errors, and entities for wait sets of a program's waitables."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.node.base.node_base import NodeBase, open_endpoint
from tfloom.node.context.arguments import RCLInvalidROSArgsError, UnknownROSArgsError
from tfloom.node.endpoints.endpoint import ReceivingEndpoint, TakingEndpoint
from tfloom.node.executing import event_types, guard_condition, timer
from tfloom.node.executing.event_handler import UnsupportedEventTypeError, Watched, WatchedEvent
from tfloom.node.executing.signals import SignalHandlerOptions
from tfloom.node.executing.wait_set import WaitSet
from tfloom.node.log import log_output
from tfloom.node.log.log_output import LoggingSeverity
from tfloom.node.log.rcutils_logger import ThrottledWarning
from tfloom.node.qos.qos import QoSCompatibility, QoSProfile
from tfloom.node.values.exceptions import (
    InvalidHandle,
    NodeNameNonExistentError,
    RCLError,
    TimerCancelledError,
)
from tfloom.node.values.handle import Handle, unwrap_handle
from tfloom.node.values.time import ClockType
from tfloom.node.values.type_support import (
    check_is_valid_msg_type,
    check_is_valid_srv_type,
)
from tfloom.rmw.base import Reader, Requester, Responder
from tfloom.rmw.events import AT_FIRST, Status
from tfloom.rmw.typed_names import service_of, topic_of
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from typing_extensions import Self

    from tfloom.node.clock.clock import Clock
    from tfloom.node.context.context import Context
    from tfloom.rmw.base import RequestId
    from tfloom.rosidl.message import Message
    from tfloom.rosidl.service import Service as ServiceType

__all__ = [
    "Client",
    "ClockType",
    "EventHandle",
    "GuardCondition",
    "InvalidHandle",
    "NodeNameNonExistentError",
    "QoSCompatibility",
    "RCLError",
    "RCLInvalidROSArgsError",
    "Service",
    "SignalHandlerOptions",
    "Subscription",
    "Timer",
    "TimerCancelledError",
    "UnknownROSArgsError",
    "UnsupportedEventTypeError",
    "WaitSet",
    "rclpy_logging_rcutils_log",
]


class ServiceInfo(NamedTuple):
    """The request that something belongs to, and its stamps."""

    request_id: RequestId
    source_timestamp: int
    """Time of sending [ns since epoch]."""
    received_timestamp: int
    """Time of arrival [ns since epoch]."""


class GuardCondition(guard_condition.GuardCondition):
    """A guard condition for a wait set: triggered by the program, with no callback of its own."""

    def __init__(self, context: Context | Handle) -> None:
        super().__init__(None, None, unwrap_handle(context))

    def destroy_when_not_in_use(self) -> None:
        """Stop triggering."""
        self.destroy()


class Timer(timer.Timer):
    """A timer for a wait set, with no callback of its own."""

    def __init__(
        self, clock: Clock | Handle, context: Context | Handle, period_nsec: int, autostart: bool = True
    ) -> None:
        super().__init__(
            None, None, period_nsec, unwrap_handle(clock), context=unwrap_handle(context), autostart=autostart
        )

    def call_timer(self) -> None:
        """Begin the next period.

        Raises:
            TimerCancelledError: it was cancelled.
        """
        if self.is_canceled():
            raise TimerCancelledError("cannot call a timer that was cancelled")
        self.take()

    def is_timer_ready(self) -> bool:
        """Return whether the period has ended."""
        return self.is_ready()

    def is_timer_canceled(self) -> bool:
        """Return whether it was cancelled."""
        return self.is_canceled()

    def cancel_timer(self) -> None:
        """Stop becoming ready, until `reset_timer`."""
        self.cancel()

    def reset_timer(self) -> None:
        """Begin a period now."""
        self.reset()

    def destroy_when_not_in_use(self) -> None:
        """Stop becoming ready, permanently."""
        self.destroy()


class EventHandle(WatchedEvent):
    """An event of a publisher or subscription, for a wait set.

    Args:
        parent: The `handle` of the publisher or subscription.
        event_type: A QoSPublisherEventType or QoSSubscriptionEventType.

    Raises:
        UnsupportedEventTypeError: the endpoint has no such event, or the wire does not report it.
        InvalidHandle: the publisher or subscription was destroyed.
    """

    def __init__(
        self,
        parent: Handle,
        event_type: event_types.QoSPublisherEventType | event_types.QoSSubscriptionEventType,
    ) -> None:
        endpoint: Watched = unwrap_handle(parent).wire_endpoint
        super().__init__(endpoint, event_type)
        self._next_status: Status | None = None

    def __enter__(self) -> Self:
        if self._destroyed:
            raise InvalidHandle("cannot use the handle of an event that was destroyed")
        return self

    def __exit__(self, *_: object) -> None:
        """Do nothing."""

    def deadline_ns(self) -> int | None:
        """Return None, because a change of the status posts the token."""
        return None

    def becomes_ready(self) -> bool:
        """Return whether the status has changed."""
        # The endpoint tells by handing the status out, so that is kept here for the program to take.
        if self._next_status is None:
            self._next_status = self.take()
        return self._next_status is not None

    def take_event(self) -> Status:
        """Return the status if it has changed, else one of zeros."""
        self.becomes_ready()
        status, self._next_status = self._next_status, None
        return AT_FIRST[self._event] if status is None else status

    def destroy_when_not_in_use(self) -> None:
        """Take no more changes of the status."""
        self.detach()
        self._destroyed = True


class _WaitedEndpoint(ReceivingEndpoint[TakingEndpoint]):
    """An endpoint that a wait set waits for and the program takes from; destroyed with its node."""

    def __init__(self, endpoint: TakingEndpoint, name: str, node: NodeBase) -> None:
        super().__init__(endpoint, name)
        self._warning = ThrottledWarning(node.get_logger())
        self._next_item: Any = None

    @property
    def endpoint(self) -> TakingEndpoint:
        """The endpoint on the wire."""
        return self._endpoint

    def deadline_ns(self) -> int | None:
        """Return None, because arriving data posts the token."""
        return None

    def becomes_ready(self) -> bool:
        """Return whether there is something to take."""
        # The endpoint can only tell by handing an item out, so that is kept here for the program to take.
        if self._next_item is None and not self._destroyed:
            self._next_item = self._endpoint.take()
        return self._next_item is not None

    def _take(self, message_type: type[Message]) -> tuple[Any, Any]:
        """Return the oldest item and its message, or (None, None); drop data that can't be decoded."""
        while self._alive().becomes_ready():
            incoming, self._next_item = self._next_item, None
            try:
                return incoming, cdr.decode(message_type, incoming.data)
            except cdr.DecodeError as error:
                self._warning.log(
                    f"Dropped {len(incoming.data)} bytes for the {self._kind} of {self._name} that are not a valid "
                    f"{message_type._TYPE_NAME}: {error}"  # ours
                )
        return None, None

    def destroy_when_not_in_use(self) -> None:
        """Leave the wire."""
        self.destroy()


class Subscription(_WaitedEndpoint[Reader]):
    """A subscription for a wait set."""

    _kind = "subscription"

    def __init__(
        self, node: NodeBase | Handle, pymsg_type: type[Message], topic: str, pyqos_profile: QoSProfile
    ) -> None:
        check_is_valid_msg_type(pymsg_type)
        owner = unwrap_handle(node)
        name = owner.resolve_topic_name(topic)
        wire_topic = topic_of(pymsg_type, name, is_native=pyqos_profile.avoid_ros_namespace_conventions)
        reader = open_endpoint(
            owner, self, lambda wire, whose: wire.create_reader(whose, wire_topic, pyqos_profile.to_wire())
        )
        super().__init__(reader, name, owner)

    def take_message(self, pymsg_type: type[Message], raw: bool) -> tuple[Any, dict[str, int]] | None:
        """Return the oldest message, or its bytes if `raw`, and its stamps [ns]; None if there is none."""
        if raw:
            self._alive().becomes_ready()
            incoming, self._next_item = self._next_item, None
            message = None if incoming is None else incoming.data
        else:
            incoming, message = self._take(pymsg_type)
        if incoming is None:
            return None
        return message, {
            "source_timestamp": incoming.source_stamp_ns,
            "received_timestamp": incoming.received_stamp_ns,
        }


class Service(_WaitedEndpoint[Responder]):
    """A server for a wait set."""

    _kind = "service"

    def __init__(
        self,
        node: NodeBase | Handle,
        pysrv_type: type[ServiceType],
        service_name: str,
        pyqos_profile: QoSProfile,
    ) -> None:
        check_is_valid_srv_type(pysrv_type)
        owner = unwrap_handle(node)
        name = owner.resolve_service_name(service_name)
        service = service_of(pysrv_type, name)
        responder = open_endpoint(
            owner, self, lambda wire, whose: wire.create_responder(whose, service, pyqos_profile.to_wire())
        )
        super().__init__(responder, name, owner)

    def service_take_request(self, pyrequest_type: type[Message]) -> tuple[Any, ServiceInfo | None]:
        """Return the oldest request and its header; (None, None) if there is none."""
        incoming, request = self._take(pyrequest_type)
        return request, None if incoming is None else _service_info(incoming)

    def service_send_response(self, pyresponse: Message, header: ServiceInfo) -> None:
        """Send the response to the request of a header."""
        self._alive().endpoint.send(header.request_id, cdr.encode(pyresponse))


class Client(_WaitedEndpoint[Requester]):
    """A client for a wait set."""

    _kind = "client"

    def __init__(
        self,
        node: NodeBase | Handle,
        pysrv_type: type[ServiceType],
        service_name: str,
        pyqos_profile: QoSProfile,
    ) -> None:
        check_is_valid_srv_type(pysrv_type)
        owner = unwrap_handle(node)
        name = owner.resolve_service_name(service_name)
        service = service_of(pysrv_type, name)
        requester = open_endpoint(
            owner, self, lambda wire, whose: wire.create_requester(whose, service, pyqos_profile.to_wire())
        )
        super().__init__(requester, name, owner)

    def send_request(self, pyrequest: Message) -> int:
        """Send a request and return its number."""
        return self._alive().endpoint.send(cdr.encode(pyrequest))

    def service_server_is_available(self) -> bool:
        """Return whether a server is matched in both directions, so that it receives a request sent now."""
        return self._alive().endpoint.is_ready()

    def take_response(self, pyresponse_type: type[Message]) -> tuple[ServiceInfo | None, Any]:
        """Return the header of the oldest response, and the response; (None, None) if there is none."""
        incoming, response = self._take(pyresponse_type)
        return None if incoming is None else _service_info(incoming), response


def rclpy_logging_rcutils_log(
    severity: LoggingSeverity | int,
    name: str,
    message: str,
    function_name: str,
    file_name: str,
    line_number: int,
) -> None:
    """Log a message of a place that the caller knows, if the logger `name` lets its severity through."""
    if severity >= log_output.effective_level(name):
        log_output.write(
            log_output.Record(LoggingSeverity(severity), name, message, file_name, function_name, line_number)
        )


def _service_info(incoming: Any) -> ServiceInfo:
    return ServiceInfo(incoming.id, incoming.source_stamp_ns, incoming.received_stamp_ns)
