"""The relay between clients and the SDK's port, with a server in the place of the SDK."""

from __future__ import annotations

import errno
import hashlib
import random
import socket
import threading
import time
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, closing, contextmanager, suppress
from types import SimpleNamespace
from typing import Any

import psutil
import pytest
from tests.conftest import TIMEOUT_S, wait_until

from tfloom.foxglove import relay as module
from tfloom.foxglove.relay import MAX_HEAD_BYTES, MAX_WAITING, Relay, listen

LARGE = 50_000_000
"""More than all buffers of a connection hold [bytes]."""
REQUEST = (
    b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
)
REFUSED = REQUEST + b"X-Refused: 1\r\n\r\n"
REQUEST += b"\r\n"
THREAD = "foxglove_bridge_relay"


class Relayed:
    """A relay, and the server behind it."""

    def __init__(self) -> None:
        self.server = socket.create_server(("127.0.0.1", 0))
        self.server.settimeout(TIMEOUT_S)
        inner: Any = SimpleNamespace(address=self.server.getsockname(), way_in=socket.socket)
        self.relay = Relay(listen("127.0.0.1", 0), None, inner, self.refusal)
        self.relay.start()

    @staticmethod
    def refusal(headers: Iterable[tuple[str, str]]) -> str:
        return "it says so" if ("X-Refused", "1") in headers else ""

    def connect(self, data: bytes = REQUEST) -> socket.socket:
        client = socket.socket()
        client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        client.settimeout(TIMEOUT_S)
        client.connect(("127.0.0.1", self.relay.port))
        client.sendall(data)
        return client

    def accept(self) -> socket.socket:
        """Return the server's end of the next connection, whose request has been read."""
        end, _ = self.server.accept()
        end.settimeout(TIMEOUT_S)
        assert read(end, len(REQUEST)) == REQUEST
        return end

    @contextmanager
    def connection(self) -> Iterator[tuple[socket.socket, socket.socket]]:
        """Give both ends of a connection that is let through: the client's and the server's."""
        with closing(self.connect()) as client, closing(self.accept()) as server:
            yield client, server


@pytest.fixture
def relayed() -> Iterator[Relayed]:
    made = Relayed()
    try:
        yield made
    finally:
        made.relay.close(0.0)
        made.server.close()
    assert THREAD not in {thread.name for thread in threading.enumerate()}


def read(connection: socket.socket, size: int) -> bytes:
    """Read a number of bytes, or all until the end."""
    data = bytearray()
    while len(data) < size and (part := connection.recv(min(size - len(data), 1_000_000))):
        data += part
    return bytes(data)


def is_ended(connection: socket.socket) -> bool:
    """Return whether a connection from which nothing comes is closed, as soon as it is, or its timeout is over."""
    try:
        return not connection.recv(1)
    except ConnectionError:
        return True
    except TimeoutError:
        return False


def answer(relayed: Relayed, data: bytes) -> bytes:
    """Return what a client gets that sends this, until the relay closes the connection."""
    with closing(relayed.connect(data)) as client:
        return read(client, LARGE)


def test_bytes_pass_both_ways_as_they_are(relayed: Relayed) -> None:
    """Also those that come with the request, and that no WebSocket would send."""
    with closing(relayed.connect(REQUEST + b"\xff\x00early")) as client, closing(relayed.accept()) as server:
        assert read(server, 7) == b"\xff\x00early"
        client.sendall(b"\r\n\r\nGET / HTTP/1.1\r\n\r\n")
        assert read(server, 22) == b"\r\n\r\nGET / HTTP/1.1\r\n\r\n"
        server.sendall(b"HTTP/1.1 400 Bad Request\r\n\r\n\x00")
        assert read(client, 29) == b"HTTP/1.1 400 Bad Request\r\n\r\n\x00"


def test_request_in_parts_passes(relayed: Relayed) -> None:
    with closing(relayed.connect(b"")) as client:
        client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        for byte in REQUEST:
            client.sendall(bytes((byte,)))
        with closing(relayed.accept()) as server:
            server.sendall(b"there")
            assert read(client, 5) == b"there"


