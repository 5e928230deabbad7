"""Point clouds, coloured by a field."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tfloom.tf2_ros.point_clouds.point_cloud2 import points_view
from tfloom.viewer.displays.display import POINT_PX, Latest, are_drawable, finite_points, rainbow, stamp_of
from tfloom.viewer.shapes import DisplayError, Placed, Points

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["PointCloudDisplay", "shapes_of_old_cloud"]

MAX_POINTS = 400_000
"""Number of points that are drawn; of more, every second one is, or every third."""
MAX_COLUMNS = 500
"""Number of a point's numbers."""
COLOR_FIELDS = ("rgb", "rgba")
"""Fields with a packed colour."""
USUAL_FIELDS = (*COLOR_FIELDS, "intensity", "z")
"""Fields that colour the points where none is chosen, the first one that the cloud has."""


class PointCloudDisplay(Latest):
    """Shows the last `sensor_msgs/msg/PointCloud2`; one of a wrong layout, or without x, y and z, is an error."""

    def __init__(self) -> None:
        super().__init__(self._points_of)

    def _points_of(self, message: Any) -> list[Placed]:
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
        self.choices = names
        step = -(-len(points) // MAX_POINTS) or 1
        points = points[::step]
        with np.errstate(over="ignore"):
            positions = np.stack([points[axis].astype(np.float32) for axis in "xyz"], axis=1)
        is_drawable = are_drawable(positions)
        if not is_drawable.all():
            positions, points = positions[is_drawable], points[is_drawable]
        if not len(points):
            return []
        chosen = self.choice if self.choice in names else next(name for name in USUAL_FIELDS if name in names)
        shape = Points(np.ascontiguousarray(positions), _colors(points[chosen], chosen), size_px=POINT_PX)
        return [Placed(shape, message.header.frame_id, stamp_of(message.header))]


def _colors(values: NDArray[Any], field: str) -> NDArray[np.uint8]:
    if field in COLOR_FIELDS and values.dtype.itemsize == 4:
        # The bytes of a number: blue, green, red and opacity, from the least significant one on.
        packed = np.ascontiguousarray(values).astype(values.dtype.newbyteorder("<")).view("<u4")
        return np.stack([packed >> shift & 0xFF for shift in (16, 8, 0)], axis=1).astype(np.uint8)
    return rainbow(values)


def shapes_of_old_cloud(message: Any) -> list[Placed]:
    """Return the points of a `sensor_msgs/msg/PointCloud`, by their height."""
    step = -(-len(message.points) // MAX_POINTS) or 1
    positions = finite_points(message.points[::step])
    if not len(positions):
        return []
    shape = Points(positions, rainbow(positions[:, 2]), size_px=POINT_PX)
    return [Placed(shape, message.header.frame_id, stamp_of(message.header))]
