"""What pages drag: the gizmos of controls, as nodes of viser's scene."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from itertools import count
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.tf2.transform import Transform

if TYPE_CHECKING:
    from viser import SceneApi

    from tfloom.viewer.displays.interactive_markers import Handle

__all__ = ["Event", "Gizmo", "Gizmos", "Key"]

Key = tuple[str, int]
"""The name of a marker, and the number of its control."""
MOVED = 1e-9
"""A gizmo that has moved less stays where it is."""
MAX_GIZMOS = 500
"""Number of gizmos that are drawn."""
_NUMBERS = count()
"""Of the nodes of all displays in one scene."""


class Gizmo(NamedTuple):
    """A gizmo that is to be there."""

    handle: Handle
    size_m: float
    place: Transform
    """Its pose in the fixed frame."""


class Event(NamedTuple):
    """What a page has done with a gizmo, or with a shape of a control in its place."""

    key: Key
    client: int
    """Viser's number of the page's scene."""
    phase: str
    """`start`, `update` or `end`."""
    place: Transform
    """Where the gizmo is, in the fixed frame."""
    is_of_shape: bool = False
    """Whether it was done with a shape: the gizmo goes where the marker goes."""


class Gizmos:
    """The gizmos of one display. One thread may use it.

    Args:
        scene: Viser's scene.
        on_event: Called with what pages do, in its order, on the thread of viser; it must not wait.
    """

    def __init__(self, scene: SceneApi, on_event: Callable[[Event], None]) -> None:
        self._scene = scene
        self._on_event = on_event
        self._nodes: dict[Key, tuple[Handle, float, Any]] = {}
        self._free_names: list[str] = []

    def draw(self, wanted: Mapping[Key, Gizmo], dragged: Collection[Key]) -> str:
        """Have these gizmos, and no others.

        Args:
            wanted: The gizmos.
            dragged: Those that a page holds: they stay where it has them.

        Returns:
            Why not all are there; empty if they are.
        """
        shown = dict(list(wanted.items())[:MAX_GIZMOS])
        for key in self._nodes.keys() - shown.keys():
            self._remove(key)
        for key, gizmo in shown.items():
            handle, size_m, node = self._nodes.get(key, (None, 0.0, None))
            if (handle, size_m) != (gizmo.handle, gizmo.size_m):
                self._remove(key)
                node = self._add(key, gizmo)
            if key not in dragged:
                _place(node, gizmo.place)
        return (
            ""
            if len(wanted) <= MAX_GIZMOS
            else f"{len(wanted)} controls, of which {MAX_GIZMOS} can be dragged"
        )

    def _add(self, key: Key, gizmo: Gizmo) -> Any:
        # Nodes' names are used again: the scene keeps a note of each that was ever removed.
        name = self._free_names.pop() if self._free_names else f"/handles/{next(_NUMBERS)}"
        node = self._scene.add_transform_controls(
            name,
            gizmo.size_m,
            active_axes=gizmo.handle.axes,
            disable_axes=not gizmo.handle.moves_on_axes,
            disable_sliders=not gizmo.handle.moves_in_planes,
            disable_rotations=not gizmo.handle.rotates,
            depth_test=False,
        )

        async def hear(event: Any) -> None:  # not on viser's pool of threads, where the order would be lost
            place = _place_of(event.target)
            if place is not None and event.client_id is not None:
                self._on_event(Event(key, event.client_id, event.phase, place))

        node.on_update(hear)
        self._nodes[key] = gizmo.handle, gizmo.size_m, node
        return node

    def _remove(self, key: Key) -> None:
        if (before := self._nodes.pop(key, None)) is not None:
            self._free_names.append(before[2].name)
            before[2].remove()

    def clear(self) -> None:
        """Remove all of them."""
        for key in list(self._nodes):
            self._remove(key)


def _place(node: Any, place: Transform) -> None:
    x, y, z, w = place.rotation_xyzw
    if np.abs(np.asarray(node.position) - place.translation).max() > MOVED:
        node.position = place.translation
    if np.abs(np.asarray(node.wxyz) - (w, x, y, z)).max() > MOVED:
        node.wxyz = w, x, y, z


def _place_of(node: Any) -> Transform | None:
    """Return where a page has a gizmo; None where that is not finite, or no rotation."""
    position, wxyz = np.asarray(node.position, np.float64), np.asarray(node.wxyz, np.float64)
    length = float(np.linalg.norm(wxyz))
    if not np.isfinite(position).all() or not np.isfinite(length) or length < 1e-6:
        return None
    w, x, y, z = (wxyz / length).tolist()
    a, b, c = position.tolist()
    return Transform((a, b, c), (x, y, z, w))
