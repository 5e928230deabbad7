"""The scene of a page, as viser's client takes it."""

from __future__ import annotations

import socket
import struct
import time
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import msgspec
import numpy as np
import zstandard
from tests.conftest import TIMEOUT_S
from viser import __version__
from websockets.sync.client import ClientConnection, connect

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from tests.viewer.conftest import Page

SMALL_BUFFER = 65536
"""Size of the receive buffer of a scene that reads nothing, so that it is soon full [bytes]."""


def connect_scene(port: int, page: str) -> ClientConnection:
    """Open the connection that the scene of a page has; nothing is read from it beyond a small buffer."""
    address = f"ws://127.0.0.1:{port}/scene/ws?page={page}"
    made = socket.socket()
    made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, SMALL_BUFFER)
    made.connect(("127.0.0.1", port))
    return connect(
        address,
        sock=made,
        subprotocols=[f"viser-v{__version__}"],  # type: ignore[list-item]
        max_size=None,
        max_queue=1,
        compression=None,
        ping_interval=None,
        close_timeout=0.5,
    )


def take_all(connection: ClientConnection) -> None:
    """Take messages until the connection is closed."""
    while True:
        connection.recv(timeout=10.0)


class Scene:
    """Takes what viser sends, and notes the arrays that its messages set."""

    def __init__(self, port: int, page: Page) -> None:
        self.socket = connect_scene(port, page.name)
        self.arrays: dict[tuple[str, str], NDArray[np.float32]] = {}
        """The newest array, by the name of a node and of its property."""
        self.camera: dict[str, Any] = {}
        """What the server has set of the camera."""
        self.updates = 0
        """How many arrays have come."""
        self.messages = 0
        """How many messages have come."""

    def wait_for(self, condition: Callable[[], Any]) -> Any:
        """Take messages until a condition is true; return its value."""
        end_s = time.monotonic() + TIMEOUT_S
        while not (value := condition()):
            assert time.monotonic() < end_s, f"timed out with {list(self.arrays)}"
            with suppress(TimeoutError):
                message = self.socket.recv(timeout=0.1)
                assert isinstance(message, bytes)
                self._take(message)
        return value

    def tell_drawn(self, count: int | None = None) -> None:
        """Tell how many messages are drawn; None: all that have come."""
        said = {"type": "TfloomDrawn", "count": self.messages if count is None else count}
        self.socket.send(msgspec.msgpack.encode(said))

    def _take(self, data: bytes) -> None:
        self.messages += 1
        size, packed = struct.unpack_from("<QQ", data)
        unpacked = zstandard.ZstdDecompressor().decompress(data[16 : 16 + packed], max_output_size=size)
        batch = msgspec.msgpack.decode(unpacked)
        buffers, at = [], 16 + packed
        for length in batch["binaryBufferLengths"]:
            at += -at % 8
            buffers.append(data[at : at + length])
            at += length
        for message in batch["messages"]:
            if message["type"] in {"SetCameraPositionMessage", "SetCameraLookAtMessage"}:
                self.camera |= message
            for key, value in {**(message.get("props") or {}), **(message.get("updates") or {})}.items():
                if isinstance(value, dict) and "__binary_index" in value and key in ARRAYS:
                    self.arrays[message["name"], key] = np.frombuffer(buffers[value["__binary_index"]], "<f4")
                    self.updates += 1

    def tell_camera(self, **changed: Any) -> None:
        """Tell the server of the camera, as a scene does when it is loaded; the server knows of a scene since then."""
        camera = {
            "type": "ViewerCameraMessage",
            "wxyz": (1.0, 0.0, 0.0, 0.0),
            "position": (3.0, 0.0, 0.0),
            "look_at": (0.0, 0.0, 0.0),
            "up_direction": (0.0, 0.0, 1.0),
            "fov": 1.0,
            "near": 0.1,
            "far": 100.0,
            "image_height": 300,
            "image_width": 400,
        }
        self.socket.send(msgspec.msgpack.encode(camera | changed))

    def abort(self) -> None:
        """End the connection by a reset, as a browser that is killed does."""
        with suppress(OSError):  # the viewer has ended it
            self.socket.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        self.socket.socket.close()
        self.socket.recv_messages.close()  # or the client's thread would wait for ever until messages are read


ARRAYS = ("batched_positions", "points")
