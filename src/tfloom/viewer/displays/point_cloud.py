"""Points of clouds and laser scans, coloured by a field, by an axis, or all alike."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from tfloom.tf2_ros.point_clouds.point_cloud2 import points_view
from tfloom.viewer.color_scale import AxisColors, ColorScale
from tfloom.viewer.displays.display import Latest, are_drawable, point_table, stamp_of
from tfloom.viewer.shapes import Copies, DisplayError, Placed, Points

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from tfloom.viewer.displays.settings import Values

__all__ = ["OldCloudDisplay", "PointCloudDisplay", "PointsDisplay", "drawn_points"]

MAX_POINTS = 400_000
"""Number of points that are drawn; of more, every second one is, or every third."""
MAX_SOLIDS = 50_000
"""… as boxes, and where they are transparent."""
MAX_COLUMNS = 500
"""Number of a point's numbers."""
COLOR_FIELDS = ("rgb", "rgba")
"""Fields with a packed colour."""
USUAL_FIELDS = (*COLOR_FIELDS, "intensity", "z")
"""Fields that colour the points where none is chosen, the first one that the cloud has."""


class PointsDisplay(Latest):
    """Shows points, coloured by what is chosen or set."""

    usual_fields: Sequence[str] = USUAL_FIELDS

    def drawn(
        self, positions: NDArray[np.float32], fields: Mapping[str, NDArray[Any]], header: Any
    ) -> list[Placed]:
        """Return points as the settings say; those that can't be drawn are left out.

        Args:
            positions: (N, 3) [m].
            fields: Further numbers of the points (N,), by name.
            header: The message's header.
        """
        self.choices = *(axis for axis in "xyz" if axis not in fields), *fields
        is_drawable = are_drawable(positions)
        if not is_drawable.all():
            positions = positions[is_drawable]
            fields = {name: values[is_drawable] for name, values in fields.items()}
        if not len(positions):
            return []
        shape = drawn_points(np.ascontiguousarray(positions), self._colors(positions, fields), self.settings)
        return [Placed(shape, header.frame_id, stamp_of(header))]

    def _colors(
        self, positions: NDArray[np.float32], fields: Mapping[str, NDArray[Any]]
    ) -> NDArray[np.uint8] | AxisColors:
        settings = self.settings
        if settings["color_by"] == "flat":
            return np.array(settings["color"], np.uint8)
        if settings["color_by"] == "axis":
            return _axis_colors(settings)
        every = {**{axis: positions[:, number] for number, axis in enumerate("xyz")}, **fields}
        chosen = (
            self.choice
            if self.choice in every
            else next((name for name in self.usual_fields if name in every), "")
        )
        if not chosen:
            return np.array(settings["color"], np.uint8)
        values = every[chosen]
        if chosen in COLOR_FIELDS and values.dtype.itemsize == 4:
            # The bytes of a number: blue, green, red and opacity, from the least significant one on.
            packed = np.ascontiguousarray(values).astype(values.dtype.newbyteorder("<")).view("<u4")
            return np.stack([packed >> shift & 0xFF for shift in (16, 8, 0)], axis=1).astype(np.uint8)
        ends = None if settings["auto_range"] else (settings["low"], settings["high"])
        return _scale(settings, ends).of(values)


def _scale(settings: Values, ends: tuple[float, float] | None) -> ColorScale:
    colors = None if settings["rainbow"] else (settings["low_color"], settings["high_color"])
    return ColorScale(ends, colors, settings["invert"])


def _axis_colors(settings: Values) -> AxisColors:
    ends = None if settings["axis_auto_range"] else (settings["axis_low"], settings["axis_high"])
    return AxisColors(_scale(settings, ends), "xyz".index(settings["axis"]), settings["axis_fixed"])


def drawn_points(
    positions: NDArray[np.float32], colors: NDArray[np.uint8] | AxisColors, settings: Values
) -> Points | Copies:
    """Return points (N, 3) as settings say."""
    style, size, opacity = settings["style"], settings["size"], settings["opacity"]
    by_axis = colors if isinstance(colors, AxisColors) else None
    drawn = by_axis.of(positions, None) if by_axis is not None else np.asarray(colors, np.uint8)
    if style != "boxes" and opacity >= 1.0:
        return Points(
            positions,
            drawn,
            size,
            size_px=settings["size_px"] if style == "points" else None,
            form="square" if style == "squares" else "circle",
            by_axis=by_axis,
        )
    step = -(-len(positions) // MAX_SOLIDS) or 1
    table = np.broadcast_to(drawn, positions.shape)[::step]
    kind: Literal["box", "ball"] = "box" if style in {"squares", "boxes"} else "ball"
    return Copies(kind, positions[::step], (size,) * 3, np.ascontiguousarray(table), opacity, by_axis)


class PointCloudDisplay(PointsDisplay):
    """Shows `sensor_msgs/msg/PointCloud2`; one of a wrong layout, or without x, y and z, is an error."""

    def shapes_of(self, message: Any) -> list[Placed]:
        """Return the points.

        Raises:
            DisplayError: its layout is wrong, or it has no x, y and z.
        """
        # A field is a column for each of its elements, of which a message may claim billions.
        if sum(int(field.count) for field in message.fields) > MAX_COLUMNS:
            raise DisplayError(f"its points have more than {MAX_COLUMNS} numbers each")
        try:
            points = points_view(message).ravel()
        except (ValueError, AssertionError, TypeError) as error:
            raise DisplayError(f"its layout is wrong: {error}") from None
        names = points.dtype.names or ()
        if not {"x", "y", "z"} <= set(names):
            raise DisplayError(f"it has no fields x, y and z, but {', '.join(names) or 'none'}")
        step = -(-len(points) // MAX_POINTS) or 1
        points = points[::step]
        with np.errstate(over="ignore"):
            positions = np.stack([points[axis].astype(np.float32) for axis in "xyz"], axis=1)
        return self.drawn(positions, {name: points[name] for name in names}, message.header)


class OldCloudDisplay(PointsDisplay):
    """Shows `sensor_msgs/msg/PointCloud`, by its channels."""

    def shapes_of(self, message: Any) -> list[Placed]:
        """Return the points."""
        step = -(-len(message.points) // MAX_POINTS) or 1
        count = len(message.points)
        with np.errstate(over="ignore"):
            channels = {
                str(channel.name): np.asarray(channel.values, np.float64)[::step]
                for channel in message.channels[:MAX_COLUMNS]
                if len(channel.values) == count
            }
        return self.drawn(point_table(message.points[::step]), channels, message.header)
