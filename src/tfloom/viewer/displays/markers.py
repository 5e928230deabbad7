"""Markers, by namespace and number, until they are deleted or their lifetime is over."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from tfloom.interfaces.visualization_msgs.msg import Marker
from tfloom.viewer.displays.display import (
    are_drawable,
    color_of,
    finite_points,
    point_table,
    pose_of,
    shown_text,
    stamp_of,
)
from tfloom.viewer.displays.poses import line_strip
from tfloom.viewer.mesh_files import read_model
from tfloom.viewer.page_command import fault_text
from tfloom.viewer.shapes import (
    AT_VIEW,
    Arrows,
    Ball,
    Box,
    Copies,
    Cylinder,
    DisplayError,
    Lines,
    Mesh,
    Placed,
    Points,
    Shape,
    Text,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.displays.settings import Values

__all__ = ["MarkerDisplay"]

MAX_MARKERS = 2000
"""Number of markers that are kept; of more, those whose lifetime is over are dropped, and further ones not shown."""
MAX_POINTS = 200_000
"""Number of a marker's points that are drawn."""
KIND_NAMES = {
    getattr(Marker, name): name.lower()
    for name in (
        *("ARROW", "CUBE", "SPHERE", "CYLINDER", "LINE_STRIP", "LINE_LIST", "CUBE_LIST", "SPHERE_LIST"),
        *("POINTS", "TEXT_VIEW_FACING", "MESH_RESOURCE", "TRIANGLE_LIST"),
    )
}


class MarkerDisplay:
    """Shows `visualization_msgs/msg/Marker` and `MarkerArray`: all that are alive.

    Args:
        settings: A value for each setting; it may change.
    """

    keeps_all = True
    choices: Sequence[str] = ()
    choice = ""

    def __init__(self, settings: Values) -> None:
        self.settings = settings
        self._markers: dict[tuple[str, int], tuple[int, list[Placed]]] = {}
        """The end of each marker [ns since epoch; 0: none] and its shapes, by namespace and number."""

    def take(self, message: Any, stamp_ns: int) -> None:
        """Add, change or delete markers. Those that can be shown are, even where others of one array can't.

        Raises:
            DisplayError: one of them can't be shown.
        """
        faults = []
        markers = message.markers if hasattr(message, "markers") else [message]
        if len(self._markers) + len(markers) > MAX_MARKERS:
            self._drop_ended(stamp_ns)
        for marker in markers:
            key = str(marker.ns), int(marker.id)
            if marker.action == Marker.DELETEALL:
                self._markers.clear()
            elif marker.action == Marker.DELETE:
                self._markers.pop(key, None)
            elif marker.action != Marker.ADD:
                faults.append(_fault(key, f"its action is {marker.action}, which is not known"))
            elif key in self._markers or len(self._markers) < MAX_MARKERS:
                self._markers.pop(key, None)
                try:
                    self._markers[key] = _end_ns(marker, stamp_ns), shapes_of_marker(marker)
                except Exception as error:  # of one marker: the others are shown
                    faults.append(_fault(key, fault_text(error)))
            else:
                faults.append(f"there are more than {MAX_MARKERS} markers")
        if faults:
            raise DisplayError(faults[0] if len(faults) == 1 else f"{faults[0]} (and {len(faults) - 1} more)")

    def _drop_ended(self, stamp_ns: int) -> None:
        self._markers = {key: kept for key, kept in self._markers.items() if not 0 < kept[0] < stamp_ns}

    def clear(self) -> None:
        """Forget all markers."""
        self._markers.clear()

    def saved(self) -> dict[tuple[str, int], tuple[int, list[Placed]]]:
        """Return the markers."""
        return self._markers.copy()

    def restore(self, saved: dict[tuple[str, int], tuple[int, list[Placed]]]) -> None:
        """Have the markers that were saved."""
        self._markers = saved.copy()

    def parts(self) -> list[str]:
        """Return the namespaces."""
        return sorted({namespace for namespace, _ in self._markers})

    def shapes(self, now_ns: int) -> list[Placed]:
        """Return the shapes of the markers that are alive, but for those of namespaces that are hidden."""
        hidden = self.settings["hidden_namespaces"]
        return [
            shape
            for (namespace, _), (end_ns, shapes) in list(self._markers.items())
            if namespace not in hidden and (not end_ns or now_ns <= end_ns)
            for shape in shapes
        ]


def _fault(key: tuple[str, int], reason: str) -> str:
    return f"marker {key[1]} of {shown_text(key[0], 40)!r}: {reason}"


def _end_ns(marker: Any, stamp_ns: int) -> int:
    lifetime_ns = int(marker.lifetime.sec) * 1_000_000_000 + int(marker.lifetime.nanosec)
    return stamp_ns + lifetime_ns if lifetime_ns > 0 else 0


