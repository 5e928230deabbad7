"""Clients of services."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tfloom._native import ReadyQueue
from tfloom.node.endpoints.endpoint import UNREADABLE
from tfloom.node.endpoints.service import ServiceEndpoint
from tfloom.node.endpoints.service_introspection import Introspection
from tfloom.node.endpoints.type_variables import SrvType, SrvTypeRequest, SrvTypeResponse
from tfloom.node.executing.task import Future
from tfloom.node.qos.qos import QoSProfile
from tfloom.rmw.base import RequestId
from tfloom.rmw.waiting import wait_until_ready
from tfloom.rosidl import cdr
from tfloom.rosidl.service import Service as ServiceType

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.executor import Executor
    from tfloom.node.log.rcutils_logger import RcutilsLogger
    from tfloom.rmw.base import Requester, Response

__all__ = ["Client", "SrvType", "SrvTypeRequest", "SrvTypeResponse"]


class Client(ServiceEndpoint["Requester", SrvTypeRequest, SrvTypeResponse]):
    """Calls a service; `Node.create_client` creates one.

    The executor that spins the node receives the responses.
    """

    _kind = "client"
    _incoming = ("a response", "from")

    # `run` completes a future, for which a callback of the same group may wait, and calls no callback of the program.
    goes_by_group = False

    def __init__(
        self,
        context: Context,
        client_impl: Requester,
        srv_type: type[ServiceType[SrvTypeRequest, SrvTypeResponse]],
        srv_name: str,
        qos_profile: QoSProfile,
        callback_group: CallbackGroup,
        *,
        executor: Callable[[], Executor | None],
        introspection: Introspection,
        logger: RcutilsLogger,
    ) -> None:
        super().__init__(
            client_impl,
            srv_type,
            srv_name,
            qos_profile,
            callback_group,
            srv_type.Response,
            introspection,
            logger,
        )
        self._context = context
        self._executor = executor
        self._logger = logger
        self._reported_obstacle = ""
        self._lock = threading.Lock()
        """Guards `_pending`."""
        self._pending: dict[int, Future[SrvTypeResponse]] = {}

    def call(self, request: SrvTypeRequest, timeout_sec: float | None = None) -> SrvTypeResponse | None:
        """Send a request and wait for the response. Another thread must spin the node.

        Args:
            request: The request.
            timeout_sec: The longest wait [s]; None: no limit.

        Returns:
            The response; None if it was not received in time, or before the context was shut down.

        Raises:
            TypeError: `request` isn't of the service's request type.
            RuntimeError: called from a callback of a single-threaded executor, which would block its own thread.
        """
        executor = self._executor()
        if executor is not None and executor.would_wait_for_itself():
            raise RuntimeError(
                f"Client.call of {self.srv_name} from a callback would never end, because its executor receives the "
                "response on this thread. Await call_async, or spin with a MultiThreadedExecutor"
            )
        ended = threading.Event()
        future = self.call_async(request)
        future.when_complete(ended.set)
        self._context.add_shutdown_hook(ended.set)
        try:
            if not ended.wait(timeout_sec):
                self.remove_pending_request(future)
        finally:
            self._context.remove_shutdown_hook(ended.set)
        return future.result()

    def call_async(self, request: SrvTypeRequest) -> Future[SrvTypeResponse]:
        """Send a request and return the future of its response.

        Raises:
            TypeError: `request` isn't of the service's request type.
            EncodeError: the value of a field doesn't fit its type.
            ForeignPeerError: a server uses another vendor's format and would misread the request.
            InvalidHandle: the client was destroyed.
        """
        if not isinstance(request, self.srv_type.Request):
            raise TypeError(f"Expected {self.srv_type.Request}, got {type(request)}")
        data = cdr.encode(request)
        future: Future[SrvTypeResponse] = Future()
        with self._alive()._lock:  # a response may arrive before `send` has returned  # noqa: SLF001
            number = self._endpoint.send(data)
            self._pending[number] = future
        future.when_complete(lambda: self.remove_pending_request(future))
        self._introspection.request_sent(request, RequestId(self._endpoint.client_gid, number))
        return future

    def get_pending_request(self, sequence_number: int) -> Future[SrvTypeResponse]:
        """Return the future of a pending request.

        Raises:
            KeyError: no pending request has that number.
        """
        return self._pending[sequence_number]

    def remove_pending_request(self, future: Future[SrvTypeResponse]) -> None:
        """Remove a pending request; its response will be dropped."""
        with self._lock:
            for number, pending in list(self._pending.items()):
                if pending is future:
                    del self._pending[number]

    def service_is_ready(self) -> bool:
        """Return whether a server is matched in both directions, so that it receives a request sent now."""
        if self._destroyed:
            return False
        if self._endpoint.is_ready():
            return True
        obstacle = self._endpoint.obstacle()
        if obstacle and obstacle != self._reported_obstacle:
            self._reported_obstacle = obstacle
            self._logger.warning(obstacle)
        return False

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        """Wait until a server is ready.

        Args:
            timeout_sec: The longest wait [s]; None: no limit.

        Returns:
            True if a server is ready; False after the timeout, or at shutdown.
        """
        end_s = math.inf if timeout_sec is None else time.monotonic() + timeout_sec
        queue = ReadyQueue()
        self._context.add_queue(queue)
        try:
            return wait_until_ready(
                self._endpoint, self.service_is_ready, end_s, queue=queue, is_open=self._context.ok
            )
        finally:
            self._context.remove_queue(queue)

    def _read(self, incoming: Response) -> Any:
        """Return a response and the number of its request."""
        message = cdr.decode(self.srv_type.Response, incoming.data)
        self._introspection.response_received(message, incoming.id)
        return message, incoming.id.sequence_number

    def run(self, taken: Any) -> Any:
        """Complete the future of the request with its response."""
        if taken is UNREADABLE:
            return
        message, number = taken
        with self._lock:
            future = self._pending.pop(number, None)
        if future is not None and not future.cancelled():
            future.set_executor(self._executor())
            future.set_result(message)
