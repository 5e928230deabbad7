"""Services over two topics in rmw_cyclonedds' format: a header within the CDR identifies client and request.

The encapsulation header is followed by 8 bytes that identify the client, a 64-bit sequence number, and the message.
Every client receives every response, and drops those for other clients.
"""

from __future__ import annotations

import struct
import threading
import time
from collections.abc import Callable, Iterable
from collections.abc import Set as AbstractSet
from contextlib import suppress
from functools import partial
from typing import Protocol

from tfloom._native import ReadyQueue
from tfloom.common.terminal import report
from tfloom.rmw.base import Reader, Request, RequestId, Response, Sample, Writer
from tfloom.rmw.errors import ClosedError, CongestedError, ForeignPeerError, WireError
from tfloom.rmw.events import Event
from tfloom.rmw.qos import HistoryPolicy, QoS

CLIENT_WAIT_S = 0.1
"""The longest wait of a response until its client's reader is matched [s]."""

LATE_CLIENT_WAIT_S = 5.0
"""The longest wait, on a separate thread, where clients are known to be matched seconds late [s]."""

MIN_DEPTH = 100_000
"""The least number of requests, or responses, that a reader keeps until they are taken."""

UNANSWERED_S = 30.0
"""The time after which a request without a response makes room for another one [s]."""

MIN_ROOM_S, MAX_ROOM_S = 0.002, 0.05
"""The shortest and the longest time after which a writer that had no room is tried again [s]."""

MAX_SENT_AT_ONCE = 100
"""The most requests that are sent without giving other threads the lock."""

MAX_HELD, MAX_HELD_SIZE = 100_000, 256 << 20
"""The most requests, and bytes of them, that are held; a further one is refused."""

_HEADER = struct.Struct("<8sq")
_ENCAPSULATION_SIZE = 4
_DATA_START = _ENCAPSULATION_SIZE + _HEADER.size
_KEY_SIZE = 8
_GID_PADDING = bytes(8)
_MIN_REMEMBERED = 64
_MAX_KEYS = 16
"""The most keys of one writer that are remembered when a server looks through them: a client has one."""

_RequestKey = tuple[bytes, int]
"""A request, by the gid of its client and its number."""


class RequestWriter(Protocol):
    """The writer of a client."""

    gid: bytes

    def try_write(self, data: bytes) -> bool:
        """Send a request, without waiting; return False if servers lag behind, and nothing was sent."""

    def notify_event(self, event: Event, queue: ReadyQueue | None, token: int = 0) -> None:
        """See `base.Writer.notify_event`."""

    def close(self) -> None:
        """See `base.Writer.close`."""


class Servers(Protocol):
    """The servers of a client, as its wire has discovered them."""

    def is_ready(self) -> bool:
        """Return whether a server is matched in both directions."""

    def is_synchronising(self) -> bool:
        """Return whether a server is matched in both directions, and may not take data yet."""

    def synchronise(self) -> None:
        """Wait, for a short time, until all servers that are matched take data."""

    def receiving(self) -> frozenset[str]:
        """Return ids of the servers that receive a request sent now."""

    def most_in_flight(self) -> int | None:
        """Return how many requests these servers keep until they are taken; None: as many as there are."""

    def connected(self) -> frozenset[str]:
        """Return ids of the servers that are matched in one direction at least."""

    def incompatibility(self) -> str:
        """Return why a peer is incompatible, or an empty text."""


class Clients(Protocol):
    """The clients of a server, as its wire has discovered them."""

    def connected(self) -> AbstractSet[bytes]:
        """Return the gids of the writers that send requests."""

    def incompatibility(self) -> str:
        """Return why a peer is incompatible, or an empty text."""

    def accepts(self, publisher_gid: bytes) -> bool:
        """Return whether this client's requests have this format."""

    def synchronise(self) -> None:
        """Wait, for a short time, until all clients that are matched take data."""

    def is_matched(self, key: bytes, publisher_gid: bytes) -> bool | None:
        """Return whether the response reader of a client is matched; None if the client has left.

        `key` is that of its headers, `publisher_gid` the gid of its writer.
        """

    def may_be_late(self, publisher_gid: bytes) -> bool:
        """Return whether the response reader of a client may be matched seconds after its first request."""