def test_large_messages_pass_whole_and_in_order(relayed: Relayed) -> None:
    data = random.Random(1).randbytes(LARGE)
    expected = hashlib.sha256(data).digest()
    with relayed.connection() as (client, server):
        for sender, receiver in ((client, server), (server, client)):
            sending = threading.Thread(target=sender.sendall, args=(data,))
            sending.start()
            assert hashlib.sha256(read(receiver, LARGE)).digest() == expected
            sending.join(TIMEOUT_S)


def test_client_that_sends_no_more_still_gets_answers(relayed: Relayed) -> None:
    with relayed.connection() as (client, server):
        client.sendall(b"last words")
        client.shutdown(socket.SHUT_WR)
        assert read(server, LARGE) == b"last words"
        server.sendall(b"an answer")
        assert read(client, 9) == b"an answer"
        server.close()
        assert read(client, LARGE) == b""
        wait_until(lambda: not relayed.relay._ends)


def test_end_of_the_server_ends_the_connection_when_all_is_taken(relayed: Relayed) -> None:
    data = random.Random(3).randbytes(LARGE)
    with relayed.connection() as (client, server):
        sending = threading.Thread(target=lambda: (server.sendall(data), server.close()))
        sending.start()
        assert hashlib.sha256(read(client, 2 * LARGE)).digest() == hashlib.sha256(data).digest()
        sending.join(TIMEOUT_S)
        wait_until(lambda: not relayed.relay._ends)


@pytest.mark.parametrize("is_client", [True, False])
def test_who_takes_nothing_stops_the_other_and_gets_all_later(relayed: Relayed, is_client: bool) -> None:
    """What is sent stays with the sender, but for the buffers of the connections."""
    data = random.Random(2).randbytes(LARGE)
    with relayed.connection() as (client, server):
        sender, receiver = (server, client) if is_client else (client, server)
        sender.settimeout(0.5)
        view = memoryview(data)
        with suppress(TimeoutError):
            while view:
                view = view[sender.send(view[:65536]) :]
        assert len(view) > LARGE // 2, "the relay takes what nobody takes from it"
        sender.settimeout(TIMEOUT_S)
        sending = threading.Thread(target=sender.sendall, args=(view,))
        sending.start()
        assert hashlib.sha256(read(receiver, LARGE)).digest() == hashlib.sha256(data).digest()
        sending.join(TIMEOUT_S)


def test_refused_and_wrong_requests_get_a_reason_and_nothing_passes(relayed: Relayed) -> None:
    reasons = {
        REFUSED: b"403 Forbidden",
        b"POST / HTTP/1.1\r\n\r\n": b"400 Bad Request",
        b"\x16\x03\x01\x02\x00\r\n\r\n": b"400 Bad Request",  # TLS
        b"GET / HTTP/1.1\r\nHost : a\r\n b: c\r\n\r\n": b"400 Bad Request",
        b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n": b"426 Upgrade Required",
        REQUEST.replace(b"Version: 13", b"Version: 7"): b"400 Bad Request",
        b"GET / HTTP/1.1\r\nX: " + bytes(MAX_HEAD_BYTES): b"431 Request Header Fields Too Large",
    }
    for request, reason in reasons.items():
        assert answer(relayed, request).startswith(b"HTTP/1.1 " + reason), request[:50]
    assert b"it says so" in answer(relayed, REFUSED)
    relayed.server.setblocking(False)
    with pytest.raises(BlockingIOError):
        relayed.server.accept()


def test_thousand_connections_without_a_request_keep_nobody_out(relayed: Relayed) -> None:
    before = psutil.Process().num_fds()
    with ExitStack() as stack:
        silent = [stack.enter_context(closing(relayed.connect(b"GET"))) for _ in range(1000)]
        with relayed.connection() as (client, server):
            server.sendall(b"served")
            assert read(client, 6) == b"served"
            assert len(relayed.relay._waiting) <= MAX_WAITING
            assert psutil.Process().num_fds() - before < len(silent) + 2 * MAX_WAITING
        assert all(is_ended(client) for client in silent[: len(silent) - MAX_WAITING])
    wait_until(lambda: not relayed.relay._waiting)
    assert psutil.Process().num_fds() <= before


