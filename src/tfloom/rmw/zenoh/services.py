"""Clients and servers on the Zenoh wire: a request is a query, and a response is its reply."""

from __future__ import annotations

import math
import time
from collections import OrderedDict, deque
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any, NamedTuple

from tfloom._native import ReadyQueue
from tfloom.common.signals import signals_deferred
from tfloom.common.terminal import shown_part
from tfloom.rmw.base import NodeName, Request, RequestId, Response, Service
from tfloom.rmw.errors import ForeignPeerError, WireError
from tfloom.rmw.postponed_interrupt import uninterrupted_files
from tfloom.rmw.qos import QoS
from tfloom.rmw.services import waiting_qos
from tfloom.rmw.typed_names import GET_RESULT
from tfloom.rmw.zenoh.config import reason_of
from tfloom.rmw.zenoh.end import ZenohEnd
from tfloom.rmw.zenoh.endpoints import HEADER_SIZE
from tfloom.rmw.zenoh.events import Timers
from tfloom.rmw.zenoh.graph import Peer, ZenohGraph, peer_name
from tfloom.rmw.zenoh.library import open_library
from tfloom.rmw.zenoh.tokens import Kind, pack_attachment, unpack_attachment

__all__ = ["ServiceEndpoint", "ZenohRequester", "ZenohResponder"]

ENDLESS_S = 1e9
"""How long a result of an action is awaited [s]; Zenoh has no word for an endless wait."""
ROUTE_WAIT_S = 0.5
"""The longest wait for the route to a server whose token has come before it [s]."""
POLL_S = 0.001
MAX_POLL_S = 0.1
"""The times between two looks for a route, at first and after some while [s]."""
MAX_WAIT_FOR_END_S = 60.0
"""How long a response is awaited from a server that has left, while Zenoh tells nothing of the request's end [s]."""


class ServiceEndpoint(NamedTuple):
    """What a client or server is opened with."""

    gid: bytes
    node: NodeName
    service: Service
    qos: QoS
    timers: Timers