def waiting_qos(qos: QoS, *, is_client: bool) -> QoS:
    """Return the quality that the reader of a server or a client requests.

    A server's reader receives all clients' requests, and a client's reader all clients' responses: with ROS's default
    depth of 10, one is lost when eleven arrive at once. A server with a smaller depth keeps that depth.
    """
    if is_client or qos.depth >= QoS().depth:
        return qos._replace(depth=max(qos.depth, MIN_DEPTH))
    return qos


def sending_qos(qos: QoS, *, is_client: bool) -> QoS:
    """Return the quality that the writer of a client or a server has.

    A writer that keeps the last samples alone can't send one again that a peer has not received: of a burst, more than
    its depth may be on their way, and the system drops what a busy peer has no room for. So a client keeps all requests
    until they are acknowledged; where too many are not, `RequestsInFlight` holds further ones, and the caller doesn't
    wait. A server doesn't: responses go to all of its clients, and one that is killed, and acknowledges nothing until
    its lease is over, would hold up all others.
    """
    return qos._replace(history=HistoryPolicy.KEEP_ALL) if is_client else qos


def _with_header(data: bytes, key: bytes, sequence_number: int) -> bytes:
    return data[:_ENCAPSULATION_SIZE] + _HEADER.pack(key, sequence_number) + data[_ENCAPSULATION_SIZE:]


def _split(sample: Sample) -> tuple[bytes, int, bytes] | None:
    """Return client key, sequence number and message; None for a sample that is too short for them."""
    if len(sample.data) <= _DATA_START:
        return None
    key, sequence_number = _HEADER.unpack_from(sample.data, _ENCAPSULATION_SIZE)
    return key, sequence_number, sample.data[:_ENCAPSULATION_SIZE] + sample.data[_DATA_START:]


