"""Depth images as clouds, by the camera info beside each."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from tfloom.viewer.displays.camera_info import INFO_TYPE, info_topic_of, pinhole_of
from tfloom.viewer.displays.point_cloud import MAX_POINTS, PointsDisplay
from tfloom.viewer.pictures import pixel_table
from tfloom.viewer.shapes import DisplayError, Placed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.displays.camera_info import Pinhole
    from tfloom.viewer.displays.settings import Values

__all__ = ["DepthCloudDisplay"]

DEPTHS = {"16UC1": ("u2", 0.001), "32FC1": ("f4", 1.0)}
"""Type of the numbers of each encoding, and their unit [m]."""


class DepthCloudDisplay(PointsDisplay):
    """Shows a `sensor_msgs/msg/Image` of depths, in the image's frame: x to the right, y down, z forward.

    Attributes:
        partner: How the camera sees; None: that is not known.
        absence: Why not.
    """

    partner_type = INFO_TYPE
    partner_name = "camera info"

    def __init__(self, settings: Values) -> None:
        super().__init__(settings)
        self.partner: Pinhole | None = None
        self.absence = "its camera info is not known"

    def partner_topic(self, topic: str) -> str:
        """Return the topic of the camera info: the one beside the image."""
        return info_topic_of(topic)

    def partner_of(self, message: Any) -> Pinhole:
        """Return how the camera of a camera info sees.

        Raises:
            DisplayError: it is not calibrated.
        """
        return pinhole_of(message)

    def shapes_of(self, message: Any) -> list[Placed]:
        """Return a point for each pixel that has a depth: one of zero, or that is not finite, is none.

        Raises:
            DisplayError: it is not an image of depths, its sizes are wrong, or its camera is not known.
        """
        if message.encoding not in DEPTHS:
            encodings = " or ".join(DEPTHS)
            raise DisplayError(
                f"its encoding is {message.encoding[:60]!r}, and that of depths is {encodings}"
            )
        kind, unit_m = DEPTHS[message.encoding]
        table = pixel_table(message, kind, 1)[:, :, 0]
        camera = self.partner
        if camera is None:
            raise DisplayError(self.absence)
        height, width = table.shape
        if (width, height) != (camera.width, camera.height):
            raise DisplayError(
                f"it has {width} by {height} pixels, and its camera info is of {camera.width} by "
                f"{camera.height}"
            )
        return self.drawn(_points(table, unit_m, camera), {}, message.header)


def _points(table: NDArray[Any], unit_m: float, camera: Pinhole) -> NDArray[np.float32]:
    """Return the points of depths (H, W), in units, in the camera's optical frame (N, 3) [m]."""
    # Of a large image, rows and columns are left out alike, so that the cloud is as dense in both directions.
    step = math.ceil(math.sqrt(table.size / MAX_POINTS))
    depths = table[::step, ::step].astype(np.float64) * unit_m
    rows, columns = np.nonzero(np.isfinite(depths) & (depths > 0.0))
    every = -(-len(rows) // MAX_POINTS) or 1  # one that is long and narrow has too many still
    rows, columns = rows[::every], columns[::every]
    z = depths[rows, columns]
    with np.errstate(over="ignore"):
        x = (columns * step - camera.cx) / camera.fx * z
        y = (rows * step - camera.cy) / camera.fy * z
        return np.stack([x, y, z], axis=1).astype(np.float32)
