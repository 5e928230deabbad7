"""Points of a laser scan, as `laser_geometry` has them: in the frame of the scan, which is taken for one instant."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tfloom.interfaces.sensor_msgs.msg import LaserScan, PointCloud2, PointField
from tfloom.tf2_ros.point_clouds.point_cloud2 import create_cloud

__all__ = ["LaserProjection"]


class LaserProjection:
    """Turns laser scans into point clouds."""

    LASER_SCAN_INVALID = -1.0
    LASER_SCAN_MIN_RANGE = -2.0
    LASER_SCAN_MAX_RANGE = -3.0

    class ChannelOption:
        """What a point has beside its position; the numbers are added."""

        NONE = 0x00
        INTENSITY = 0x01
        INDEX = 0x02
        DISTANCE = 0x04
        TIMESTAMP = 0x08
        VIEWPOINT = 0x10
        DEFAULT = INTENSITY | INDEX

    def projectLaser(
        self,
        scan_in: LaserScan,
        range_cutoff: float = -1.0,
        channel_options: int = ChannelOption.DEFAULT,
    ) -> PointCloud2:
        """Return the points of a scan whose ranges are valid: at least `range_min`, and below the cutoff.

        Args:
            scan_in: The scan.
            range_cutoff: Range from which on points are left out [m]; below 0, or beyond the scan's `range_max`: that.
            channel_options: A sum of `ChannelOption`.

        Returns:
            Unordered points with float32 fields x, y, z [m], and those of the options: intensity (if the scan has
            some), index (int32, of the scan's ranges), distances [m], stamps [s after the scan's], vp_x, vp_y, vp_z.
        """
        ranges = np.asarray(scan_in.ranges, np.float32)
        end = scan_in.range_max if range_cutoff < 0 else min(range_cutoff, scan_in.range_max)
        index = np.flatnonzero((ranges >= scan_in.range_min) & (ranges < end))
        kept = ranges[index].astype(np.float64)
        angles = scan_in.angle_min + index * scan_in.angle_increment
        columns = {"x": kept * np.cos(angles), "y": kept * np.sin(angles), "z": np.zeros(len(index))}
        columns |= _channels(scan_in, index, kept, channel_options)
        points = np.empty(len(index), [(name, "<i4" if name == "index" else "<f4") for name in columns])
        for name, column in columns.items():
            points[name] = column
        fields = [
            PointField(
                name=name,
                offset=4 * place,
                datatype=PointField.INT32 if name == "index" else PointField.FLOAT32,
                count=1,
            )
            for place, name in enumerate(columns)
        ]
        cloud = create_cloud(scan_in.header, fields, points)
        cloud.is_dense = False
        return cloud


def _channels(
    scan: LaserScan, index: npt.NDArray[np.intp], ranges: npt.NDArray[np.float64], options: int
) -> dict[str, npt.NDArray[Any]]:
    option = LaserProjection.ChannelOption
    channels: dict[str, npt.NDArray[Any]] = {}
    intensities = np.asarray(scan.intensities, np.float32)
    if options & option.INTENSITY and len(intensities):
        # A scan may have fewer intensities than ranges: the points without one get 0.
        padded = np.zeros(max(len(scan.ranges), len(intensities)), np.float32)
        padded[: len(intensities)] = intensities
        channels["intensity"] = padded[index]
    if options & option.INDEX:
        channels["index"] = index
    if options & option.DISTANCE:
        channels["distances"] = ranges
    if options & option.TIMESTAMP:
        channels["stamps"] = index * scan.time_increment
    if options & option.VIEWPOINT:
        channels.update(dict.fromkeys(("vp_x", "vp_y", "vp_z"), np.zeros(len(index))))
    return channels