def test_request_that_takes_too_long_is_not_waited_for(
    relayed: Relayed, monkeypatch: pytest.MonkeyPatch
) -> None:
    """However regularly its bytes come."""
    monkeypatch.setattr(module, "REQUEST_S", 0.3)
    begin_s = time.monotonic()
    with closing(relayed.connect(b"")) as client:
        client.settimeout(0.05)
        with suppress(ConnectionError):
            wait_until(lambda: client.sendall(b"G") or is_ended(client))
    assert time.monotonic() - begin_s >= 0.3
    with relayed.connection() as (client, server):  # which is served longer than that
        wait_until(lambda: time.monotonic() - begin_s > 1.5)
        server.sendall(b"still")
        assert read(client, 5) == b"still"


def test_more_clients_than_the_limit_are_refused_until_one_leaves(
    relayed: Relayed, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "MAX_CLIENTS", 2)
    with relayed.connection() as (first, first_server), relayed.connection():
        assert answer(relayed, REQUEST).startswith(b"HTTP/1.1 503")
        first.close()
        assert read(first_server, 1) == b""
        first_server.close()
        wait_until(lambda: len(relayed.relay._ends) == 2)
        with relayed.connection() as (client, server):
            client.sendall(b"again")
            assert read(server, 5) == b"again"


def test_clients_that_come_and_go_leave_nothing(relayed: Relayed) -> None:
    def come_and_go(number: int) -> None:
        with relayed.connection() as (client, server):
            (client if number % 2 else server).close()

    come_and_go(0)
    wait_until(lambda: not relayed.relay._ends)
    before = psutil.Process().num_fds()
    for number in range(200):
        come_and_go(number)
    wait_until(lambda: not relayed.relay._ends)
    assert psutil.Process().num_fds() <= before


def client_end(relayed: Relayed) -> module._Client:
    (end,) = (end for end in relayed.relay._ends if isinstance(end, module._Client))
    return end


def test_client_that_takes_nothing_is_cut_a_while_after_the_server_has_closed(
    relayed: Relayed, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "REST_S", 0.2)
    with relayed.connection() as (client, server):
        waiting = client_end(relayed).transport
        wait_until(lambda: server.send(bytes(4096)) and waiting.get_write_buffer_size() > 0)
        server.close()
        wait_until(lambda: not relayed.relay._ends)
        with suppress(ConnectionError):
            assert read(client, LARGE)


def test_clients_whose_network_is_gone_are_found(relayed: Relayed) -> None:
    with relayed.connection():
        connection = client_end(relayed).transport.get_extra_info("socket")
        assert connection.getsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE)
        assert connection.getsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPIDLE) == 15


def test_server_that_is_gone_ends_the_connection_and_the_next_one_works(relayed: Relayed) -> None:
    address = relayed.server.getsockname()
    relayed.server.close()
    assert answer(relayed, REQUEST) == b""
    relayed.server = socket.create_server(address)
    relayed.server.settimeout(TIMEOUT_S)
    with relayed.connection() as (client, server):
        server.sendall(b"there")
        assert read(client, 5) == b"there"


def test_refused_descriptors_delay_and_end_nothing(relayed: Relayed, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "RETRY_S", 0.01)
    listener = relayed.relay._listener
    tries: list[int] = []

    def refuse() -> Any:
        tries.append(1)
        if len(tries) <= 3:
            raise OSError(errno.EMFILE, "Too many open files")
        return listener.accept()

    stand_in = SimpleNamespace(accept=refuse, fileno=listener.fileno, close=listener.close)
    monkeypatch.setattr(relayed.relay, "_listener", stand_in)
    with relayed.connection() as (client, server):
        server.sendall(b"there")
        assert read(client, 5) == b"there"
    assert len(tries) > 3


