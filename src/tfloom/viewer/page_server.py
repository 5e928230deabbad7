"""The server of pages: one port for our page, its commands, images, and viser's scene behind it."""

from __future__ import annotations

import asyncio
import contextlib
import json
import math
import secrets
import socket
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import Future
from http import HTTPStatus
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import parse_qs, urlsplit

from websockets.asyncio.client import connect
from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.datastructures import Headers
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response

from tfloom.common.access import Access
from tfloom.viewer.page_command import PageError
from tfloom.viewer.scene_server import KEY_HEADER, PAGE_HEADER
from tfloom.viewer.viser_private import said_by_scene

if TYPE_CHECKING:
    from tfloom.viewer.layout.layout import ViewPoint
    from tfloom.viewer.scene_server import SceneServer

__all__ = ["CLOSED", "PageServer", "ServerError"]

CLOSED: dict[str, Any] = {"op": "closed"}
"""The command that is given for a page that was closed."""

MAX_PAGES = 32
"""Number of pages that may be open at once."""
MAX_WAITING_BYTES = 256 * 1024
"""What the system may keep of a scene on each half of its way to a page, about [bytes]: a page that falls behind shows
that first, however old it is."""
MAX_COMMAND_BYTES = 64 * 1024
"""Size of what a page may send at once [bytes]."""
SILENT_S = 120.0
"""How long a page may not answer until it counts as gone [s]: one that draws without a graphics card on a busy machine
takes nothing for many seconds. A connection that was closed is noticed at once."""
BEAT_S = 0.05
"""Period at which the server's thread notes that it runs [s]."""
LATE_S = 0.25
"""How long it may not run until what pages say then is late; and how long after that it may still be late [s]."""
MAX_EARLIER_LINES = 500
"""Number of lines of the log that a new page gets."""
FILES = {
    "/": ("index.html", "text/html; charset=utf-8"),
    **{f"/{name}.css": (f"{name}.css", "text/css; charset=utf-8") for name in ("page", "uplot")},
    **{
        f"/{name}.js": (f"{name}.js", "text/javascript; charset=utf-8")
        for name in (
            *("page", "forms", "uplot", "plots", "joints", "settings", "graph", "views", "keys"),
            "markers",
        )
    },
}
PAGE_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; frame-src 'self'; "
    "connect-src 'self' {sockets}; base-uri 'none'; form-action 'none'; frame-ancestors 'self'{embedders}"
)
"""What our page may load: from this server alone, and no script or style within a text."""
SCENE_POLICY = (
    "default-src 'self' 'unsafe-inline' 'unsafe-eval' data: blob:; connect-src 'self' data: blob: {sockets}; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'self'{embedders}"
)
"""What viser's page may load: from this server and itself."""


class ServerError(Exception):
    """The server can't be started; the text says why."""


