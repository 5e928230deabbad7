"""Services over two topics in rmw_cyclonedds' format: a header within the CDR identifies client and request.

The encapsulation header is followed by 8 octets that identify the client, a 64-bit sequence number, and the message.
Every client receives every response, and drops those for other clients.
"""

from __future__ import annotations

import struct
import threading
import time
from typing import Protocol

from tfloom._native import ReadyQueue
from tfloom.rmw.base import Reader, Request, RequestId, Response, Sample, Writer
from tfloom.rmw.errors import ClosedError, ForeignPeerError
from tfloom.rmw.events import Event
from tfloom.rmw.qos import QoS

CLIENT_WAIT_S = 0.1
"""The longest wait of a response until its client's reader is matched [s]."""

LEAST_WAITING = 1000
"""The least number of requests, or responses, that a reader keeps until they are taken."""

_HEADER = struct.Struct("<8sq")
_ENCAPSULATION_SIZE = 4
_DATA_START = _ENCAPSULATION_SIZE + _HEADER.size
_KEY_SIZE = 8
_GID_PADDING = bytes(8)
_MOST_CLIENTS = 4096


class Servers(Protocol):
    """The servers of a client, as its wire has discovered them."""

    def is_ready(self) -> bool:
        """Return whether a server is matched in both directions."""

    def obstacle(self) -> str:
        """Return why a peer is incompatible, or an empty text."""


class Clients(Protocol):
    """The clients of a server, as its wire has discovered them."""

    def obstacle(self) -> str:
        """Return why a peer is incompatible, or an empty text."""

    def accepts(self, publisher_gid: bytes) -> bool:
        """Return whether this client's requests have this format."""

    def is_matched(self, publisher_gid: bytes) -> bool | None:
        """Return whether the response reader of this writer's client is matched; None if the client has left."""


def waiting_qos(qos: QoS, *, is_client: bool) -> QoS:
    """Return the quality that the reader of a server or a client requests.

    A server's reader receives all clients' requests, and a client's reader all clients' responses: with ROS's default
    depth of 10, one is lost when eleven arrive at once. A server with a smaller depth keeps that depth.
    """
    if is_client or qos.depth >= QoS().depth:
        return qos._replace(depth=max(qos.depth, LEAST_WAITING))
    return qos


def _with_header(data: bytes, key: bytes, sequence_number: int) -> bytes:
    return data[:_ENCAPSULATION_SIZE] + _HEADER.pack(key, sequence_number) + data[_ENCAPSULATION_SIZE:]


def _split(sample: Sample) -> tuple[bytes, int, bytes] | None:
    """Return client key, sequence number and message; None for a sample that is too short for them."""
    if len(sample.data) <= _DATA_START:
        return None
    key, sequence_number = _HEADER.unpack_from(sample.data, _ENCAPSULATION_SIZE)
    return key, sequence_number, sample.data[:_ENCAPSULATION_SIZE] + sample.data[_DATA_START:]


class HeaderRequester:
    """A client; see `base.Requester`."""

    def __init__(self, requests: Writer, responses: Reader, servers: Servers, key: bytes) -> None:
        self.gid = requests.gid
        self._requests = requests
        self._responses = responses
        self._servers = servers
        self.client_gid = key + _GID_PADDING
        self._key = key
        self._lock = threading.Lock()
        self._sequence_number = 0

    def send(self, data: bytes) -> int:
        """Send a request and return its sequence number.

        Raises:
            ForeignPeerError: a server of this service uses another vendor's format.
            ClosedError: the requester is closed.
        """
        if text := self._servers.obstacle():
            raise ForeignPeerError(text)
        with self._lock:
            self._sequence_number += 1
            sequence_number = self._sequence_number
        self._requests.write(_with_header(data, self._key, sequence_number))
        return sequence_number

    def take(self) -> Response | None:
        """Remove and return the oldest waiting response to this client, or None."""
        while sample := self._responses.take():
            parts = _split(sample)
            if parts is not None and parts[0] == self._key:
                request_id = RequestId(self.client_gid, parts[1])
                return Response(parts[2], request_id, sample.source_stamp_ns, sample.received_stamp_ns)
        return None

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take; None ends it."""
        self._responses.notify(queue, token)

    def notify_ready(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `is_ready` may have changed, and once at the start; None ends it."""
        self._requests.notify_event(Event.MATCHED, queue, token)
        self._responses.notify_event(Event.MATCHED, queue, token)

    def is_ready(self) -> bool:
        """Return whether a server is matched in both directions."""
        return self._servers.is_ready()

    def obstacle(self) -> str:
        """Return why this client cannot become ready with the present servers, or an empty text."""
        return self._servers.obstacle()

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""
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
        self._closed = False
        self._refusal = ""

    def take(self) -> Request | None:
        """Remove and return the oldest waiting request, or None."""
        while sample := self._requests.take():
            parts = _split(sample)
            if not self._clients.accepts(sample.publisher_gid):
                self._refusal = self._clients.obstacle()
            elif parts is not None:
                key, sequence_number, data = parts
                self._remember(key, sample.publisher_gid)
                request_id = RequestId(key + _GID_PADDING, sequence_number)
                return Request(data, request_id, sample.source_stamp_ns, sample.received_stamp_ns)
        return None

    def _remember(self, key: bytes, publisher_gid: bytes) -> None:
        if len(self._gids) >= _MOST_CLIENTS:
            self._gids.clear()
        self._gids[key] = publisher_gid

    def send(self, request_id: RequestId, data: bytes) -> None:
        """Reply to a request; wait for `CLIENT_WAIT_S` at most until the client's reader is matched.

        Raises:
            ClosedError: the responder is closed.
        """
        if self._closed:
            raise ClosedError("cannot reply to a request: the server is closed")
        key = request_id.client_gid[:_KEY_SIZE]
        publisher_gid = self._gids.get(key)
        if publisher_gid is None or self._wait_for_client(publisher_gid):
            self._responses.write(_with_header(data, key, request_id.sequence_number))

    def _wait_for_client(self, publisher_gid: bytes) -> bool:
        """Wait until a client's reader is matched or the time is over; return False if the client has left."""
        end = time.monotonic() + CLIENT_WAIT_S
        while not (is_matched := self._clients.is_matched(publisher_gid)):
            if is_matched is None:
                return False
            if time.monotonic() > end:
                break
            time.sleep(0.001)
        return True

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take; None ends it."""
        self._requests.notify(queue, token)

    def obstacle(self) -> str:
        """Return why some of the present clients can't be served, or an empty text."""
        return self._clients.obstacle()

    def refusal(self) -> str:
        """Return why the last dropped request was dropped, or an empty text."""
        return self._refusal

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""
        self._closed = True
        self._requests.close()
        self._responses.close()