def test_port_that_is_closed_while_descriptors_are_refused_stays_closed(
    relayed: Relayed, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "RETRY_S", 0.2)
    relay, listener = relayed.relay, relayed.relay._listener
    refused, again = threading.Event(), threading.Event()
    faults: list[Any] = []
    relay._loop.set_exception_handler(lambda _, context: faults.append(context))

    def refuse() -> Any:
        refused.set()
        raise OSError(errno.EMFILE, "Too many open files")

    accept_again = relay._accept_again

    def accept_again_and_tell() -> None:
        relay._loop.call_soon(again.set)  # after what it raises was handled
        accept_again()

    stand_in = SimpleNamespace(accept=refuse, fileno=listener.fileno, close=listener.close)
    monkeypatch.setattr(relay, "_listener", stand_in)
    monkeypatch.setattr(relay, "_accept_again", accept_again_and_tell)
    with closing(relayed.connect()):
        assert refused.wait(TIMEOUT_S)
        relay.refuse_more()
        assert again.wait(TIMEOUT_S)
    assert faults == []


def is_refused(port: int) -> bool:
    try:
        socket.create_connection(("127.0.0.1", port), timeout=TIMEOUT_S).close()
    except ConnectionRefusedError:
        return True
    return False


def close_in_time(relayed: Relayed, timeout_s: float) -> bool:
    begin_s = time.monotonic()
    result = relayed.relay.close(timeout_s)
    assert time.monotonic() - begin_s < timeout_s + 5.0
    assert is_refused(relayed.relay.port)
    assert relayed.relay.close(timeout_s) is True  # nothing is left
    return result


def test_close_lets_the_last_bytes_pass(relayed: Relayed) -> None:
    with relayed.connection() as (client, server), closing(relayed.connect(b"GET")) as waiting:
        relayed.relay.refuse_more()
        assert is_refused(relayed.relay.port)
        assert is_ended(waiting)
        server.sendall(b"farewell")
        server.close()
        assert close_in_time(relayed, TIMEOUT_S) is True
        assert read(client, LARGE) == b"farewell"


@pytest.mark.parametrize("size", [0, LARGE])
def test_close_cuts_who_stays_or_takes_nothing(relayed: Relayed, size: int) -> None:
    def send(server: socket.socket) -> None:
        try:
            server.sendall(bytes(size))
        except ConnectionError:
            return

    with relayed.connection() as (client, server):
        sending = threading.Thread(target=send, args=(server,))
        sending.start()
        wait_until(lambda: not size or client.recv(1, socket.MSG_PEEK))
        assert close_in_time(relayed, 0.2) is False
        sending.join(TIMEOUT_S)
        assert not sending.is_alive()


def test_close_of_one_that_was_not_started(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    inner: Any = SimpleNamespace()
    relay = Relay(listen("127.0.0.1", 0), None, inner, lambda _: "")
    with monkeypatch.context() as patched:
        patched.setattr(threading.Thread, "start", refuse)
        with pytest.raises(RuntimeError):
            relay.start()
    relay.refuse_more()
    assert relay.close(1.0) is True
    assert is_refused(relay.port)


@pytest.mark.parametrize(
    ("host", "clients"),
    [
        ("127.0.0.1", ["127.0.0.1"]),
        ("localhost", ["localhost"]),
        ("::1", ["::1"]),
        ("::", ["::1", "127.0.0.1"]),
    ],
)
def test_addresses_at_which_it_listens(host: str, clients: list[str]) -> None:
    try:
        listener = listen(host, 0)
    except OSError as error:
        pytest.skip(f"this machine has no address {host}: {error}")
    with closing(listener):
        for client in clients:
            socket.create_connection((client, listener.getsockname()[1]), timeout=TIMEOUT_S).close()


def test_unknown_address_is_an_error() -> None:
    with pytest.raises(OSError, match=r"[Nn]ame|address"):
        listen("no.such.host.invalid", 0)
