"""What of viser is used though viser doesn't publish it; checked at import, because any version may change it.

Its public API has neither the messages of its client nor a connection's headers, and it lets any page ask for a tunnel
to the internet.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec
import viser
from viser.infra import WebsockServer

from tfloom.viewer.camera import is_usable
from tfloom.viewer.displays.display import MAX_COORDINATE_M

if TYPE_CHECKING:
    from collections.abc import Mapping

__all__ = [
    "HAS_PIXEL_POINTS",
    "connections_of",
    "open_connections",
    "pixel_size",
    "said_by_scene",
]

SCENE_MESSAGES = (
    "ViewerCameraMessage",
    "SceneNodeClickMessage",
    "SceneNodeDragMessage",
    "ScenePointerMessage",
    "TransformControlsDragStartMessage",
    "TransformControlsUpdateMessage",
    "TransformControlsDragEndMessage",
)
"""What viser's client may send to its server; the rest, as requests for a tunnel, is dropped."""
DRAWN_MESSAGE = "TfloomDrawn"
"""What `page/scene.js` sends when messages have been drawn, which is for the relay; viser has no such message."""
TUNNEL_MESSAGES = ("ShareUrlRequest", "ShareUrlDisconnect")
"""Requests for a tunnel to the internet, which are not handled."""
POINT_SIZE = "gl_PointSize = (scale / -world_pos.z);"
"""How the shader of viser's client computes the size of a point; `page/scene.js` replaces it."""
CAMERA_FIELDS = ("wxyz", "position", "fov", "image_height", "image_width", "look_at")


def missing_names(messages: Any, server: type[Any], connections: type[Any]) -> list[str]:
    """Return the names that a version of viser lacks.

    Args:
        messages: Its module of messages.
        server: Its class of servers.
        connections: Its class of servers of WebSockets.
    """
    names = [name for name in (*SCENE_MESSAGES, *TUNNEL_MESSAGES, "Message") if not hasattr(messages, name)]
    camera = getattr(getattr(messages, SCENE_MESSAGES[0], None), "__dataclass_fields__", {})
    names += [f"{SCENE_MESSAGES[0]}.{field}" for field in CAMERA_FIELDS if field not in camera]
    # These are of an object, not of its class: its constructor sets them.
    for made, name in ((server, "_websock_server"), (connections, "_live_connections")):
        if name not in made.__init__.__code__.co_names:
            names.append(f"{made.__name__}.{name}")
    return names


try:
    from viser import _messages
except ImportError:
    _messages = None  # type: ignore[assignment]
if missing := missing_names(_messages, viser.ViserServer, WebsockServer):
    raise ImportError(
        f"viser {viser.__version__} lacks what tfloom.viewer uses: {', '.join(missing)}; "
        "install a version that the extra `view` names: pip install 'tfloom[view]'"
    )


def has_pixel_points(client: Path) -> bool:
    """Return whether viser's client, by its source beside the compiled one, has what `page/scene.js` replaces."""
    try:
        source = (client / "src" / "ThreeAssets.tsx").read_text(encoding="utf-8")
    except (OSError, ValueError):
        return False
    return source.count(POINT_SIZE) == 1


HAS_PIXEL_POINTS = has_pixel_points(Path(viser.__file__).parent / "client")
"""Whether points can have a size in pixels; else they have one in metres."""


def pixel_size(size_px: float) -> float:
    """Return the size that points of viser's client have to have, so that `page/scene.js` takes it for pixels."""
    return -0.001 * size_px


def connections_of(server: viser.ViserServer) -> WebsockServer:
    """Return the server of WebSockets behind a server of viser, without handlers of requests for a tunnel."""
    connections: WebsockServer = server._websock_server  # noqa: SLF001  # there is no public way to it
    for name in TUNNEL_MESSAGES:
        connections.unregister_handler(getattr(_messages, name))
    return connections


def open_connections(connections: WebsockServer) -> Mapping[int, Any]:
    """Return the open connections of a server by their numbers, which changes as they come and go."""
    live: Mapping[int, Any] = connections._live_connections  # noqa: SLF001  # there is no public way to their headers
    return live


def said_by_scene(data: bytes) -> int | bytes | None:
    """Return what a page's scene says by a message, which may be any bytes.

    Returns:
        How many of the messages to it are drawn; the message itself if it is for viser, viser can read it, and its
        camera can be used; None for anything else.
    """
    try:
        said = msgspec.msgpack.decode(data)
        if said["type"] == DRAWN_MESSAGE:
            return said["count"] if type(said["count"]) is int else None
        if said["type"] in SCENE_MESSAGES and _is_usable(_messages.Message.deserialize(data)):
            return data
    except Exception:  # viser has no error for what can't be read
        return None
    return None


def _is_usable(message: Any) -> bool:
    if isinstance(message, _messages.ViewerCameraMessage):
        aspect = message.image_width / message.image_height
        return is_usable(message.position, message.look_at, message.wxyz, message.fov, aspect)
    if isinstance(message, _messages.TransformControlsUpdateMessage):
        numbers = (*message.position, *message.wxyz)
        return len(numbers) == 7 and all(abs(part) < MAX_COORDINATE_M for part in numbers)
    return True