class PageServer:
    """Serves pages on a separate thread.

    Each page gets the newest state that there is when it has taken the one before: a slow page skips states.

    Args:
        scene: Viser's server.
        on_command: Called with a page's id and its command, on the server's thread; it must not wait.
        image_of: Returns a picture of a topic (its type, its bytes), or None; called on a thread of a pool.
    """

    def __init__(
        self,
        scene: SceneServer,
        on_command: Callable[[str, dict[str, Any]], None],
        image_of: Callable[[str], tuple[str, bytes] | None],
    ) -> None:
        self._scene = scene
        self._on_command = on_command
        self._image_of = image_of
        self._loop = asyncio.new_event_loop()
        self._server: Server | None = None
        self._thread: threading.Thread | None = None
        self._access = Access("127.0.0.1", 0)
        self._embedders = ""
        self._host = ""
        self._port = 0
        self._pages: dict[str, _Page] = {}
        self.view_point: Callable[[str], ViewPoint | None] = lambda _: None
        """Returns from where a new page looks, on the thread of the server; None: from where the page itself says."""
        self._beat_s = math.inf
        self._late_until_s = 0.0
        self._state = ""
        self._state_number = 0
        self._lines: list[str] = []
        """Lines of the log, as JSON; `_first_line` is the number of the first one."""
        self._first_line = 0

    def start(self, host: str, port: int, token: str | None = None, *, embedders: str = "") -> None:
        """Listen at an address, until `stop`.

        Args:
            host: The address; other than one of this machine's own, pages need a token.
            port: The port; 0: a free one.
            token: The token; None: a new one.
            embedders: Sites whose pages may show ours in a frame, as sources of a Content-Security-Policy.

        Raises:
            ServerError: the address can't be used, the system has no thread left, or serving fails at its start. The
                port is free again, and another `start` may follow.
        """
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        listener = socket.socket(family, socket.SOCK_STREAM)
        try:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listener.bind((host, port))
        except OSError as error:
            listener.close()
            raise ServerError(f"can't listen at {host}:{port}: {error.strerror or error}") from None
        self._host, self._port = host, listener.getsockname()[1]
        self._access = Access(host, self._port, token)
        self._embedders = f" {embedders}" if embedders else ""
        if self._loop.is_closed():
            self._loop = asyncio.new_event_loop()
        started: Future[None] = Future()
        thread = threading.Thread(
            target=self._run, args=(listener, started), name="tfloom_view_pages", daemon=True
        )
        try:
            thread.start()
        except RuntimeError as error:
            listener.close()
            self._loop.close()
            raise ServerError(f"serving pages needs a thread: {error}") from None
        self._thread = thread
        try:
            started.result()
        except Exception as error:
            thread.join()
            self._thread = None
            reason = (error.strerror if isinstance(error, OSError) else None) or str(error) or repr(error)
            raise ServerError(f"can't serve pages at {host}:{self._port}: {reason}") from error

    @property
    def address(self) -> str:
        """The address to open, with the token where one is needed."""
        host = {"0.0.0.0": socket.gethostname(), "::": socket.gethostname()}.get(self._host, self._host)  # noqa: S104
        host = f"[{host}]" if ":" in host else host
        token = self._access.token
        return f"http://{host}:{self._port}/" + (f"?token={token}" if token else "")

    @property
    def page_count(self) -> int:
        """Number of open pages."""
        return len(self._pages)

    def _run(self, listener: socket.socket, started: Future[None]) -> None:
        """Serve until `stop`; a failure before pages can come is the result of `started`."""
        try:
            self._loop.run_until_complete(self._serve(listener, started))
        except BaseException as error:
            if started.done():
                raise
            listener.close()
            started.set_exception(error)
        finally:
            self._loop.close()

    async def _serve(self, listener: socket.socket, started: Future[None]) -> None:
        self._server = await serve(
            self._handle,
            sock=listener,
            process_request=self._respond,
            select_subprotocol=lambda _, offered: offered[0] if offered else None,
            max_size=MAX_COMMAND_BYTES,
            ping_timeout=SILENT_S,
            compression=None,
            server_header=None,
        )
        started.set_result(None)
        self._beat_s = math.inf
        pulse = asyncio.create_task(self._beat())
        await self._server.wait_closed()
        pulse.cancel()

    async def _beat(self) -> None:
        """Note when this thread was held up, as by a library that computes for seconds and lets no other thread run."""
        while True:
            now_s = time.monotonic()
            if now_s > self._beat_s + BEAT_S + LATE_S:
                self._late_until_s = now_s + LATE_S
            self._beat_s = now_s
            await asyncio.sleep(BEAT_S)

    def is_late(self) -> bool:
        """Return whether what pages say now may have waited for longer than `LATE_S`; on the server's thread.

        A message has no time of its own. Of one that is taken when this thread goes on after it was held up, nobody
        knows how old it is; nor of those behind it.
        """
        now_s = time.monotonic()
        return now_s > self._beat_s + BEAT_S + LATE_S or now_s < self._late_until_s

    def stop(self) -> None:
        """Close all pages' connections, and the port."""
        if self._thread is None or self._server is None:
            self._loop.close()
            return
        self._loop.call_soon_threadsafe(self._server.close)
        self._thread.join(5.0)

    # To pages.

    def publish(self, state: dict[str, Any]) -> None:
        """Give all pages a new state; on any thread."""
        text = _json({"state": state})
        with contextlib.suppress(RuntimeError):  # the loop is closed
            self._loop.call_soon_threadsafe(self._set_state, text)

    def _set_state(self, text: str) -> None:
        self._state, self._state_number = text, self._state_number + 1
        self._wake()

    def add_lines(self, lines: Iterable[dict[str, Any]], most: int) -> None:
        """Add lines to the log of all pages, which has `most` lines at most; on any thread."""
        texts = [_json(line) for line in lines]
        if texts:
            with contextlib.suppress(RuntimeError):
                self._loop.call_soon_threadsafe(self._set_lines, texts, most)

    def _set_lines(self, texts: list[str], most: int) -> None:
        self._lines += texts
        surplus = max(0, len(self._lines) - most)
        del self._lines[:surplus]
        self._first_line += surplus
        self._wake()

    def answer(self, page: str, answer: dict[str, Any]) -> None:
        """Send an answer to one page; on any thread. A page that takes none gets the last few."""
        text = _json(answer)

        def add() -> None:
            if (opened := self._pages.get(page)) is not None:
                opened.answers = [*opened.answers[-MAX_ANSWERS + 1 :], text]
                opened.news.set()

        with contextlib.suppress(RuntimeError):
            self._loop.call_soon_threadsafe(add)

    def _wake(self) -> None:
        for page in self._pages.values():
            page.news.set()

    # From pages.

    async def _respond(self, _: ServerConnection, request: Request) -> Response | None:
        """Return the response to a request; None lets a WebSocket open."""
        headers = request.headers
        if refusal := self._access.refusal(request.path, headers.raw_items()):
            return _response(HTTPStatus.FORBIDDEN, f"{refusal}\n".encode(), "text/plain; charset=utf-8")
        url = urlsplit(request.path)
        if url.path in {"/api", "/scene/ws"}:
            if [value.lower() for value in headers.get_all("Upgrade")] != ["websocket"]:
                return _response(HTTPStatus.UPGRADE_REQUIRED, b"this is for WebSockets\n", "text/plain")
            if url.path == "/api" and len(self._pages) >= MAX_PAGES:
                return _response(HTTPStatus.SERVICE_UNAVAILABLE, b"too many pages are open\n", "text/plain")
            return None
        if url.path == "/image":
            return await self._respond_with_image(parse_qs(url.query).get("topic", [""])[0])
        return self._respond_with_file(url.path, f"ws://{headers.get('Host', '')}")

    async def _respond_with_image(self, topic: str) -> Response:
        picture = await self._loop.run_in_executor(None, self._image_of, topic)
        if picture is None:
            return _response(HTTPStatus.NO_CONTENT, b"", "text/plain")
        return _response(HTTPStatus.OK, picture[1], picture[0])

    def _respond_with_file(self, path: str, sockets: str) -> Response:
        if path == "/scene/":
            policy = SCENE_POLICY.format(sockets=sockets, embedders=self._embedders)
            return _response(HTTPStatus.OK, self._scene.client_html(), "text/html; charset=utf-8", policy)
        if path not in FILES:
            return _response(HTTPStatus.NOT_FOUND, b"there is nothing here\n", "text/plain")
        name, kind = FILES[path]
        content = (Path(__file__).parent / "page" / name).read_bytes()
        policy = PAGE_POLICY.format(sockets=sockets, embedders=self._embedders)
        response = _response(HTTPStatus.OK, content, kind, policy)
        if cookie := self._access.cookie():
            response.headers["Set-Cookie"] = cookie
        return response

    async def _handle(self, connection: ServerConnection) -> None:
        request = connection.request
        if request is None:  # not reached: the handshake is over
            return
        url = urlsplit(request.path)
        with contextlib.suppress(ConnectionClosed):
            if url.path == "/api":
                await self._handle_page(connection)
            else:
                await self._relay(connection, parse_qs(url.query).get("page", [""])[0])

    async def _handle_page(self, connection: ServerConnection) -> None:
        name = secrets.token_urlsafe(12)
        page = self._pages[name] = _Page(
            max(self._first_line, self._first_line + len(self._lines) - MAX_EARLIER_LINES)
        )
        self._on_command(name, {"op": "opened"})
        sender = asyncio.create_task(self._send(connection, name, page))
        try:
            async for text in connection:
                self._take(name, text)
        finally:
            del self._pages[name]
            page.drop_scene()
            self._scene.forget(name)
            self._on_command(name, CLOSED)
            sender.cancel()
            await asyncio.gather(sender, return_exceptions=True)

    def _take(self, name: str, text: str | bytes) -> None:
        try:
            command = json.loads(text)
        except (ValueError, RecursionError):
            command = None
        if isinstance(command, dict):
            self._on_command(name, command)
        else:
            self.answer(name, {"error": str(PageError("a command has to be an object of JSON"))})

    async def _send(self, connection: ServerConnection, name: str, page: _Page) -> None:
        view_point = self.view_point(name)
        camera = None if view_point is None else view_point._asdict()
        await connection.send(_json({"page": name, "camera": camera}))
        while True:
            page.news.clear()
            answers, page.answers = page.answers, []
            for text in answers:
                await connection.send(text)
            if page.state_number != self._state_number:
                page.state_number = self._state_number
                await connection.send(self._state)
            end = self._first_line + len(self._lines)
            if page.next_line < end:
                first = max(page.next_line, self._first_line)
                lines = self._lines[first - self._first_line :]
                page.next_line = end
                await connection.send(f'{{"log": [{", ".join(lines)}]}}')
            await page.news.wait()

    async def _connect_to_viser(self) -> socket.socket:
        """Return a connection to viser's port."""
        from_viser = self._scene.inner.way_in()
        try:
            from_viser.setblocking(False)
            await self._loop.sock_connect(from_viser, self._scene.inner.address)
        except BaseException:
            from_viser.close()
            raise
        return from_viser

    async def _relay(self, connection: ServerConnection, page: str) -> None:
        """Pass messages between a page's scene and viser; a page has one scene, the newest.

        What viser sends is passed as it is. `send` waits while a page takes nothing, and so does the pace while a page
        has not drawn what it has taken; then nothing more is read from viser, which keeps no queue either: it sends
        the newest state of each node when it can send again.
        """
        if (opened := self._pages.get(page)) is None:
            await connection.close(1008, "no such page")
            return
        opened.drop_scene()
        opened.scene = connection
        # Small buffers in the kernel on both sides, or megabytes of states that are no longer the newest wait there for
        # a page that takes nothing.
        connection.transport.get_extra_info("socket").setsockopt(
            socket.SOL_SOCKET, socket.SO_SNDBUF, MAX_WAITING_BYTES
        )
        async with connect(
            "ws://viser",
            sock=await self._connect_to_viser(),
            subprotocols=[connection.subprotocol] if connection.subprotocol else None,
            additional_headers={KEY_HEADER: self._scene.key, PAGE_HEADER: page},
            max_size=None,
            max_queue=1,
            ping_interval=None,  # it is this process
            compression=None,
            proxy=None,
        ) as upstream:
            pace = _Pace()

            async def up() -> None:
                async for message in connection:
                    if not isinstance(message, bytes):
                        continue
                    said = said_by_scene(message)
                    if isinstance(said, int):
                        pace.note_drawn(said)
                    elif said is not None:
                        await upstream.send(said)

            async def down() -> None:
                with contextlib.suppress(ConnectionClosed):
                    while True:
                        await pace.wait()
                        message = await upstream.recv()
                        pace.note_sent(len(message))
                        await connection.send(message)

            # Whichever side closes first ends both ways. What the other raises then tells nothing more.
            tasks = [asyncio.create_task(up()), asyncio.create_task(down())]
            _, pending = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
            for task in pending:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)


