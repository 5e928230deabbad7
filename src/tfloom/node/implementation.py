"""The names of rclpy's compiled half that programs reach for: errors, and what waitables of their own wait for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.node import guard_condition, timer
from tfloom.node.clock import ClockType
from tfloom.node.endpoint import Endpoint, TakingEnd
from tfloom.node.event_handler import UnsupportedEventTypeError
from tfloom.node.exceptions import (
    InvalidHandle,
    NodeNameNonExistentError,
    RCLError,
    RCLInvalidROSArgsError,
    TimerCancelledError,
    UnknownROSArgsError,
)
from tfloom.node.handle import Handle, thing_of
from tfloom.node.qos import QoSCompatibility, QoSProfile
from tfloom.node.signals import SignalHandlerOptions
from tfloom.node.throttled_warning import ThrottledWarning
from tfloom.node.type_support import (
    check_is_valid_msg_type,
    check_is_valid_srv_type,
)
from tfloom.node.wait_set import WaitSet
from tfloom.rmw.base import Reader, Requester, Responder
from tfloom.rmw.typed_names import service_of, topic_of
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from tfloom._native import ReadyQueue
    from tfloom.node.clock import Clock
    from tfloom.node.context import Context
    from tfloom.node.node import Node
    from tfloom.rmw.base import RequestId
    from tfloom.rosidl.message import Message
    from tfloom.rosidl.service import Service as ServiceType

__all__ = [
    "Client",
    "ClockType",
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
]


class ServiceInfo(NamedTuple):
    """Which request something belongs to, and when it came."""

    request_id: RequestId
    source_timestamp: int
    """When it was sent [ns since epoch]."""
    received_timestamp: int
    """When it came [ns since epoch]."""


class GuardCondition(guard_condition.GuardCondition):
    """A guard condition for a wait set: triggered by the program, with no callback of its own."""

    def __init__(self, context: Context | Handle) -> None:
        super().__init__(None, None, thing_of(context))

    def destroy_when_not_in_use(self) -> None:
        """Trigger no more."""
        self.destroy()


class Timer(timer.Timer):
    """A timer for a wait set, with no callback of its own."""

    def __init__(
        self, clock: Clock | Handle, context: Context | Handle, period_nsec: int, autostart: bool = True
    ) -> None:
        super().__init__(
            None, None, period_nsec, thing_of(clock), context=thing_of(context), autostart=autostart
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
        """Return whether the period is over."""
        return self.is_ready()

    def is_timer_canceled(self) -> bool:
        """Return whether it was cancelled."""
        return self.is_canceled()

    def cancel_timer(self) -> None:
        """Become ready no more, until `reset_timer`."""
        self.cancel()

    def reset_timer(self) -> None:
        """Begin a period now."""
        self.reset()

    def destroy_when_not_in_use(self) -> None:
        """Become ready no more, for good."""
        self.destroy()


class _WaitedEnd(Endpoint[TakingEnd]):
    """An end on the wire that a wait set waits for, and the program takes from. Its node's end is its own."""

    def __init__(self, endpoint: TakingEnd, name: str, node: Node) -> None:
        super().__init__(endpoint, name)
        self._warning = ThrottledWarning(node.get_logger())
        self._seen: Any = None

    @property
    def endpoint(self) -> TakingEnd:
        """The end on the wire."""
        return self._endpoint

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when something has come."""
        if not self._destroyed:
            self._endpoint.notify(queue, token)

    def detach(self) -> None:
        """Post no more."""
        if not self._destroyed:
            self._endpoint.notify(None)

    def deadline_ns(self) -> int | None:
        """Return None: a post tells."""
        return None

    def becomes_ready(self) -> bool:
        """Return whether there is something to take."""
        if self._seen is None and not self._destroyed:
            self._seen = self._endpoint.take()
        return self._seen is not None

    def _take(self, message_type: type[Message]) -> tuple[Any, Any]:
        """Return the oldest thing that came and the message in it, or None twice; what can't be read is dropped."""
        while self._alive().becomes_ready():
            came, self._seen = self._seen, None
            try:
                return came, cdr.decode(message_type, came.data)
            except cdr.DecodeError as error:
                self._warning.log(
                    f"Dropped {len(came.data)} bytes for the {self._kind} of {self._name} that are no valid "
                    f"{message_type._TYPE_NAME}: {error}"  # ours
                )
        return None, None

    def destroy_when_not_in_use(self) -> None:
        """Leave the wire."""
        self.destroy()


