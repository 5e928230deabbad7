"""The bridge's port: it lets clients through to the SDK, after a look at where they come from."""

from __future__ import annotations

import asyncio
import contextlib
import math
import socket
import threading
from collections.abc import Callable, Coroutine, Iterable
from concurrent.futures import Future
from concurrent.futures import TimeoutError as FutureTimeoutError
from functools import partial
from http import HTTPStatus
from typing import TYPE_CHECKING, Any, TypeVar, cast

from websockets.http11 import Request
from websockets.server import ServerProtocol

if TYPE_CHECKING:
    import ssl

    from tfloom.common.inner_port import InnerPort

__all__ = ["SWITCH_INTERVAL_S", "Relay", "listen"]

MAX_CLIENTS = 64
"""Number of clients that are connected at once."""
MAX_WAITING = 64
"""Number of connections that are not let through yet; of more, the oldest are closed."""
MAX_HEAD_BYTES = 16 * 1024
"""Size of a request [bytes]."""
REQUEST_S = 10.0
"""The longest wait until a connection is let through [s]."""
REST_S = 10.0
"""How long one end may take what has come from the other one before that closed [s]."""
KEEP_ALIVE = (("TCP_KEEPIDLE", 15), ("TCP_KEEPINTVL", 5), ("TCP_KEEPCNT", 3))
"""When the system asks whether a client is still there that sends nothing, as its options: one whose network is gone
says no farewell."""
RETRY_S = 0.1
"""Time after the system refused a connection, as without a free descriptor, until the next is taken [s]."""
SWITCH_INTERVAL_S = 0.001
"""How long a program that relays lets a thread compute while the relay waits for the GIL [s]. Each 256 KiB that pass
take the GIL three times, so that with Python's own interval of 5 ms a busy program would pass 17 MB/s."""
HEAD_END = b"\r\n\r\n"
_Result = TypeVar("_Result")


def listen(host: str, port: int) -> socket.socket:
    """Return a socket that listens at a host's first address; at `::`, to IPv4 as well.

    Raises:
        OSError: it can't.
    """
    family, _, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    is_dual = host == "::" and socket.has_dualstack_ipv6()
    return socket.create_server(cast("tuple[str, int]", address[:2]), family=family, dualstack_ipv6=is_dual)