MAX_ANSWERS = 50
"""Number of answers that wait for one page."""


MAX_AHEAD = 8
"""Number of messages that a page's scene may have taken and not drawn."""
MAX_AHEAD_BYTES = 1_000_000
"""… and their size: of larger ones, as of clouds, it gets the next one when the one before is drawn [bytes]."""
MAX_NOTED = 1000
"""Number of messages that are noted for a scene that has never said what it has drawn."""


class _Pace:
    """How far a page's scene is behind what it was sent.

    A browser takes messages on a thread of its own, and would collect more than it can draw. A scene that has never
    said what it has drawn, as of another program, is never waited for.
    """

    def __init__(self) -> None:
        self._sizes: deque[int] = deque()
        """Of the messages that were sent and not drawn [bytes]."""
        self._drawn = 0
        """Number of messages that were drawn, or are taken for drawn."""
        self._has_said = False
        """Whether the scene has ever said what it has drawn."""
        self._news = asyncio.Event()

    def note_sent(self, size: int) -> None:
        """Note that a message of a size is sent [bytes]."""
        self._sizes.append(size)
        if not self._has_said and len(self._sizes) > MAX_NOTED:  # it may never say so
            self._take_as_drawn(1)

    def note_drawn(self, count: int) -> None:
        """Note how many messages were drawn from the first one on, as a page says, which may be anything."""
        self._has_said = True
        self._take_as_drawn(min(max(count - self._drawn, 0), len(self._sizes)))
        self._news.set()

    def _take_as_drawn(self, count: int) -> None:
        for _ in range(count):
            self._sizes.popleft()
        self._drawn += count

    async def wait(self) -> None:
        """Wait until the scene is near enough."""
        while self._has_said and (len(self._sizes) > MAX_AHEAD or sum(self._sizes) > MAX_AHEAD_BYTES):
            self._news.clear()
            await self._news.wait()


