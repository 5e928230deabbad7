"""Viser's server: on the loopback interface, at its own port, for our relay alone."""

from __future__ import annotations

import contextlib
import io
import logging
import secrets
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import rich
import viser

from tfloom.common.inner_port import InnerPort
from tfloom.viewer.camera import Camera
from tfloom.viewer.layout.layout import ViewPoint
from tfloom.viewer.viser_private import connections_of, open_connections

if TYPE_CHECKING:
    from viser import ClientHandle, SceneApi

__all__ = ["KEY_HEADER", "PAGE_HEADER", "SceneServer"]

KEY_HEADER = "X-Tfloom-Key"
"""Header by which the relay is known; its value is a secret of this process."""
PAGE_HEADER = "X-Tfloom-Page"
"""Header with the id of the page that a connection is for."""


class SceneServer:
    """The server of the scene, which all pages share.

    Viser itself has no access rules: whoever reaches its port may read the scene, and may ask for a tunnel to the
    internet. So its port is closed to others where the system has a way to, each connection without the key is closed,
    and requests for a tunnel are not handled.
    """

    def __init__(self) -> None:
        logging.getLogger("websockets.server").addFilter(_is_not_of_a_stranger)
        self.inner = InnerPort()
        """Viser's port."""
        self.key = secrets.token_urlsafe(24)
        self._clients: dict[str, int] = {}
        """Viser's number of the client of each page."""
        # What viser warns of there is in the words of a page; as an error, it makes the message one that can't be read.
        warnings.filterwarnings("error", module=r"viser\.infra\._messages")
        # A page may close at any time, also while something is queued for it.
        warnings.filterwarnings("ignore", "Queued a .* on a closed connection")
        with _without_words():  # it would print its address, which is nobody's business
            self._server = viser.ViserServer(host=self.inner.host, port=0, verbose=False)
        self.inner.close_to_others(self._server.get_port())
        connections = connections_of(self._server)
        live = open_connections(connections)

        async def check(connection: Any) -> None:
            request = live[connection.client_id].request
            headers = {} if request is None else request.headers
            if not secrets.compare_digest(headers.get(KEY_HEADER, "").encode(), self.key.encode()):
                await live[connection.client_id].close(1008, "this port is not for browsers")
                return
            # Nothing is read from viser while a page takes nothing, not even what asks whether the relay is there.
            live[connection.client_id].ping_timeout = None
            self._clients[headers.get(PAGE_HEADER, "")] = connection.client_id

        connections.on_client_connect(check)
        # Nothing here casts a shadow, as in RViz; maps of shadows would be drawn for every picture all the same.
        self.scene.configure_default_lights(cast_shadow=False)
        self._server.gui.configure_theme(dark_mode=True, show_logo=False, show_share_button=False)

    @property
    def scene(self) -> SceneApi:
        """The scene."""
        return self._server.scene

    def atomic(self) -> contextlib.AbstractContextManager[None]:
        """Send all changes of the block together."""
        return self._server.atomic()

    def client_html(self) -> bytes:
        """Return the page of viser's client, with the canvas alone, and with points whose sizes may be in pixels."""
        page = Path(viser.__file__).parent / "client" / "build" / "index.html"
        script = (Path(__file__).parent / "page" / "scene.js").read_bytes()
        # Before viser's scripts, which take the functions of WebGL as they find them.
        content = page.read_bytes().replace(b"<head>", b"<head><script>" + script + b"</script>", 1)
        return content.replace(b"</head>", _STYLE + b"</head>", 1)

    def client(self, page: str) -> ClientHandle | None:
        """Return viser's client of a page; None until it has told its camera, or when it is gone."""
        return self._server.get_clients().get(self._clients.get(page, -1))

    def pages(self) -> list[str]:
        """Return the pages that have, or had, a scene."""
        return list(self._clients)

    def camera(self, page: str) -> Camera | None:
        """Return the camera of a page; None until it has told it."""
        client = self.client(page)
        if client is None:
            return None
        state = client.camera
        w, x, y, z = (float(part) for part in state.wxyz)
        px, py, pz = (float(part) for part in state.position)
        return Camera((px, py, pz), (x, y, z, w), float(state.fov), float(state.aspect))

    def view_point(self, page: str) -> ViewPoint | None:
        """Return from where a page looks, and to where; None until it has told it."""
        client = self.client(page)
        if client is None:
            return None
        px, py, pz = (float(part) for part in client.camera.position)
        x, y, z = (float(part) for part in client.camera.look_at)
        return ViewPoint((px, py, pz), (x, y, z))

    def look(self, page: str, view_point: ViewPoint) -> bool:
        """Let a page look from a point to another one; return whether it was there to be told."""
        client = self.client(page)
        if client is None:
            return False
        client.camera.position = np.array(view_point.position)
        client.camera.look_at = np.array(view_point.look_at)
        return True

    def page_of(self, client: int) -> str | None:
        """Return the page of viser's client; None where its scene has gone."""
        if client not in self._server.get_clients():
            return None
        return next((page for page, number in list(self._clients.items()) if number == client), None)

    def client_of(self, page: str) -> int:
        """Return viser's number of the client of a page; -1 where it has no scene."""
        return self._clients.get(page, -1)

    def forget(self, page: str) -> None:
        """Forget a page that was closed."""
        self._clients.pop(page, None)

    def stop(self) -> None:
        """Close all connections, and the port."""
        with _without_words():
            self._server.stop()


def _is_not_of_a_stranger(record: logging.LogRecord) -> bool:
    """Return False for the traceback of a connection that asks for nothing sensible, as a port scanner's."""
    return record.getMessage() != "opening handshake failed"


@contextlib.contextmanager
def _without_words() -> Iterator[None]:
    """Drop what viser prints in the block. In a notebook it would come into the cell past standard output, by rich."""
    console = rich.get_console()
    was_quiet, console.quiet = console.quiet, True
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            yield
    finally:
        console.quiet = was_quiet


_STYLE = b"<style>#root :not(:has(canvas)):not(canvas) { display: none !important }</style>"
"""Shows the canvas alone: what viser's own panel offers is in our page."""
