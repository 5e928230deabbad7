"""The callbacks by which a listener holds transforms stamped far ahead of now; the native sink decides which ones.

They refer to the listener weakly, because the wire and the clock keep them.
"""

from __future__ import annotations

import weakref
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from tfloom.tf2_ros.deadlines import call_after

__all__ = ["held_callback", "jump_callback", "warn_of_held"]


def held_callback(
    warn: weakref.WeakMethod[Callable[[bytes, str, int, int], None]],
) -> Callable[[list[int], str, int, int], None]:
    """Return the `on_held` of a sink: it calls `warn(gid, child_frame_id, stamp_ns, now_ns)`."""

    def run(gid: bytes, child_frame_id: str, stamp_ns: int, now_ns: int) -> None:
        with suppress(Exception):  # the node may be destroyed meanwhile
            if (living := warn()) is not None:
                living(gid, child_frame_id, stamp_ns, now_ns)

    def on_held(gid: list[int], child_frame_id: str, stamp_ns: int, now_ns: int) -> None:
        # On another thread, because this one may be the wire's, which must not wait, and the warning reads the graph.
        call_after(0.0, lambda: run(bytes(gid), child_frame_id, stamp_ns, now_ns))

    return on_held


def jump_callback(on_jump: weakref.WeakMethod[Callable[[Any], None]]) -> Callable[[Any], None]:
    """Return the callback of a clock: it calls `on_jump(time_jump)`."""

    def run(jump: Any) -> None:
        if (living := on_jump()) is not None:
            living(jump)

    return run


def warn_of_held(node: Any, topic: str, gid: bytes, child_frame_id: str, stamp_ns: int, now_ns: int) -> None:
    """Log that a publisher's transform is held."""
    node.get_logger().warning(
        f"The transform of {child_frame_id!r} from {_publisher(node, topic, gid)} on {topic} is stamped "
        f"{(stamp_ns - now_ns) / 1e9:.3f} s ahead of now (at {stamp_ns / 1e9:.3f}). It and others like it are held "
        "until this publisher's next one confirms that its clock is ahead: check its stamps, and the clocks"
    )


def _publisher(node: Any, topic: str, gid: bytes) -> str:
    """Return the name of the node to which a publisher belongs, and its gid as `topic info -v` prints it."""
    names = (
        f"{info.node_namespace.rstrip('/')}/{info.node_name}, "
        for info in node.get_publishers_info_by_topic(topic)
        if bytes(info.endpoint_gid) == gid
    )
    return f"{next(names, '')}GID {'.'.join(f'{byte:02x}' for byte in gid)},"
