"""Services over two topics in rmw_cyclonedds' form: a header within the CDR says which client asked, and what.

After the encapsulation header stand 8 octets that name the client and its 64-bit sequence number, then the message.
Every client hears every response and keeps its own.
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
"""How long a response waits for a client that can't hear it yet."""

LEAST_WAITING = 1000
"""How many requests, or responses, a reader keeps at least while nobody takes them."""

_HEADER = struct.Struct("<8sq")
_ENCAPSULATION_SIZE = 4
_DATA_START = _ENCAPSULATION_SIZE + _HEADER.size
_KEY_SIZE = 8
_GID_PADDING = bytes(8)
_MOST_CLIENTS = 4096


class Servers(Protocol):
    """What a client's wire knows of the servers."""

    def is_ready(self) -> bool:
        """Tell whether one is connected both ways."""

    def obstacle(self) -> str:
        """Return why a peer can't be talked to, or an empty text."""


class Clients(Protocol):
    """What a server's wire knows of the clients."""

    def obstacle(self) -> str:
        """Return why a peer can't be talked to, or an empty text."""

    def accepts(self, publisher_gid: bytes) -> bool:
        """Tell whether what this client wrote is in our form."""

    def hears(self, publisher_gid: bytes) -> bool | None:
        """Tell whether the client that wrote from here hears responses now; None if it has left."""


def waiting_qos(qos: QoS, *, is_client: bool) -> QoS:
    """Return what the reader of a service's end asks for.

    All clients' requests meet in a server's one reader, and a client's is passed all clients' responses: with ROS's
    default depth of 10, one is lost when eleven come at once. A server whose depth is below that is left its wish.
    """
    if is_client or qos.depth >= QoS().depth:
        return qos._replace(depth=max(qos.depth, LEAST_WAITING))
    return qos


def _with_header(data: bytes, key: bytes, sequence_number: int) -> bytes:
    return data[:_ENCAPSULATION_SIZE] + _HEADER.pack(key, sequence_number) + data[_ENCAPSULATION_SIZE:]


def _split(sample: Sample) -> tuple[bytes, int, bytes] | None:
    """Return client key, sequence number and message; None for what is too short for them."""
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
            ForeignPeerError: a server of this service speaks another vendor's form.
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
        """Post `token` to `queue` when `is_ready` may have changed, once at the start too; None ends it."""
        self._requests.notify_event(Event.MATCHED, queue, token)
        self._responses.notify_event(Event.MATCHED, queue, token)

    def is_ready(self) -> bool:
        """Tell whether a server is connected both ways."""
        return self._servers.is_ready()

    def obstacle(self) -> str:
        """Return why this client will never be ready as things stand, or an empty text."""
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
        """Answer a request; waits for `CLIENT_WAIT_S` at most for a client that can't hear the answer yet.

        Raises:
            ClosedError: the responder is closed.
        """
        if self._closed:
            raise ClosedError("cannot answer a request: the server is closed")
        key = request_id.client_gid[:_KEY_SIZE]
        publisher_gid = self._gids.get(key)
        if publisher_gid is None or self._wait_for_client(publisher_gid):
            self._responses.write(_with_header(data, key, request_id.sequence_number))

    def _wait_for_client(self, publisher_gid: bytes) -> bool:
        """Wait until a client hears, or for long enough; False if it has left."""
        end = time.monotonic() + CLIENT_WAIT_S
        while not (hears := self._clients.hears(publisher_gid)):
            if hears is None:
                return False
            if time.monotonic() > end:
                break
            time.sleep(0.001)
        return True

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take; None ends it."""
        self._requests.notify(queue, token)

    def obstacle(self) -> str:
        """Return why some client can't be served as things stand, or an empty text."""
        return self._clients.obstacle()

    def refusal(self) -> str:
        """Return why a request was dropped the last time that one was, or an empty text."""
        return self._refusal

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""
        self._closed = True
        self._requests.close()
        self._responses.close()