def shapes_of_marker(marker: Any) -> list[Placed]:
    """Return the shapes of a marker.

    Raises:
        DisplayError: its pose, its sizes or its kind are wrong.
    """
    position, rotation = pose_of(marker.pose)
    stamp_ns = AT_VIEW if marker.frame_locked else stamp_of(marker.header)
    return [Placed(shape, marker.header.frame_id, stamp_ns, position, rotation) for shape in _shapes(marker)]


def _shapes(marker: Any) -> Iterator[Shape]:
    x, y, z = (abs(float(part)) for part in (marker.scale.x, marker.scale.y, marker.scale.z))
    if not max(x, y, z) < 1e9:
        raise DisplayError("its scale is not finite")
    color, opacity = color_of(marker.color)
    kind = marker.type
    if kind == Marker.ARROW:
        yield from _arrow(marker, (x, y, z))
    elif kind == Marker.CUBE:
        yield Box((x, y, z), color, opacity)
    elif kind == Marker.SPHERE:
        yield Ball((x / 2.0, y / 2.0, z / 2.0), color, opacity)
    elif kind == Marker.CYLINDER:
        yield Cylinder(x / 2.0, z, color, opacity)
    elif kind == Marker.TEXT_VIEW_FACING:
        yield Text(shown_text(marker.text), z or 0.2)
    elif kind == Marker.MESH_RESOURCE:
        yield read_model(
            marker.mesh_resource, (float(marker.scale.x), float(marker.scale.y), float(marker.scale.z))
        )
    elif kind in KIND_NAMES:
        yield from _list_shapes(marker, (x, y, z))
    else:
        raise DisplayError(f"its type is {kind}, which is not known")


def _arrow(marker: Any, scale: tuple[float, float, float]) -> Iterator[Shape]:
    color, _ = color_of(marker.color)
    if len(marker.points) == 2:
        ends = finite_points(marker.points).reshape(-1, 3)
        if len(ends) == 2:
            yield Arrows(ends[np.newaxis], color, max(scale[0], 0.001) / 2.0)
    else:
        yield Arrows(np.array([[(0, 0, 0), (scale[0], 0, 0)]], np.float32), color, max(scale[1], 0.001) / 2.0)


def _list_shapes(marker: Any, scale: tuple[float, float, float]) -> Iterator[Shape]:
    """Yield the shape of a marker that has many points, which may have a colour each."""
    points = marker.points[:MAX_POINTS]
    # Two points make a line, three a triangle: of one that can't be drawn as a whole, nothing is.
    group = {Marker.LINE_LIST: 2, Marker.TRIANGLE_LIST: 3}.get(marker.type, 1)
    points = points[: len(points) // group * group]
    table = point_table(points)
    colors = _colors(marker, len(table))
    is_drawable = np.repeat(are_drawable(table.reshape(-1, 3 * group)), group)
    table, colors = table[is_drawable], colors[is_drawable]
    color, opacity = color_of(marker.color)
    if not len(table):
        return
    if marker.type == Marker.POINTS:
        yield Points(table, colors, scale[0] or 0.03)
    elif marker.type in {Marker.CUBE_LIST, Marker.SPHERE_LIST}:
        kind: Literal["box", "ball"] = "box" if marker.type == Marker.CUBE_LIST else "ball"
        yield Copies(kind, table, scale, colors, opacity)
    elif marker.type == Marker.LINE_STRIP and len(table) > 1:
        yield Lines(line_strip(table), line_strip(colors), _width_px(scale[0]))
    elif marker.type == Marker.LINE_LIST:
        yield Lines(table.reshape(-1, 2, 3), colors.reshape(-1, 2, 3), _width_px(scale[0]))
    elif marker.type == Marker.TRIANGLE_LIST:
        vertices = table * np.array([part or 1.0 for part in scale], np.float32)
        if len(marker.colors):
            mean = colors.mean(axis=0)
            color = int(mean[0]), int(mean[1]), int(mean[2])
        faces = np.arange(len(vertices), dtype=np.uint32).reshape(-1, 3)
        yield Mesh(vertices, faces, color, opacity or 1.0)


def _width_px(width_m: float) -> float:
    """Return the width of a line on the screen for one in metres: a usual view shows a metre as about 100 px."""
    return float(np.clip(100.0 * width_m, 1.0, 20.0)) if math.isfinite(width_m) else 2.0


def _colors(marker: Any, count: int) -> NDArray[np.uint8]:
    """Return a colour for each point: its own, or the marker's."""
    colors = np.empty((count, 3), np.uint8)
    colors[:] = color_of(marker.color)[0]
    if len(marker.colors) >= count:
        for number, color in enumerate(marker.colors[:count]):
            colors[number] = color_of(color)[0]
    return colors
