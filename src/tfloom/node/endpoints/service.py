"""Servers of services, and the base that they share with clients."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Coroutine
from types import CoroutineType
from typing import TYPE_CHECKING, Any, Generic, NamedTuple

from tfloom.node.endpoints.endpoint import UNREADABLE, Receiver, TakingEndpoint
from tfloom.node.endpoints.service_introspection import Introspection, ServiceIntrospectionState
from tfloom.node.executing.task import Future
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.type_support import SrvType, SrvTypeRequest, SrvTypeResponse
from tfloom.rmw.errors import ClosedError
from tfloom.rosidl import cdr
from tfloom.rosidl.service import Service as ServiceType

if TYPE_CHECKING:
    from typing import TypeAlias

    from tfloom.node.clock.clock import Clock
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.log.rcutils_logger import RcutilsLogger
    from tfloom.rmw.base import Request, RequestId, Responder
    from tfloom.rosidl.message import Message

    ServiceCallback: TypeAlias = Callable[
        [SrvTypeRequest, SrvTypeResponse],
        SrvTypeResponse | Future[SrvTypeResponse] | Coroutine[Any, Any, SrvTypeResponse],
    ]

__all__ = ["ResponseFirst", "Service", "ServiceEndpoint", "SrvType", "SrvTypeRequest", "SrvTypeResponse"]


class ResponseFirst(NamedTuple):
    """Result of a callback's coroutine that goes on, in its callback group, after the response is sent."""

    response: Any
    go_on: Callable[[], Awaitable[Any]]


class ServiceEndpoint(Receiver[TakingEndpoint], Generic[TakingEndpoint, SrvTypeRequest, SrvTypeResponse]):
    """The base of servers and clients."""

    def __init__(
        self,
        endpoint: TakingEndpoint,
        srv_type: type[ServiceType[SrvTypeRequest, SrvTypeResponse]],
        srv_name: str,
        qos_profile: QoSProfile,
        callback_group: CallbackGroup,
        incoming_type: type[Message],
        introspection: Introspection,
        logger: RcutilsLogger,
    ) -> None:
        super().__init__(endpoint, srv_name, incoming_type, logger)
        self._introspection = introspection
        self.srv_type: type[Any] = srv_type
        self.srv_name = srv_name
        """The service's name as the program gave it; `service_name` is the full one."""
        self.qos_profile = qos_profile
        self.callback_group = callback_group

    @property
    def service_name(self) -> str:
        """The service's full name, after remapping.

        Raises:
            InvalidHandle: it was destroyed.
        """
        self._alive()
        return self._name

    def configure_introspection(
        self,
        clock: Clock,
        service_event_qos_profile: QoSProfile,
        introspection_state: ServiceIntrospectionState,
    ) -> None:
        """Publish requests and responses on `<service>/_service_event`.

        Args:
            clock: Stamps the events.
            service_event_qos_profile: QoS of the events' publisher.
            introspection_state: OFF, METADATA, or CONTENTS, with requests and responses.

        Raises:
            InvalidHandle: it was destroyed.
        """
        self._alive()
        self._introspection.configure(clock, service_event_qos_profile, introspection_state)

    def destroy(self) -> None:
        """Leave the service. Destroying again does nothing. The node no longer has it then."""
        self._introspection.close()
        super().destroy()


class Service(ServiceEndpoint["Responder", SrvTypeRequest, SrvTypeResponse]):
    """Replies to requests with the responses that its callback returns; `Node.create_service` creates one.

    The callback may return the future of a response; other callbacks of its group run until it completes. A
    coroutine, by contrast, occupies its group until it completes.
    """

    _kind = "service"
    _incoming = ("a request", "to")

    def __init__(
        self,
        service_impl: Responder,
        srv_type: type[ServiceType[SrvTypeRequest, SrvTypeResponse]],
        srv_name: str,
        callback: ServiceCallback[SrvTypeRequest, SrvTypeResponse],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
        *,
        introspection: Introspection,
        logger: RcutilsLogger,
    ) -> None:
        super().__init__(
            service_impl,
            srv_type,
            srv_name,
            qos_profile,
            callback_group,
            srv_type.Request,
            introspection,
            logger,
        )
        self._logger = logger
        self._refusal = ""
        self.callback = callback

    set_on_new_request_callback = Receiver.set_on_new_callback
    clear_on_new_request_callback = Receiver.clear_on_new_callback

    def send_response(self, response: SrvTypeResponse, header: RequestId) -> None:
        """Send the response to the request of `header`.

        Raises:
            TypeError: `response` isn't of the service's response type.
            EncodeError: the value of a field doesn't fit its type.
            InvalidHandle: the service was destroyed.
        """
        if not isinstance(response, self.srv_type.Response):
            raise TypeError(
                f"the callback of {self._name} must return a {self.srv_type.Response.__name__}, "
                f"not {type(response).__name__}"
            )
        try:
            self._endpoint.send(header, cdr.encode(response))
        except ClosedError:
            self._alive()
            raise
        self._introspection.response_sent(response, header)

    def take(self) -> Any:
        """Return the oldest request and its header, or None; see `Receiver.take`."""
        taken = super().take()
        if (
            taken is None
            and not self._destroyed
            and self._refusal != (refusal := self._endpoint.last_drop_reason())
        ):
            self._refusal = refusal
            text = f"dropped a request: {refusal}"
            self._logger.warning(text)
        return taken

    def _read(self, incoming: Request) -> Any:
        """Return a request and its header."""
        message = cdr.decode(self.srv_type.Request, incoming.data)
        self._introspection.request_received(message, incoming.id)
        return message, incoming.id

    def run(self, taken: Any) -> Any:
        """Call the callback and send the response that it returns."""
        if taken is UNREADABLE:
            return None
        request, header = taken
        response: Any = self.callback(request, self.srv_type.Response())
        if isinstance(response, CoroutineType):
            return self._send_when_done(response, header)
        if isinstance(response, Future):
            response.when_complete(lambda: self._send_result(response, header))
        else:
            self.send_response(response, header)
        return None

    def _send_result(self, future: Future[Any], header: RequestId) -> None:
        if not self._destroyed and future.done():
            response: Any = future.result()
            self.send_response(response, header)

    async def _send_when_done(self, response: Coroutine[Any, Any, Any], header: RequestId) -> None:
        outcome = await response
        if isinstance(outcome, ResponseFirst):
            self.send_response(outcome.response, header)
            await outcome.go_on()
        else:
            self.send_response(outcome, header)