class _ServiceEnd(ZenohEnd):
    """The common part of clients and servers."""

    peer_kind: Kind
    """What the graph tells it of."""

    def __init__(self, endpoint: ServiceEndpoint, graph: ZenohGraph, forget: Callable[[Any], None]) -> None:
        super().__init__(endpoint.gid, endpoint.service.name, self.peer_kind, graph, forget)
        self.node = endpoint.node
        self.qos = endpoint.qos
        self._service = endpoint.service
        self._timers = endpoint.timers
        self._listener: tuple[ReadyQueue, int] | None = None
        self._depth = waiting_qos(self.qos, is_client=self.kind == "client").depth

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take, at once if there already is; None ends it."""
        if queue is not None:
            self._check_process()
        with self._lock:
            self._listener = None if queue is None else (queue, token)
            if queue is not None and self._has_waiting():
                queue.post(token)

    def _has_waiting(self) -> bool:
        raise NotImplementedError

    def _post(self) -> None:
        if self._listener is not None:
            self._listener[0].post(self._listener[1])

    def _is_same_type(self, peer: Peer) -> bool:
        mine = self._service
        return peer.end.type_name == mine.type_name and peer.end.type_hash == mine.type_hash

    def _difference(self, peer: Peer, other: str) -> str:
        mine = self._service
        theirs = f"{peer.end.type_name} {peer.end.type_hash or 'without a hash'}"
        return (
            f"{other} of {mine.name}, {peer_name(peer)}, has another definition of its type: "
            f"{shown_part(theirs)} there, {mine.type_name} {mine.type_hash} here"
        )


class ZenohRequester(_ServiceEnd):
    """A client; see `base.Requester`."""

    kind = "client"
    peer_kind = Kind.SERVER

    def __init__(self, endpoint: ServiceEndpoint, graph: ZenohGraph, forget: Callable[[Any], None]) -> None:
        super().__init__(endpoint, graph, forget)
        self.client_gid = self.gid
        self._sequence_number = 0
        self._responses: deque[Response] = deque(maxlen=self._depth)
        self._servers: frozenset[str] = frozenset()
        """Ids of the servers of this type. Replaced, never changed, under the graph's lock."""
        self._others: dict[bytes, str] = {}
        """Why each server of another type has no use, by its gid; replaced likewise."""
        self._open: dict[int, frozenset[str]] = {}
        """The servers of each request whose end Zenoh hasn't told, by its number. Guarded by the own lock."""
        self._end_timers: dict[str, int] = {}
        """The timer that ends the wait for a server that has left, by its id. Guarded by the own lock."""
        self._querier: Any = None
        self._is_awaiting_route = False
        """Whether a timer looks for the route to a server, which may be on the graph before."""
        self._ready: tuple[ReadyQueue, int] | None = None
        self._watch: tuple[ReadyQueue, int] | None = None
        """The queue and token of `watch_servers`."""

    def declare(self, session: Any, key: str) -> Any:
        """Open the querier of Zenoh, and return it."""
        zenoh = open_library()
        options = {"timeout": ENDLESS_S} if self._service.name.endswith(GET_RESULT) else {}
        self._querier = session.declare_querier(
            key,
            target=zenoh.QueryTarget.ALL_COMPLETE,
            consolidation=zenoh.ConsolidationMode.NONE,
            **options,
        )
        return self._querier

    def add_peer(self, peer: Peer) -> Callable[[], None] | None:
        """Note a server that was discovered, or why it is none for this client."""
        is_same_type = self._is_same_type(peer)
        if is_same_type:
            server = peer.gid.hex()
            self._servers = self._servers | {server}
            self._end_limit(server)
        else:
            self._others = {**self._others, peer.gid: self._difference(peer, "a server")}
        self._post_ready()
        return self._tell_of_route if is_same_type else None

    def _tell_of_route(self) -> None:
        """Post readiness once there is a route to the servers.

        Zenoh has a listener for this, but calls it on the threads that also end a publisher's heartbeat. For that end
        Zenoh waits up to 10 s without releasing the GIL: in vain, if listeners in Python keep them waiting for it.
        """
        if self._is_awaiting_route or self._is_closed:
            return
        if self._has_route():  # it may have come after the waiters were notified of the server
            self._post_ready()
            return
        self._is_awaiting_route = True
        begun_s = time.monotonic()
        try:
            self._timers.add(begun_s + POLL_S, lambda now_s: self._look_for_route(now_s, begun_s))
        except RuntimeError:  # the system has no thread
            self._is_awaiting_route = False
            self._await_route()
            self._post_ready()

    def _look_for_route(self, now_s: float, begun_s: float) -> float:
        """Post readiness if there is a route, or no server any more. Return when to look again [s]."""
        # Before the look, so that a server that comes meanwhile is either seen by it or starts its own timer.
        self._is_awaiting_route = False
        if self._is_closed or not self._servers or self._has_route():
            self._post_ready()
            return math.inf
        self._is_awaiting_route = True
        # Ever more seldom: a server whose route never comes would cost a part of a core.
        return now_s + min(max(POLL_S, (now_s - begun_s) / 8), MAX_POLL_S)

    def remove_peer(self, peer: Peer) -> Callable[[], None] | None:
        """Note a server that has left. What it sent before may come after this news, which Zenoh sends first."""
        server = peer.gid.hex()
        self._servers = self._servers - {server}
        self._others = {gid: text for gid, text in self._others.items() if gid != peer.gid}
        self._post_ready()
        with self._lock:
            is_asked = any(server in servers for servers in self._open.values())
        return (lambda: self._limit_wait_for(server)) if is_asked else None

    def _limit_wait_for(self, server: str) -> None:
        """End the wait for responses of a server that has left, after some time.

        Zenoh reports a request's end as soon as its servers have dropped it, or their links are lost. A program of
        another kind may leave the graph and keep it.
        """
        end_s = time.monotonic() + MAX_WAIT_FOR_END_S
        try:
            number = self._timers.add(end_s, lambda _now_s: self._end_wait_for(server))
        except RuntimeError:  # the system has no thread
            self._end_wait_for(server)
            return
        with self._lock:
            self._end_timers[server] = number
        if server in self._servers or self._is_closed:  # it has returned meanwhile
            self._end_limit(server)

    def _end_limit(self, server: str) -> None:
        """Wait without a limit for responses of a server that has returned, as behind a router that began anew."""
        with self._lock:
            number = self._end_timers.pop(server, None)
        if number is not None:
            self._timers.remove(number)

    def _end_wait_for(self, server: str) -> float:
        """Expect no response of a server that has left; return that it is done once [s]."""
        with self._lock:
            self._end_timers.pop(server, None)
            if server in self._servers:  # it has returned while the timer's thread came here
                return math.inf
            for number, servers in self._open.items():
                self._open[number] = servers - {server}
        self._post_ready()
        return math.inf

    def _post_ready(self) -> None:
        if (ready := self._ready) is not None:
            ready[0].post(ready[1])

    def _has_waiting(self) -> bool:
        return bool(self._responses)

    def send(self, data: bytes) -> int:
        """Send a request and return its sequence number.

        Raises:
            ForeignPeerError: the servers have another definition of the service's type.
            ClosedError: the requester is closed.
            WireError: Zenoh refuses the request.
        """
        self._check_open("send a request")
        if text := self.incompatibility():
            raise ForeignPeerError(text)
        self._await_route()
        with self._lock:
            self._sequence_number += 1
            number = self._sequence_number
            self._open[number] = self._servers
        zenoh = open_library()
        try:
            with signals_deferred():  # a server of this session is called within it
                self._querier.get(
                    zenoh.handlers.Callback(self._on_reply, partial(self._on_end, number), indirect=False),
                    payload=bytes(data),
                    attachment=pack_attachment(number, self.gid),
                )
        except zenoh.ZError as error:
            self._check_open("send a request")
            raise WireError(f"cannot send a request to {self._service.name}: {reason_of(error)}") from None
        return number

    def _await_route(self) -> None:
        """Wait, for a short time, for the route to a server that is on the graph."""
        if not self.is_synchronising():
            return
        end_s = time.monotonic() + ROUTE_WAIT_S
        while self.is_synchronising() and time.monotonic() < end_s and not self._is_closed:
            time.sleep(POLL_S)

    def _on_reply(self, reply: Any) -> None:
        """Queue a response; called on a thread of Zenoh. The end of the wait, or no server, is not a response."""
        sample = reply.ok
        if sample is None:
            return
        header = unpack_attachment(sample.attachment)
        if header is None or header.gid != self.gid:
            return
        data = sample.payload.to_bytes()
        if len(data) < HEADER_SIZE:
            return
        request_id = RequestId(self.gid, header.sequence_number)
        response = Response(data, request_id, header.source_stamp_ns, time.time_ns())
        with self._lock:
            if self._is_closed or not 0 < header.sequence_number <= self._sequence_number:
                return
            self._responses.append(response)
            self._post()

    def _on_end(self, number: int) -> None:
        """Note that no further response comes to a request; called on a thread of Zenoh, or within `send`."""
        with self._lock:
            servers = self._open.pop(number, None)
        if servers and not servers <= self._servers:
            self._post_ready()

    def take(self) -> Response | None:
        """Remove and return the oldest waiting response, or None."""
        self._check_process()
        with self._lock:
            return self._responses.popleft() if self._responses else None

    def give_up(
        self,
        sequence_numbers: Iterable[int],
        *,
        is_lost: bool = False,
    ) -> None:
        """Await no response to these requests any longer; one that comes nevertheless is the client's to drop."""
        with self._lock:
            for number in sequence_numbers:
                self._open.pop(number, None)

    def notify_ready(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `is_ready` may have changed, and once at the start; None ends it."""
        # As on DDS: a wait for readiness takes the place of `watch_servers`, which has it back afterwards.
        if queue is not None:
            self._check_process()
        ready = self._watch if queue is None else (queue, token)
        self._ready = ready
        if ready is not None:
            ready[0].post(ready[1])

    def watch_servers(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when a server may have come or left, and once at the start; None ends it."""
        self._watch = None if queue is None else (queue, token)
        self.notify_ready(queue, token)

    def is_ready(self) -> bool:
        """Return whether there is a server, and the route to it."""
        self._check_process()
        return bool(self._servers) and not self._is_closed and self._has_route()

    def is_synchronising(self) -> bool:
        """Return whether there is a server, and no route to it yet."""
        self._check_process()
        return bool(self._servers) and not self._is_closed and not self._has_route()

    def _has_route(self) -> bool:
        try:
            return bool(self._querier.matching_status.matching)
        except Exception:  # a ZError: it was closed meanwhile
            return False

    def receiving_servers(self) -> frozenset[str]:
        """Return ids of the servers that receive a request sent now."""
        self._check_process()
        return self._servers

    def connected_servers(self) -> frozenset[str]:
        """Return ids of the servers that are there, and of those that left during a request whose end isn't told.

        Zenoh sends the end of a server's token ahead of the responses that it sent before, and the end of a request
        after them.
        """
        self._check_process()
        with self._lock:
            return self._servers.union(*self._open.values())

    def incompatibility(self) -> str:
        """Return why the present servers are of no use, or an empty text."""
        self._check_process()
        return "" if self._servers else next(iter(self._others.values()), "")

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""
        super().close()
        if not self._is_forked:  # a thread of the parent may have held the lock of the timers
            for number in list(self._end_timers.values()):
                self._timers.remove(number)


class ZenohResponder(_ServiceEnd):
    """A server; see `base.Responder`."""

    kind = "server"
    peer_kind = Kind.CLIENT

    def __init__(self, endpoint: ServiceEndpoint, graph: ZenohGraph, forget: Callable[[Any], None]) -> None:
        super().__init__(endpoint, graph, forget)
        self._requests: deque[Request] = deque()
        self._queries: OrderedDict[RequestId, Any] = OrderedDict()
        """The query of each request that is waiting or in work: the client waits until it is dropped."""
        self._others: dict[bytes, str] = {}
        """Why each client of another type can't be served, by its gid. Replaced, never changed."""
        self._last_drop_reason = ""
        self._key = ""

    def declare(self, session: Any, key: str) -> Any:
        """Open the queryable of Zenoh, and return it."""
        zenoh = open_library()
        self._key = key
        return session.declare_queryable(
            key, zenoh.handlers.Callback(self._on_query, indirect=False), complete=True
        )

    def add_peer(self, peer: Peer) -> None:
        """Note a client that was discovered, if it is none for this server."""
        if not self._is_same_type(peer):
            self._others = {**self._others, peer.gid: self._difference(peer, "a client")}

    def remove_peer(self, peer: Peer) -> Callable[[], None]:
        """Note a client that has left; what it has asked for needs no reply."""
        self._others = {gid: text for gid, text in self._others.items() if gid != peer.gid}
        return lambda: self._drop_queries(peer.gid)

    def _drop_queries(self, gid: bytes) -> None:
        with self._lock:
            dropped = [self._queries.pop(key) for key in list(self._queries) if key.client_gid == gid]
        for query in dropped:
            query.drop()

    def _has_waiting(self) -> bool:
        return bool(self._requests)

    def _on_query(self, query: Any) -> None:
        """Queue a request; called on a thread of Zenoh."""
        header = unpack_attachment(query.attachment)
        payload = query.payload
        data = b"" if payload is None else payload.to_bytes()
        if header is None or len(data) < HEADER_SIZE:
            with self._lock:
                self._last_drop_reason = (
                    f"a request to {self._service.name} has no attachment of rmw_zenoh's form, or no message"
                )
            query.drop()
            return
        request_id = RequestId(header.gid, header.sequence_number)
        dropped = []
        with self._lock:
            if self._is_closed:
                dropped.append(query)
            else:
                if (before := self._queries.pop(request_id, None)) is not None:
                    dropped.append(before)
                self._queries[request_id] = query
                self._requests.append(Request(data, request_id, header.source_stamp_ns, time.time_ns()))
                # The oldest ones make room: of those that wait, and of those that nobody ever replies to.
                if len(self._requests) > self._depth:
                    lost = self._requests.popleft()
                    self._last_drop_reason = (
                        f"more than {self._depth} requests to {self._service.name} were waiting"
                    )
                    dropped.append(self._queries.pop(lost.id, None))
                while len(self._queries) > 2 * self._depth:
                    dropped.append(self._queries.popitem(last=False)[1])
                self._post()
        for old in dropped:
            if old is not None:
                old.drop()

    def take(self) -> Request | None:
        """Remove and return the oldest waiting request, or None."""
        self._check_process()
        with self._lock:
            return self._requests.popleft() if self._requests else None

    def send(self, request_id: RequestId, data: bytes) -> None:
        """Reply to a request; one whose client has left is dropped.

        Raises:
            ClosedError: the responder is closed.
            WireError: Zenoh refuses the response.
        """
        self._check_open("reply to a request")
        with self._lock:
            query = self._queries.pop(request_id, None)
        if query is None:
            return
        attachment = pack_attachment(request_id.sequence_number, request_id.client_gid)
        zenoh = open_library()
        with signals_deferred():  # a client of this session is called within it
            try:
                query.reply(self._key, bytes(data), attachment=attachment)
            except zenoh.ZError as error:
                self._check_open("reply to a request")
                text = f"cannot reply to a request of {self._service.name}: {reason_of(error)}"
                raise WireError(text) from None
            finally:
                query.drop()  # or the client would wait for more

    def incompatibility(self) -> str:
        """Return why some of the present clients can't be served, or an empty text."""
        self._check_process()
        return next(iter(self._others.values()), "")

    def last_drop_reason(self) -> str:
        """Return why the last dropped request was dropped, or an empty text."""
        return self._last_drop_reason

    def close(self) -> None:
        """Leave the service; clients that wait for a reply learn that none comes."""
        super().close()
        if self._is_forked:
            return
        with self._lock:
            queries, self._queries = list(self._queries.values()), OrderedDict()
            self._requests.clear()
        with signals_deferred():
            for query in queries:
                query.drop()


uninterrupted_files.add(ZenohRequester.take.__code__.co_filename)