class RequestsInFlight:
    """The requests of this participant's clients of a service: holds some back while servers may have no room for them.

    A request is in flight until its response is taken, it is lost with its servers, or `UNANSWERED_S` is over.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._sent_s: dict[_RequestKey, float] = {}
        """When each request in flight was sent, on the monotonic clock [s]; oldest first."""
        self._held: dict[_RequestKey, tuple[HeaderRequester, bytes]] = {}
        """The client and the data of each request that is not sent yet; oldest first."""
        self._held_size = 0
        """Bytes of those that are held."""
        self._timer: threading.Timer | None = None
        """Sends what is held although responses do not arrive."""
        self._room_timer: threading.Timer | None = None
        """Sends what is held because a writer had no room."""
        self._room_s = MIN_ROOM_S
        """The time of the next such timer [s]; longer after each that could send nothing."""

    def send(self, client: HeaderRequester, data: bytes, number: int) -> None:
        """Let a client write a request, at once if fewer than its limit are in flight, or it has none.

        This never waits for a server: what its writer has no room for is held.

        Raises:
            CongestedError: `MAX_HELD` requests are held, or this one would make them more than `MAX_HELD_SIZE`.
        """
        # Without a limit there is nothing to count. But a request that is already held goes first, so that the requests
        # of a client arrive in order. `_held` is read without the lock: what another thread holds at this moment is
        # sent at the same time as this request, and neither has to be first.
        if not self._held and client.most_in_flight() is None and client.write(data, number):
            return
        with self._lock:
            size = self._held_size + len(data)
            # A single request may be larger than all that are held may be: nothing else would ever send it.
            if len(self._held) >= MAX_HELD or (self._held and size > MAX_HELD_SIZE):
                raise CongestedError(
                    f"the request was not sent: {len(self._held)} earlier ones, of {self._held_size} bytes, wait for "
                    "servers that do not take them. Await responses before you send more, or end the servers that "
                    "do not answer"
                )
            self._held[client.client_gid, number] = client, data
            self._held_size = size
            if self._room_timer is not None:  # it sends this one, too
                return
        self._send_held((client.client_gid, number))

    def answered(self, client: HeaderRequester, number: int) -> None:
        """Note that a client has taken a response."""
        # Servers without a limit leave `_sent_s` empty: their responses cost no lock.
        if self._sent_s:
            with self._lock:
                self._sent_s.pop((client.client_gid, number), None)
        if self._held:
            self._send_held()

    def give_up(self, client: HeaderRequester, numbers: Iterable[int], *, is_lost: bool) -> None:
        """Never send those that are still held. With `is_lost`, their servers have left, and none is in flight.

        They are given up at once, because each that leaves makes room in which another of them would be sent.
        """
        if not self._sent_s and not self._held:
            return
        with self._lock:
            for number in numbers:
                key = client.client_gid, number
                self._drop(key)
                # A server that is there keeps a request until it takes it, also one that was given up meanwhile.
                if is_lost:
                    self._sent_s.pop(key, None)
        self._send_held()

    def _send_held(self, own: _RequestKey | None = None) -> None:
        """Send as many of the held requests as the servers have room for now, the oldest first.

        Raises:
            WireError: the caller's own request can't be sent.
        """
        failed: dict[_RequestKey, WireError] = {}
        with self._lock:
            self._send_what_has_room(failed)
        # Without the lock: stderr may be a pipe that nobody reads, or an object of the user's.
        own_error = None if own is None else failed.pop(own, None)
        for error in failed.values():
            if not isinstance(error, ClosedError):
                report(f"tfloom: a request that waited for room was not sent: {error}")
        if own_error is not None:
            raise own_error

    def _send_what_has_room(self, failed: dict[_RequestKey, WireError]) -> None:
        """Send what `_send_held` does, and decide when to look again; the caller holds the lock."""
        # This call decides anew when to look again, so the timer of the call before it is of no use.
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        if not self._held:
            if self._room_timer is not None:
                self._room_timer.cancel()
                self._room_timer = None
            return
        # The servers are those of a client that is still there: `leave` takes what a client holds under this lock.
        limit = next(iter(self._held.values()))[0].most_in_flight()
        if limit is None:  # the last server with a limit has left, and with it what it kept
            self._sent_s.clear()
        # A server may have dropped a request, or may never answer it. After a time such a request makes room for
        # another one; the first that is younger ends the search, because the oldest come first.
        now_s = time.monotonic()
        for key, sent_s in list(self._sent_s.items()):
            if sent_s > now_s - UNANSWERED_S:
                break
            del self._sent_s[key]
        if not self._write_held(limit, now_s, failed):
            if self._room_timer is None:
                self._room_timer = _started_timer(self._room_s, self._look_for_room)
        elif self._held:
            # If no response arrives from now on, nothing calls this function again but the timer.
            self._timer = _started_timer(UNANSWERED_S, self._send_held)

    def _write_held(self, limit: int | None, now_s: float, failed: dict[_RequestKey, WireError]) -> bool:
        """Write held requests up to the limit; return False if a writer has no room, or others shall get the lock.

        Those that can't be written are no longer held: their errors are added to `failed`.
        """
        # Written under the lock, which the caller holds: otherwise another thread could send a younger request between
        # the removal of this one and its write.
        sent_count = 0
        while self._held and (limit is None or len(self._sent_s) < limit):
            key, (client, data) = next(iter(self._held.items()))
            try:
                is_written = sent_count < MAX_SENT_AT_ONCE and client.write(data, key[1])
            except WireError as error:
                # It would fail again, and those behind it, which may be other clients', would never be sent.
                self._drop(key)
                failed[key] = error
                continue
            if not is_written:
                self._room_s = MIN_ROOM_S if sent_count else min(2 * self._room_s, MAX_ROOM_S)
                return False
            sent_count += 1
            self._drop(key)
            if limit is not None:
                self._sent_s[key] = now_s
        return True

    def _look_for_room(self) -> None:
        with self._lock:
            self._room_timer = None
        self._send_held()

    def _drop(self, key: _RequestKey) -> None:
        """Remove a request from those that are held, if it is one; the caller holds the lock."""
        held = self._held.pop(key, None)
        if held is not None:
            self._held_size -= len(held[1])

    def leave(self, client: HeaderRequester) -> None:
        """Forget the requests of a client that closes."""
        if not self._sent_s and not self._held:
            return
        with self._lock:
            gid = client.client_gid
            for key in [key for key in self._held if key[0] == gid]:
                self._drop(key)
            self._sent_s = {key: sent_s for key, sent_s in self._sent_s.items() if key[0] != gid}
        self._send_held()


def _started_timer(time_s: float, call: Callable[[], None]) -> threading.Timer | None:
    """Return a timer that runs; None where no thread can be started: the next response or request calls instead."""
    timer = threading.Timer(time_s, call)
    timer.daemon = True
    try:
        timer.start()
    except RuntimeError:
        return None
    return timer


class HeaderRequester:
    """A client; see `base.Requester`."""

    def __init__(
        self,
        requests: RequestWriter,
        responses: Reader,
        servers: Servers,
        key: bytes,
        in_flight: RequestsInFlight | None = None,
    ) -> None:
        self.gid = requests.gid
        self._requests = requests
        self._responses = responses
        self._servers = servers
        self.client_gid = key + _GID_PADDING
        self._key = key
        self._lock = threading.Lock()
        self._sequence_number = 0
        self._watch: tuple[ReadyQueue, int] | None = None
        """The queue and token of `watch_servers`."""
        self._in_flight = in_flight or RequestsInFlight()

    def send(self, data: bytes) -> int:
        """Send a request and return its sequence number.

        Raises:
            ForeignPeerError: a server of this service uses another vendor's format.
            CongestedError: too many requests wait for servers that do not take them.
            ClosedError: the requester is closed.
        """
        if text := self._servers.incompatibility():
            raise ForeignPeerError(text)
        # A reader on DDS drops what precedes its writer's first heartbeat, so a request that is sent at once after the
        # match could be lost without notice.
        self._servers.synchronise()
        with self._lock:
            self._sequence_number += 1
            sequence_number = self._sequence_number
        self._in_flight.send(self, data, sequence_number)
        return sequence_number

    def most_in_flight(self) -> int | None:
        """Return how many requests the servers keep until they are taken; None: as many as there are."""
        return self._servers.most_in_flight()

    def write(self, data: bytes, sequence_number: int) -> bool:
        """Write a request without regard to others, unless the writer has no room; called by `RequestsInFlight`."""
        return self._requests.try_write(_with_header(data, self._key, sequence_number))

    def take(self) -> Response | None:
        """Remove and return the oldest waiting response to this client, or None."""
        # Every client of the service receives every response. Go past those with another client's key, and past what is
        # too short for a header, until one is ours or nothing is left.
        while sample := self._responses.take():
            parts = _split(sample)
            if parts is not None and parts[0] == self._key:
                # Before the response is handled: its server has room again for a request that is held.
                self._in_flight.answered(self, parts[1])
                request_id = RequestId(self.client_gid, parts[1])
                return Response(parts[2], request_id, sample.source_stamp_ns, sample.received_stamp_ns)
        return None

    def give_up(self, sequence_numbers: Iterable[int], *, is_lost: bool = False) -> None:
        """Await no response to requests: those that were not sent yet never are. See `base.Requester.give_up`."""
        self._in_flight.give_up(self, sequence_numbers, is_lost=is_lost)

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take; None ends it."""
        self._responses.notify(queue, token)

    def notify_ready(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `is_ready` may have changed, and once at the start; None ends it."""
        # An endpoint posts an event to one queue. A wait for readiness takes the place of `watch_servers`; when it
        # ends, the watch gets its place back, with the token that tells it to look at the servers again.
        if queue is None and self._watch is not None:
            queue, token = self._watch
        self._requests.notify_event(Event.MATCHED, queue, token)
        self._responses.notify_event(Event.MATCHED, queue, token)

    def watch_servers(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when a server may have come or left, and once at the start; None ends it."""
        self._watch = None if queue is None else (queue, token)
        self.notify_ready(queue, token)

    def is_ready(self) -> bool:
        """Return whether a server is matched in both directions."""
        return self._servers.is_ready()

    def is_synchronising(self) -> bool:
        """Return whether a server is matched in both directions, and may not take data yet."""
        return self._servers.is_synchronising()

    def receiving_servers(self) -> frozenset[str]:
        """Return ids of the servers that receive a request sent now."""
        return self._servers.receiving()

    def connected_servers(self) -> frozenset[str]:
        """Return ids of the servers that receive requests, or whose responses may still arrive."""
        return self._servers.connected()

    def incompatibility(self) -> str:
        """Return why this client cannot become ready with the present servers, or an empty text."""
        return self._servers.incompatibility()

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""
        self._in_flight.leave(self)
        self._requests.close()
        self._responses.close()


class HeaderResponder:
    """A server; see `base.Responder`."""

    def __init__(self, requests: Reader, responses: Writer, clients: Clients) -> None:
        self.gid = requests.gid
        self._requests = requests
        self._responses = responses
        self._clients = clients
        self._gids: dict[bytes, bytes] = {}
        """The gid of each client's writer, by its key in the header."""
        self._forget_at = _MIN_REMEMBERED
        """Number of them at which the clients that have left, and the older ones of many keys, are forgotten."""
        self._closed = False
        self._last_drop_reason = ""

    def take(self) -> Request | None:
        """Remove and return the oldest waiting request, or None."""
        while sample := self._requests.take():
            parts = _split(sample)
            if not self._clients.accepts(sample.publisher_gid):
                # Another vendor's request has no header of this format, so its bytes can't be read. Keep the reason for
                # a log: the client itself would only see that no response comes.
                self._last_drop_reason = self._clients.incompatibility()
            elif parts is not None:
                key, sequence_number, data = parts
                self._remember(key, sample.publisher_gid)
                request_id = RequestId(key + _GID_PADDING, sequence_number)
                return Request(data, request_id, sample.source_stamp_ns, sample.received_stamp_ns)
        return None

    def _remember(self, key: bytes, publisher_gid: bytes) -> None:
        # To look for clients that have left costs a pass over all of them. It is made each time that the table has
        # doubled, so that a server that meets many short-lived clients neither grows without end nor looks at each
        # request.
        if key not in self._gids and len(self._gids) >= self._forget_at:
            present = self._clients.connected()
            left = dict.fromkeys(present, _MAX_KEYS)
            newest: dict[bytes, bytes] = {}
            for client_key, gid in reversed(self._gids.items()):
                if left.get(gid, 0) > 0:
                    left[gid] -= 1
                    newest[client_key] = gid
            self._gids = dict(reversed(newest.items()))
            self._forget_at = max(_MIN_REMEMBERED, 2 * len(self._gids))
        self._gids[key] = publisher_gid

    def send(self, request_id: RequestId, data: bytes) -> None:
        """Reply to a request; wait for `CLIENT_WAIT_S` at most until the client's reader is matched.

        The response to a client that may be matched later is sent when it is.

        Raises:
            ClosedError: the responder is closed.
        """
        if self._closed:
            raise ClosedError("cannot reply to a request: the server is closed")
        key = request_id.client_gid[:_KEY_SIZE]
        publisher_gid = self._gids.get(key)
        response = _with_header(data, key, request_id.sequence_number)
        # A client's reader may be discovered after its first request has arrived, and a response that is written before
        # is lost. So wait for the match, for a short time, because this thread is the one that serves requests.
        if publisher_gid is not None:
            is_matched = self._wait_for_client(key, publisher_gid, CLIENT_WAIT_S)
            if is_matched is None:  # the client has left
                return
            if not is_matched and self._clients.may_be_late(publisher_gid):
                late = partial(self._send_late, key, publisher_gid, response)
                try:
                    threading.Thread(target=late, daemon=True).start()
                except RuntimeError:  # no more threads: the response must not be lost, so this one waits
                    late()
                return
        self._responses.write(response)

    def _send_late(self, key: bytes, publisher_gid: bytes, response: bytes) -> None:
        """Send a response when its client is matched, in some seconds at most."""
        with suppress(WireError):  # it was closed meanwhile
            if self._wait_for_client(key, publisher_gid, LATE_CLIENT_WAIT_S) is not None:
                self._responses.write(response)

    def _wait_for_client(self, key: bytes, publisher_gid: bytes, timeout_s: float) -> bool | None:
        """Wait until a client's reader is matched; return False when the time is over, None if the client has left."""
        end = time.monotonic() + timeout_s
        while not (is_matched := self._clients.is_matched(key, publisher_gid)):
            if is_matched is None or self._closed:
                return is_matched
            if time.monotonic() > end:
                break
            time.sleep(0.001)
        self._clients.synchronise()
        return is_matched

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take; None ends it."""
        self._requests.notify(queue, token)

    def incompatibility(self) -> str:
        """Return why some of the present clients can't be served, or an empty text."""
        return self._clients.incompatibility()

    def last_drop_reason(self) -> str:
        """Return why the last dropped request was dropped, or an empty text."""
        return self._last_drop_reason

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""
        self._closed = True
        self._requests.close()
        self._responses.close()
