"""Servers of services."""

from __future__ import annotations

from collections.abc import Callable, Coroutine
from types import CoroutineType
from typing import TYPE_CHECKING, Any, TypeVar

from tfloom.node.entity import Entity
from tfloom.node.exceptions import InvalidHandle
from tfloom.node.qos import QoSProfile
from tfloom.node.service_introspection import Introspection, ServiceIntrospectionState
from tfloom.node.task import Future
from tfloom.node.throttled_warning import ThrottledWarning
from tfloom.rosidl import cdr
from tfloom.rosidl.service import Service as ServiceType

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom._native import ReadyQueue
    from tfloom.node.callback_groups import CallbackGroup
    from tfloom.node.clock import Clock
    from tfloom.node.rcutils_logger import RcutilsLogger
    from tfloom.rmw.base import Request, RequestId, Responder

__all__ = ["Service", "SrvType", "SrvTypeRequest", "SrvTypeResponse"]

SrvType = TypeVar("SrvType", bound=ServiceType)
SrvTypeRequest = TypeVar("SrvTypeRequest")
SrvTypeResponse = TypeVar("SrvTypeResponse")

_UNREADABLE = object()


class Service(Entity):
    """Answers requests with what its callback returns; `Node.create_service` makes one.

    The callback may return the future of a response: others of its group run meanwhile. A coroutine, by contrast,
    keeps its group until its end.
    """

    def __init__(
        self,
        service_impl: Responder,
        srv_type: type[ServiceType],
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
        *,
        introspection: Introspection,
        logger: RcutilsLogger,
    ) -> None:
        self._responder = service_impl
        self._introspection = introspection
        self._warning = ThrottledWarning(logger)
        self._destroyed = False
        self.srv_type = srv_type
        self.srv_name = srv_name
        self.callback = callback
        self.callback_group = callback_group
        self.qos_profile = qos_profile

    @property
    def service_name(self) -> str:
        """The service's full name, after remapping."""
        return self.srv_name

    @property
    def handle(self) -> Self:
        """What stands for the library's own service: this object.

        Raises:
            InvalidHandle: the service was destroyed.
        """
        if self._destroyed:
            raise InvalidHandle(f"cannot use the service {self.srv_name}: it was destroyed")
        return self

    def configure_introspection(
        self,
        clock: Clock,
        service_event_qos_profile: QoSProfile,
        introspection_state: ServiceIntrospectionState,
    ) -> None:
        """Publish what comes and goes on `<service>/_service_event`.

        Args:
            clock: Stamps the events.
            service_event_qos_profile: What the events' publisher offers.
            introspection_state: OFF, METADATA, or CONTENTS, with requests and responses.
        """
        self._introspection.configure(clock, service_event_qos_profile, introspection_state)

    def send_response(self, response: Any, header: RequestId) -> None:
        """Answer the request of `header`.

        Raises:
            TypeError: `response` isn't of the service's response type.
            EncodeError: one of its fields holds what its type has no place for.
        """
        if not isinstance(response, self.srv_type.Response):
            raise TypeError(
                f"the callback of {self.srv_name} must return a {self.srv_type.Response.__name__}, "
                f"not {type(response).__name__}"
            )
        self._responder.send(header, cdr.encode(response))
        self._introspection.response_sent(response, header)

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when requests have come."""
        if not self._destroyed:
            self._responder.notify(queue, token)

    def detach(self) -> None:
        """Post no more."""
        if not self._destroyed:
            self._responder.notify(None)

    def take(self) -> Any:
        """Return the oldest request and its header, or None."""
        request = None if self._destroyed else self._responder.take()
        if request is None:
            return None
        try:
            message = cdr.decode(self.srv_type.Request, request.data)
        except cdr.DecodeError as error:
            self._warn(request, error)
            return _UNREADABLE
        self._introspection.request_received(message, request.id)
        return message, request.id

    def run(self, taken: Any) -> Any:
        """Call the callback and send what it returns."""
        if taken is _UNREADABLE:
            return None
        request, header = taken
        response = self.callback(request, self.srv_type.Response())
        if isinstance(response, CoroutineType):
            return self._send_later(response, header)
        if isinstance(response, Future):
            response.when_complete(lambda: self._send_result(response, header))
        else:
            self.send_response(response, header)
        return None

    def _send_result(self, future: Future[Any], header: RequestId) -> None:
        if not self._destroyed and future.done():
            self.send_response(future.result(), header)

    async def _send_later(self, response: Coroutine[Any, Any, Any], header: RequestId) -> None:
        self.send_response(await response, header)

    def _warn(self, request: Request, error: cdr.DecodeError) -> None:
        name = self.srv_type.Request._TYPE_NAME  # ours
        self._warning.log(
            f"Dropped a request of {len(request.data)} bytes to {self.srv_name} that is no valid {name}: {error}"
        )

    def destroy(self) -> None:
        """Serve no more. Destroying again does nothing. `Node.destroy_service` does it too."""
        if not self._destroyed:
            self._destroyed = True
            self._introspection.close()
            self._responder.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy()