class Relay:
    """Lets clients through to the SDK's port, on a separate thread, until `close`.

    Of a connection, only the request that opens a WebSocket is read. All that comes after is passed as it is, both
    ways. While one side takes nothing, nothing is read from the other, so that a client that takes nothing costs no
    more than the buffers of its connection.

    Args:
        listener: Where clients connect.
        tls: With what connections are encrypted; None: they are not.
        inner: The SDK's port.
        refusal: Returns why a request with some headers is refused, empty if it is not; called on the relay's thread.
    """

    def __init__(
        self,
        listener: socket.socket,
        tls: ssl.SSLContext | None,
        inner: InnerPort,
        refusal: Callable[[Iterable[tuple[str, str]]], str],
    ) -> None:
        self.port: int = listener.getsockname()[1]
        self._listener = listener
        self._tls = tls
        self._inner = inner
        self._refusal = refusal
        self._loop = asyncio.SelectorEventLoop()
        self._waiting: dict[asyncio.Task[None], None] = {}
        """The tasks of connections that are not let through yet, the oldest first."""
        self._ends: set[_End] = set()
        """Both ends of each connection that is let through."""
        self._thread = threading.Thread(target=self._run, name="foxglove_bridge_relay", daemon=True)

    def start(self) -> None:
        """Take connections.

        Raises:
            RuntimeError: the system gives no thread.
        """
        self._listener.setblocking(False)
        self._thread.start()

    def refuse_more(self) -> None:
        """Close the port; connections that are let through stay."""
        self._do(self._refuse_more(), None)

    def cut_stuck(self, longer_s: float) -> tuple[int, int]:
        """Cut the connections whose clients have taken nothing for some time; on any thread but the relay's.

        Args:
            longer_s: How long [s].

        Returns:
            How many were cut, and of how many others something waits now.
        """
        answer: Future[tuple[int, int]] = Future()
        try:
            self._loop.call_soon_threadsafe(lambda: answer.set_result(self._cut_stuck(longer_s)))
            return answer.result(REQUEST_S)
        except (RuntimeError, FutureTimeoutError):  # the relay has closed
            return 0, 0

    def close(self, timeout_s: float) -> bool:
        """Close all connections, when the clients have taken what the SDK has sent; return whether all took it.

        Args:
            timeout_s: The longest wait for that [s].
        """
        self.refuse_more()
        is_taken = self._do(self._close(timeout_s), True)
        if self._thread.ident is not None:
            with contextlib.suppress(RuntimeError):  # the loop is closed
                self._loop.call_soon_threadsafe(self._loop.stop)
            self._thread.join()
        self._listener.close()
        self._loop.close()
        return is_taken

    def _do(self, work: Coroutine[Any, Any, _Result], without_thread: _Result) -> _Result:
        """Do something on the relay's thread, while there is one."""
        if not self._thread.is_alive():
            work.close()
            return without_thread
        return asyncio.run_coroutine_threadsafe(work, self._loop).result()

    # On its own thread.

    def _run(self) -> None:
        self._loop.add_reader(self._listener, self._accept)
        self._loop.run_forever()

    def _accept(self) -> None:
        """Take one connection, so that those that are let through get their turn between many."""
        try:
            connection, _ = self._listener.accept()
        except BlockingIOError:
            return
        except OSError:
            self._loop.remove_reader(self._listener)
            self._loop.call_later(RETRY_S, self._accept_again)
            return
        while len(self._waiting) >= MAX_WAITING:
            oldest = next(iter(self._waiting))
            del self._waiting[oldest]
            oldest.cancel()
        client = _Client(self._loop, connection)
        task = self._loop.create_task(self._admit(client))
        timer = self._loop.call_later(REQUEST_S, task.cancel)

        def end(_: asyncio.Task[None]) -> None:
            self._waiting.pop(task, None)
            timer.cancel()
            if client.other is None:
                client.abort()

        self._waiting[task] = None
        task.add_done_callback(end)

    def _accept_again(self) -> None:
        if self._listener.fileno() >= 0:
            self._loop.add_reader(self._listener, self._accept)

    async def _admit(self, client: _Client) -> None:
        """Let a connection through, or answer why it is refused."""
        with contextlib.suppress(OSError):  # it has left, or speaks no TLS
            await client.begin(self._tls)
            head = await client.head
            answer = self._answer(head) if head else b""
            if answer is not None:
                client.transport.write(answer)
                client.transport.close()
                await client.closed
                return
            inner = await self._connect(client)
            if client.closed.done():
                inner.abort()
                return
            for end in (client, inner):
                self._ends.add(end)
                end.closed.add_done_callback(partial(self._forget, end))
            client.go_on(inner)

    def _forget(self, end: _End, _: asyncio.Future[None]) -> None:
        self._ends.discard(end)

    async def _connect(self, client: _Client) -> _End:
        way_in = self._inner.way_in()
        try:
            way_in.setblocking(False)
            await self._loop.sock_connect(way_in, self._inner.address)
            inner = _End(self._loop, client)
            await self._loop.create_connection(lambda: inner, sock=way_in)
        except BaseException:
            way_in.close()
            raise
        return inner

    def _answer(self, head: bytes) -> bytes | None:
        """Return the response to a request that is refused; None for one that the SDK answers."""
        protocol = ServerProtocol()
        if len(head) > MAX_HEAD_BYTES:
            response = protocol.reject(
                HTTPStatus.REQUEST_HEADER_FIELDS_TOO_LARGE, "the request is too long\n"
            )
        else:
            protocol.receive_data(head)
            request = next(iter(protocol.events_received()), None)
            if not isinstance(request, Request):
                response = protocol.reject(HTTPStatus.BAD_REQUEST, "this is for WebSockets\n")
            elif reason := self._refusal(request.headers.raw_items()):
                response = protocol.reject(HTTPStatus.FORBIDDEN, f"{reason}\n")
            elif len(self._ends) >= 2 * MAX_CLIENTS:
                text = f"{MAX_CLIENTS} clients are connected already\n"
                response = protocol.reject(HTTPStatus.SERVICE_UNAVAILABLE, text)
            else:
                response = protocol.accept(request)
        return None if response.status_code == HTTPStatus.SWITCHING_PROTOCOLS else response.serialize()

    async def _refuse_more(self) -> None:
        if self._listener.fileno() >= 0:
            self._loop.remove_reader(self._listener)
            self._listener.close()
        tasks = [*self._waiting]
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)

    def _cut_stuck(self, longer_s: float) -> tuple[int, int]:
        waiting = [end for end in self._ends if isinstance(end, _Client) and math.isfinite(end.stuck_from_s)]
        before_s = self._loop.time() - longer_s
        stuck = [end for end in waiting if end.stuck_from_s <= before_s]
        for end in stuck:
            end.abort()
        return len(stuck), len(waiting) - len(stuck)

    async def _close(self, timeout_s: float) -> bool:
        ends = {*self._ends}
        if ends:
            await asyncio.wait({end.closed for end in ends}, timeout=timeout_s)
        left = [end for end in ends if not end.closed.done()]
        for end in left:
            end.abort()
        await asyncio.gather(*(end.closed for end in left))
        return not left