class _Page:
    """What one page has been sent, and what waits for it."""

    def __init__(self, next_line: int) -> None:
        self.news = asyncio.Event()
        self.state_number = 0
        self.next_line = next_line
        self.answers: list[str] = []
        self.scene: ServerConnection | None = None

    def drop_scene(self) -> None:
        """End the scene's connection at once, because a page that takes nothing takes no closing message, either."""
        if self.scene is not None:
            self.scene.transport.abort()
            self.scene = None


def _json(value: Any) -> str:
    """Return a value as JSON. A number that is not finite, which JSON doesn't have, is null."""
    try:
        return json.dumps(value, allow_nan=False)
    except ValueError:
        return json.dumps(_with_null(value), allow_nan=False)


def _with_null(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {key: _with_null(part) for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [_with_null(part) for part in value]
    return value


def _response(status: HTTPStatus, content: bytes, kind: str, policy: str = "default-src 'none'") -> Response:
    headers = Headers(
        {
            "Content-Type": kind,
            "Content-Length": str(len(content)),
            "Content-Security-Policy": policy,
            "Cache-Control": "no-store",
            "Referrer-Policy": "no-referrer",
            "X-Content-Type-Options": "nosniff",
            "Cross-Origin-Resource-Policy": "same-origin",
            "Connection": "close",
        }
    )
    return Response(status, status.phrase, headers, content)
