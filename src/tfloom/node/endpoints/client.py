"""Clients of services."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom._native import ReadyQueue
from tfloom.common.seconds import checked_timeout
from tfloom.node.context.context import WAKE
from tfloom.node.endpoints.endpoint import UNREADABLE, Receiver
from tfloom.node.endpoints.queue_switch import QueueSwitch
from tfloom.node.endpoints.service import ServiceEndpoint
from tfloom.node.endpoints.service_introspection import Introspection
from tfloom.node.executing.entity import Entity
from tfloom.node.executing.task import Future
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.node.values.duration import S_TO_NS, Duration
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.node.values.type_support import SrvType, SrvTypeRequest, SrvTypeResponse, wrong_fields
from tfloom.rmw.base import RequestId
from tfloom.rmw.postponed_interrupt import postponed
from tfloom.rmw.shared.waiting import LOOK_AGAIN_S, wait_for_token, wait_until_ready
from tfloom.ros_imports import ros_distro
from tfloom.rosidl import cdr
from tfloom.rosidl.service import Service as ServiceType

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.executor import Executor
    from tfloom.node.executing.timer import Timer
    from tfloom.node.log.rcutils_logger import RcutilsLogger
    from tfloom.rmw.base import Requester, Response

__all__ = ["Client", "NoResponseError", "SrvType", "SrvTypeRequest", "SrvTypeResponse"]


_RESPONSE = WAKE + 1
"""The token of responses in the queue of a `call`."""
MAX_WAIT_FOR_SERVER_S = 1.0
"""How long a request waits for a server if none is there when it is made [s].

A program that has just started, or whose server has, may call before both have discovered each other.
"""
LOOK_AT_TYPES_S = 1.0
"""Period at which a client without a server looks for servers of another type [s]."""
LOOK_FOR_SERVER_S = 0.05
"""Period at which a server is looked for meanwhile [s]."""


class NoResponseError(RCLError):
    """A request gets no response: no server received it, or all that did have left the graph."""


class ResponseFuture(Future[SrvTypeResponse]):
    """The future of a response, which also tells when the server sent it."""

    source_stamp_ns: int | None = None
    """When the server sent the response, by the server's clock [ns since the epoch]; None before it is complete."""


class _Pending(NamedTuple):
    """A request without a response."""

    future: ResponseFuture[Any]
    servers: frozenset[str]
    """Ids of the servers that received it."""


class _Unsent(NamedTuple):
    """A request that waits for a server."""

    future: ResponseFuture[Any]
    request: Any
    data: bytes
    end_s: float
    """When it fails, by the steady clock [s]."""