class _End(asyncio.Protocol):
    """One end of a connection, whose bytes go to the other one. When it closes, the other does, once all is taken.

    Args:
        loop: The relay's.
        other: The other end; None: not known yet.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop, other: _End | None) -> None:
        self.transport: asyncio.Transport
        self._loop = loop
        self.other = other
        self.closed: asyncio.Future[None] = loop.create_future()
        self.stuck_from_s = math.inf
        """Since when it takes nothing of what waits for it, on the loop's clock [s]; infinite: it does."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.transport = cast("asyncio.Transport", transport)

    def data_received(self, data: bytes) -> None:
        if self.other is not None:
            self.other.transport.write(data)

    def pause_writing(self) -> None:
        self.stuck_from_s = self._loop.time()
        if self.other is not None:
            self.other.transport.pause_reading()

    def resume_writing(self) -> None:
        self.stuck_from_s = math.inf
        if self.other is not None:
            self.other.transport.resume_reading()

    def connection_lost(self, _: Exception | None) -> None:
        self.closed.set_result(None)
        if self.other is not None:
            self.other.transport.close()
            # Closing waits until all is taken, and one that takes nothing would never make room for another client.
            self._loop.call_later(REST_S, self.other.abort)

    def abort(self) -> None:
        """Close the connection at once, whatever waits to be sent."""
        if hasattr(self, "transport"):
            self.transport.abort()


class _Client(_End):
    """The end of a client, which collects the request first."""

    def __init__(self, loop: asyncio.AbstractEventLoop, connection: socket.socket) -> None:
        super().__init__(loop, None)
        self._connection: socket.socket | None = connection
        """Until it is the transport's."""
        self._received = bytearray()
        """What has come until it is let through."""
        self.head: asyncio.Future[bytes] = loop.create_future()
        """The request; longer than `MAX_HEAD_BYTES` if it has no end by then; empty if the client has left before."""

    async def begin(self, tls: ssl.SSLContext | None) -> None:
        """Begin to read.

        Raises:
            OSError: the client has left, or doesn't speak TLS as it should.
        """
        if (connection := self._connection) is not None:
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
            for name, value in KEEP_ALIVE:
                if (option := getattr(socket, name, None)) is not None:
                    connection.setsockopt(socket.IPPROTO_TCP, option, value)
            self._connection = None
            timeout_s = None if tls is None else REQUEST_S
            await self._loop.connect_accepted_socket(
                lambda: self, connection, ssl=tls, ssl_handshake_timeout=timeout_s
            )

    def data_received(self, data: bytes) -> None:
        if self.other is not None:
            self.other.transport.write(data)
            return
        self._received += data
        end = self._received.find(HEAD_END, 0, MAX_HEAD_BYTES)
        if not self.head.done() and (end >= 0 or len(self._received) > MAX_HEAD_BYTES):
            # What comes after the request stays with the system until there is somewhere to pass it to.
            self.transport.pause_reading()
            length = len(self._received) if end < 0 else end + len(HEAD_END)
            self.head.set_result(bytes(self._received[:length]))

    def eof_received(self) -> bool:
        """Pass on that nothing more comes; return whether this end may still be written to."""
        if self.other is None or not self.transport.can_write_eof():
            return False  # with TLS, there is no end of one way alone
        self.other.transport.write_eof()
        return True

    def go_on(self, other: _End) -> None:
        """Pass all that has come, and all that comes, to another end."""
        self.other = other
        other.transport.write(bytes(self._received))
        self._received.clear()
        self.transport.resume_reading()

    def connection_lost(self, error: Exception | None) -> None:
        if not self.head.done():
            self.head.set_result(b"")
        super().connection_lost(error)

    def abort(self) -> None:
        super().abort()
        if self._connection is not None:
            self._connection.close()