class Subscription(_WaitedEnd[Reader]):
    """A subscription for a wait set."""

    _kind = "subscription"

    def __init__(
        self, node: Node | Handle, pymsg_type: type[Message], topic: str, pyqos_profile: QoSProfile
    ) -> None:
        check_is_valid_msg_type(pymsg_type)
        owner = thing_of(node)
        name = owner.resolve_topic_name(topic)
        wire_topic = topic_of(pymsg_type, name, is_native=pyqos_profile.avoid_ros_namespace_conventions)
        reader = owner._open(  # noqa: SLF001  # the one door for what no executor runs
            self, lambda wire, whose: wire.create_reader(whose, wire_topic, pyqos_profile.to_wire())
        )
        super().__init__(reader, name, owner)

    def take_message(self, pymsg_type: type[Message], raw: bool) -> tuple[Any, dict[str, int]] | None:
        """Return the oldest message, or its bytes if `raw`, and its stamps [ns]; None if there is none."""
        if raw:
            self._alive().becomes_ready()
            came, self._seen = self._seen, None
            message = None if came is None else came.data
        else:
            came, message = self._take(pymsg_type)
        if came is None:
            return None
        return message, {
            "source_timestamp": came.source_stamp_ns,
            "received_timestamp": came.received_stamp_ns,
        }


class Service(_WaitedEnd[Responder]):
    """A server for a wait set."""

    _kind = "service"

    def __init__(
        self, node: Node | Handle, pysrv_type: type[ServiceType], service_name: str, pyqos_profile: QoSProfile
    ) -> None:
        check_is_valid_srv_type(pysrv_type)
        owner = thing_of(node)
        name = owner.resolve_service_name(service_name)
        service = service_of(pysrv_type, name)
        responder = owner._open(  # noqa: SLF001
            self, lambda wire, whose: wire.create_responder(whose, service, pyqos_profile.to_wire())
        )
        super().__init__(responder, name, owner)

    def service_take_request(self, pyrequest_type: type[Message]) -> tuple[Any, ServiceInfo | None]:
        """Return the oldest request and its header; None twice if there is none."""
        came, request = self._take(pyrequest_type)
        return request, None if came is None else _info(came)

    def service_send_response(self, pyresponse: Message, header: ServiceInfo) -> None:
        """Answer the request of a header."""
        self._alive().endpoint.send(header.request_id, cdr.encode(pyresponse))


class Client(_WaitedEnd[Requester]):
    """A client for a wait set."""

    _kind = "client"

    def __init__(
        self, node: Node | Handle, pysrv_type: type[ServiceType], service_name: str, pyqos_profile: QoSProfile
    ) -> None:
        check_is_valid_srv_type(pysrv_type)
        owner = thing_of(node)
        name = owner.resolve_service_name(service_name)
        service = service_of(pysrv_type, name)
        requester = owner._open(  # noqa: SLF001
            self, lambda wire, whose: wire.create_requester(whose, service, pyqos_profile.to_wire())
        )
        super().__init__(requester, name, owner)

    def send_request(self, pyrequest: Message) -> int:
        """Send a request and return its number."""
        return self._alive().endpoint.send(cdr.encode(pyrequest))

    def service_server_is_available(self) -> bool:
        """Return whether a server is there that will hear a request sent now."""
        return self._alive().endpoint.is_ready()

    def take_response(self, pyresponse_type: type[Message]) -> tuple[ServiceInfo | None, Any]:
        """Return the oldest response's header and the response; None twice if there is none."""
        came, response = self._take(pyresponse_type)
        return None if came is None else _info(came), response


def _info(came: Any) -> ServiceInfo:
    return ServiceInfo(came.id, came.source_stamp_ns, came.received_stamp_ns)