class Client(ServiceEndpoint["Requester", SrvTypeRequest, SrvTypeResponse]):
    """Calls a service; `Node.create_client` creates one.

    The executor that spins the node receives the responses; while a thread waits in `call`, that thread does.
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
        start_timer: Callable[[float, Callable[[], None]], Timer],
        introspection: Introspection,
        logger: RcutilsLogger,
        other_type: Callable[[], str],
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
        self._other_type = other_type
        """Returns why no server is found, where those of its name have another type."""
        self._look_at_types_s = time.monotonic() + LOOK_AT_TYPES_S
        self._reported_incompatibility = ""
        """The last warning of a server that can't answer, which is logged once."""
        self._queue_switch: QueueSwitch = QueueSwitch(client_impl.notify)
        """Wakes for a response either the executor or the thread that waits in `call`."""
        self._take_lock = threading.Lock()
        """Held until the request of a response that was taken is no longer pending."""
        self._lock = threading.Lock()
        """Guards `_pending` and `_unsent`."""
        self._pending: dict[int, _Pending] = {}
        self._unsent: list[_Unsent] = []
        """The requests that wait for a server."""
        self._start_timer = start_timer
        self._timer_lock = threading.Lock()
        """Held while `unsent_timer` is created."""
        self.unsent_timer: Timer | None = None
        """Sends the unsent requests, or fails them; run by the same executor. It is started with the first of them."""
        self._reaches_later_servers = qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL
        self._was_completed_elsewhere = False
        """Whether a future was completed while the executor did not look, so that its `spin_once` is to return."""
        self._queues: list[ReadyQueue] = []
        """Queues on which no `call` waits now. They are kept, because each learns whether a busy wait is worthwhile."""
        self.server_watch = ServerWatch(self)
        """Fails requests whose servers have left; run by the same executor."""

    def call(self, request: SrvTypeRequest, timeout_sec: float | None = None) -> SrvTypeResponse | None:
        """Send a request and wait for the response, which this thread receives, whether or not an executor spins.

        Args:
            request: The request.
            timeout_sec: The longest wait [s]; None: no limit.

        Returns:
            The response; None if it was not received in time, before Kilted, or before the context was shut down.

        Raises:
            NoResponseError: without a limit, no response can arrive any more, as for `call_async`.
            TimeoutError: from Kilted on, the response was not received in time (see `ros_imports/ros_distro.py`).
            KeyboardInterrupt: Ctrl-C has shut the context down.
            TypeError: `request` isn't of the service's request type, or `timeout_sec` is not a number.
            ValueError: `timeout_sec` is NaN.
            RuntimeError: called from a callback of a single-threaded executor, which would block its own thread.
        """
        timeout_s = checked_timeout("call", timeout_sec)
        executor = self._executor()
        if executor is not None and executor.would_wait_for_itself():
            raise RuntimeError(
                f"Client.call of {self._name} from a callback would never end if a server or a callback of the "
                "same executor has to run first. Await call_async, or spin with a MultiThreadedExecutor"
            )
        future = self.call_async(request)
        is_complete = self._wait_for(future, timeout_s)
        # A Ctrl-C may have come where no exception could be raised, as in a callback of the wire's library.
        if not self._context.ok() and postponed.take():
            raise KeyboardInterrupt
        if not is_complete:
            self.remove_pending_request(future)
            if ros_distro.CALL_RAISES_AT_TIMEOUT and self._context.ok():
                raise TimeoutError
            return None
        if not self._context.ok() and future.exception() is not None:
            return None
        return future.result() if future.done() else None

    def _wait_for(self, future: Future[Any], timeout_s: float | None) -> bool:
        """Receive responses until a future is complete or the context shut down; return False after `timeout_s` [s].

        The servers are looked up from time to time, because their departure is announced to the executor alone, which
        may not spin. With a limit, the wait for a response that can't arrive takes as long as for one that may.
        """
        is_ended = False
        # Each thread that waits has its own queue, which no other `call` uses meanwhile. `pop` is one operation,
        # so two threads never get the same queue.
        try:
            queue = self._queues.pop()
        except IndexError:
            queue = ReadyQueue()

        def end() -> None:
            nonlocal is_ended
            # With a limit, a NoResponseError doesn't end the wait, which takes its time as the docstring tells.
            if timeout_s is None or future.exception() is None:
                is_ended = True
                queue.post(WAKE)

        end_s = math.inf if timeout_s is None else time.monotonic() + timeout_s
        self._context.add_queue(queue)
        # From here on responses wake this thread and not the executor. One that has arrived before posts at once.
        self._queue_switch.divert(queue, _RESPONSE)
        try:
            # If the future is complete already, because an executor was faster or no server was there, `end` is called
            # here.
            future.when_complete(end)
            look_s = time.monotonic() + LOOK_AGAIN_S
            while not is_ended and self._context.ok():
                now_s = time.monotonic()
                if now_s >= end_s:
                    return False
                if now_s >= look_s:
                    look_s = now_s + LOOK_AGAIN_S
                    self.send_unsent()
                    orphans = self.take_orphans(future)
                    self.fail_orphans(orphans)
                    # The futures of other threads and of `call_async` have just failed on this thread: the executor's
                    # `spin_once` must return, so that the program looks at them.
                    if any(orphan is not future for orphan in orphans):
                        self._tell_executor()
                wait_for_token(queue, min(end_s, look_s))
                self._run_responses(future)
            return True
        finally:
            # A response may have arrived after the last look. `restore` makes the endpoint post at once, to the next
            # thread that waits or to the executor, if something is left.
            self._queue_switch.restore(queue)
            self._context.remove_queue(queue)
            self._queues.append(queue)

    set_on_new_response_callback = Receiver.set_on_new_callback
    clear_on_new_response_callback = Receiver.clear_on_new_callback

    def _notify(self, queue: ReadyQueue | None, token: int) -> None:
        self._queue_switch.attach(queue, token)  # of responses that no `call` receives
        if self._was_completed_elsewhere:
            self._queue_switch.post()

    def call_async(self, request: SrvTypeRequest) -> Future[SrvTypeResponse]:
        """Send a request and return the future of its response.

        A request waits for `MAX_WAIT_FOR_SERVER_S` if no server is there. The future's exception is a NoResponseError
        if none comes, or if all that received the request leave without a response. It is cancelled when the client is
        destroyed.

        Raises:
            TypeError: `request` isn't of the service's request type.
            EncodeError: the value of a field doesn't fit its type.
            ForeignPeerError: a server uses another vendor's format and would misread the request.
            CongestedError: `rmw.services.MAX_HELD` requests wait for servers that do not take them.
            InvalidHandle: the client was destroyed.
            ForkedProcessError: this process is a fork of the one that created the client.
        """
        if not isinstance(request, self.srv_type.Request):
            written = f"{self.srv_type.__name__}.Request"
            raise TypeError(wrong_fields(self.srv_type.Request, request, "send a request", written))
        self._context.check_not_from_parent_process(f"cannot call {self._name}")
        data = cdr.encode(request)
        future: ResponseFuture[SrvTypeResponse] = ResponseFuture()
        self._alive()
        with self._lock:  # a response may arrive before `send` has returned
            # A server that leaves from here on is noticed by the watch, which waits for the lock.
            servers = self._endpoint.receiving_servers()
            # Where a server is there that would misread it, sending raises.
            is_sent = bool(servers or self._reaches_later_servers or self._endpoint.incompatibility())
            if is_sent:
                number = self._endpoint.send(data)
                self._pending[number] = _Pending(future, servers)
            elif self._context.ok():
                end_s = time.monotonic() + MAX_WAIT_FOR_SERVER_S
                self._unsent.append(_Unsent(future, request, data, end_s))
        if is_sent:
            self._note_sent(future, request, number)
        elif not self._context.ok():
            self.remove_pending_request(future)  # if the shutdown came just now
            self._fail(future, "the context was shut down")
        else:
            self._run_unsent_timer()
        return future

    def _run_unsent_timer(self) -> None:
        with self._timer_lock:
            if self.unsent_timer is None:
                self.unsent_timer = self._start_timer(LOOK_FOR_SERVER_S, self.send_unsent)
                return
        with suppress(InvalidHandle):  # the client has just been destroyed
            self.unsent_timer.reset()

    def _note_sent(self, future: Future[Any], request: Any, number: int) -> None:
        future.when_complete(lambda: self._remove(number))
        self._introspection.request_sent(request, RequestId(self._endpoint.client_gid, number))

    def send_unsent(self) -> None:
        """Send the requests that wait for a server, if there is one now; fail those that have waited for too long."""
        sent: list[tuple[_Unsent, int]] = []
        expired: list[_Unsent] = []
        failed: list[tuple[_Unsent, Exception]] = []
        with self._lock:  # as in `call_async`
            servers = frozenset() if self._destroyed else self._endpoint.receiving_servers()
            now_s = time.monotonic()
            for unsent in self._unsent if servers else ():
                if unsent.future.cancelled():
                    continue
                try:
                    number = self._endpoint.send(unsent.data)
                except Exception as error:  # as `call_async` would have raised it
                    failed.append((unsent, error))
                    continue
                self._pending[number] = _Pending(unsent.future, servers)
                sent.append((unsent, number))
            if servers:
                self._unsent.clear()
            else:
                expired = [unsent for unsent in self._unsent if unsent.end_s <= now_s]
                self._unsent = [unsent for unsent in self._unsent if unsent.end_s > now_s]
            if not self._unsent and self.unsent_timer is not None:
                with suppress(InvalidHandle):
                    self.unsent_timer.cancel()
        # Futures call functions of the program, so none is completed under the lock.
        for unsent, number in sent:
            self._note_sent(unsent.future, unsent.request, number)
        for unsent, reason in failed:
            unsent.future.set_executor(self._executor())
            unsent.future.set_exception(reason)
        for unsent in expired:
            if not unsent.future.cancelled():
                why = self._other_type() or "no server came. Call wait_for_service first"
                self._fail(unsent.future, why)

    def get_pending_request(self, sequence_number: int) -> Future[SrvTypeResponse]:
        """Return the future of a pending request.

        Raises:
            KeyError: no pending request has that number.
        """
        return self._pending[sequence_number].future

    def remove_pending_request(self, future: Future[SrvTypeResponse]) -> None:
        """Remove a pending request; its response will be dropped. If it was not sent yet, it never is."""
        with self._lock:
            self._unsent = [unsent for unsent in self._unsent if unsent.future is not future]
            numbers = [number for number, pending in self._pending.items() if pending.future is future]
        for number in numbers:
            self._remove(number)

    def _remove(self, number: int) -> None:
        with self._lock:
            pending = self._pending.pop(number, None)
        if pending is not None:  # without a response: it was cancelled, or nobody waits for it any longer
            self._endpoint.give_up([number])

    def _fail(self, future: Future[Any], why: str) -> None:
        future.set_executor(self._executor())
        future.set_exception(NoResponseError(f"no response from {self._name}: {why}"))

    def belongings(self) -> Sequence[Entity]:
        """Return what looks for servers, and what sends the requests that wait for one."""
        return [self.server_watch] if self.unsent_timer is None else [self.server_watch, self.unsent_timer]

    def take_orphans(self, own: Future[Any] | None = None) -> list[Future[Any]]:
        """Remove the requests whose servers have all left without a response, and return their futures.

        Responses that have arrived are received before; for `own`, see `_run_responses`.
        """
        if self._destroyed:
            return []
        with self._lock:  # later requests may have servers that come after the look at those that are there
            requests = list(self._pending.items())
        connected = self._endpoint.connected_servers() if requests else frozenset()
        # A response precedes the departure of its server, so those of all that have left are here now.
        self._run_responses(own)
        with self._lock:
            orphans = [
                (number, pending.future)
                for number, pending in requests
                if pending.servers
                and pending.servers.isdisjoint(connected)
                and self._pending.pop(number, None) is not None
            ]
        # Before the futures fail: the next server must not receive what the program is told has failed.
        if orphans:
            self._endpoint.give_up([number for number, _ in orphans], is_lost=True)
        return [future for _, future in orphans if not future.cancelled()]

    def fail_orphans(self, orphans: list[Future[Any]]) -> None:
        """Complete the futures of requests whose servers have left."""
        for future in orphans:
            self._fail(future, "its server left the graph without one")

    def destroy(self) -> None:
        """Leave the service, and cancel the futures of all pending requests."""
        super().destroy()
        with self._lock:
            futures = [pending.future for pending in self._pending.values()]
            futures += [unsent.future for unsent in self._unsent]
            self._pending = {}
            self._unsent = []
        for future in futures:
            future.cancel()

    @property
    def context(self) -> Context:
        """The context of its node."""
        return self._context

    def service_is_ready(self) -> bool:
        """Return whether a server is matched in both directions, so that it receives a request sent now.

        Raises:
            InvalidHandle: the client was destroyed.
        """
        self._alive()
        self._context.check_not_from_parent_process(f"cannot find a server of {self._name}")
        if self._endpoint.is_ready():
            return True
        incompatibility = self._endpoint.incompatibility()
        if not incompatibility and time.monotonic() >= self._look_at_types_s:
            self._look_at_types_s = time.monotonic() + LOOK_AT_TYPES_S
            incompatibility = self._other_type()
        if incompatibility and incompatibility != self._reported_incompatibility:
            self._reported_incompatibility = incompatibility
            self._logger.warning(incompatibility)
        return False

    def wait_for_service(self, timeout_sec: float | Duration | None = None) -> bool:
        """Wait until a server is ready.

        Args:
            timeout_sec: The longest wait [s]; None: no limit.

        Returns:
            True if a server is ready; False after the timeout, or at shutdown.

        Raises:
            TypeError: `timeout_sec` is not a number.
            ValueError: it is NaN.
            InvalidHandle: the client was destroyed.
        """
        if isinstance(timeout_sec, Duration):
            timeout_sec = timeout_sec.nanoseconds / S_TO_NS
        timeout_s = checked_timeout("wait_for_service", timeout_sec)
        end_s = math.inf if timeout_s is None else time.monotonic() + timeout_s
        queue = ReadyQueue()
        self._context.add_queue(queue)
        try:
            return wait_until_ready(
                self._endpoint, self.service_is_ready, end_s, queue=queue, is_open=self._context.ok
            )
        finally:
            self._context.remove_queue(queue)

    def _run_responses(self, own: Future[Any] | None) -> None:
        """Complete the futures of all requests whose responses have arrived.

        For all but `own`, the future of the calling thread, the executor is told, because its `spin_once` returns after
        a response: programs check between two calls of it whether their future is done.
        """
        is_for_others = False
        while (taken := self._take_next()) is not None:
            self.run(taken)
            is_for_others |= taken is not UNREADABLE and taken[1] is not None and taken[1].future is not own
        if is_for_others:
            self._tell_executor()

    def _tell_executor(self) -> None:
        self._was_completed_elsewhere = True
        self._queue_switch.post()

    def _take_next(self) -> Any:
        # Another thread that looks for orphans must not see the request of a response that is between the reader and
        # `_read`: it would fail a request that was answered.
        with self._take_lock:
            return super().take()

    def take(self) -> Any:
        """Remove the oldest response and return it as `run` takes it, `UNREADABLE`, or None.

        After a response that was received elsewhere, return `UNREADABLE` once.
        """
        taken = self._take_next()
        # A thread in `call` has completed a future that this executor's program may wait for. `UNREADABLE` runs
        # nothing, but it counts as a response, so that `spin_once` returns.
        if taken is None and self._was_completed_elsewhere:
            self._was_completed_elsewhere = False
            return UNREADABLE
        return taken

    def _read(self, incoming: Response) -> Any:
        """Return a response and its request, which is pending no longer; None instead of one that was given up."""
        message = cdr.decode(self.srv_type.Response, incoming.data)
        self._introspection.response_received(message, incoming.id)
        with self._lock:
            pending = self._pending.pop(incoming.id.sequence_number, None)
        if pending is not None:
            pending.future.source_stamp_ns = incoming.source_stamp_ns
        return message, pending

    def run(self, taken: Any) -> Any:
        """Complete the future of the request with its response."""
        if taken is UNREADABLE:
            return
        message, pending = taken
        if pending is not None and not pending.future.cancelled():
            pending.future.set_executor(self._executor())
            pending.future.set_result(message)


class ServerWatch(Entity):
    """Sends the requests of a client that wait for a server, and fails those whose servers have all left the graph."""

    goes_by_group = False
    callback_group = None

    def __init__(self, client: Client[Any, Any]) -> None:
        self._client = client
        self.stands_for = client

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when a server may have left."""
        if not self._client.is_destroyed:
            self._client.wire_endpoint.watch_servers(queue, token)

    def detach(self) -> None:
        """Stop posting the token."""
        if not self._client.is_destroyed:
            self._client.wire_endpoint.watch_servers(None)

    def take(self) -> Any:
        """Return the requests without a server, after the responses that have arrived; None if there are none."""
        self._client.send_unsent()
        orphans = self._client.take_orphans()
        return orphans or None

    def run(self, taken: Any) -> None:
        """Complete the futures of these requests with a NoResponseError."""
        self._client.fail_orphans(taken)

    def destroy(self) -> None:
        """Do nothing, because the client leaves the service."""
