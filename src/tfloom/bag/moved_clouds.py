"""The clouds of a recording, transformed and deskewed one after the other."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any

from tfloom.bag.bag import Bag
from tfloom.bag.errors import BagError
from tfloom.bag.opening import open_bag
from tfloom.tf2.buffer import Buffer

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["clouds", "point_stamps"]

TIME_FIELDS = ("t", "time", "timestamp", "time_stamp", "offset_time")
"""Names of the field with the time of a point, of which the first one that a cloud has is used."""
TYPE = "sensor_msgs/msg/PointCloud2"
EPOCH_S = 1e6
"""Seconds of a point from which on they count since the epoch, not since the cloud's stamp."""


def clouds(
    bag: str | os.PathLike[str] | Bag,
    topic: str,
    buffer: Buffer,
    target_frame: str,
    *,
    fixed_frame: str | None = None,
    time_field: str | None = None,
    seconds_per_unit: float | None = None,
    start_ns: int | None = None,
    end_ns: int | None = None,
    skip_unknown: bool = False,
) -> Iterator[Any]:
    """Yield the clouds of a topic in another frame: only one is in memory at a time.

    With `fixed_frame`, each point is transformed at its own time, by way of that frame, to the target at the cloud's
    stamp. Without it, all points of a cloud are transformed at the cloud's stamp.

    Args:
        bag: The path of a recording, as `open_bag` takes it, or an open one.
        topic: The topic of PointCloud2 messages.
        buffer: The transforms, as `frames` returns them.
        target_frame: Frame to express the points in.
        fixed_frame: A frame that did not move during a sweep: odom or map; None: the points have one time.
        time_field: Field of a point with its time; None: t, time, timestamp, time_stamp or offset_time.
        seconds_per_unit: Unit of that field; None: nanoseconds for integers, seconds for others. Times of 1e6 s or more
            count since the epoch, others since the cloud's stamp.
        start_ns: The least log time [ns since epoch]; None: no bound.
        end_ns: The greatest one [ns since epoch]; None: no bound.
        skip_unknown: Whether to leave out clouds at whose time a transform isn't known, rather than to raise.

    Yields:
        PointCloud2 messages, with the target's frame, and with all fields and the stamp as recorded.

    Raises:
        BagError: the recording can't be read, the topic has another type, or its points have no field with a time.
        TransformException: as `Buffer.lookup`, unless `skip_unknown`.
    """
    with nullcontext(bag) if isinstance(bag, Bag) else open_bag(bag) as opened:
        type_name = opened.topic(topic).type
        if type_name.replace("/msg", "") != TYPE.replace("/msg", ""):
            raise BagError(opened.path, f"the topic {topic} has the type {type_name}, not {TYPE}")
        for _, cloud in opened.read(topic, start_ns, end_ns):
            stamps = (
                None if fixed_frame is None else _stamps(opened, topic, cloud, time_field, seconds_per_unit)
            )
            moved = _moved_if_known(buffer, cloud, target_frame, fixed_frame, stamps, skip_unknown)
            if moved is not None:
                yield moved


def _moved_if_known(
    buffer: Buffer,
    cloud: Any,
    target_frame: str,
    fixed_frame: str | None,
    stamps: NDArray[np.int64] | None,
    skip_unknown: bool,
) -> Any:
    """Return a cloud in the target's frame; None if a transform isn't known and `skip_unknown`."""
    from tfloom.tf2.errors import TransformException

    try:
        if fixed_frame is None or stamps is None:
            return _moved_cloud(buffer, cloud, target_frame)
        return _deskewed_cloud(buffer, cloud, stamps, target_frame, fixed_frame)
    except TransformException:
        if not skip_unknown:
            raise
        return None


def _moved_cloud(buffer: Buffer, cloud: Any, target_frame: str) -> Any:
    from tfloom.interfaces.geometry_msgs.msg import Transform
    from tfloom.tf2_ros.point_clouds.point_cloud import do_transform_cloud

    target_from_cloud = buffer.lookup(target_frame, cloud.header.frame_id, _stamp(cloud))
    transform = Transform()
    (transform.translation.x, transform.translation.y, transform.translation.z) = (
        target_from_cloud.translation
    )
    rotation = transform.rotation
    (rotation.x, rotation.y, rotation.z, rotation.w) = target_from_cloud.rotation_xyzw
    moved = do_transform_cloud(cloud, transform)
    moved.header.frame_id = target_frame
    return moved


def _deskewed_cloud(
    buffer: Buffer, cloud: Any, stamps: NDArray[np.int64], target_frame: str, fixed_frame: str
) -> Any:
    from tfloom.tf2_ros.point_clouds.point_cloud import deskew_cloud

    return deskew_cloud(buffer, cloud, stamps, target_frame, fixed_frame, _stamp(cloud))


def _stamp(cloud: Any) -> int:
    return int(cloud.header.stamp.sec) * 1_000_000_000 + int(cloud.header.stamp.nanosec)


def _stamps(
    bag: Bag, topic: str, cloud: Any, time_field: str | None, seconds_per_unit: float | None
) -> NDArray[np.int64]:
    try:
        return point_stamps(cloud, time_field, seconds_per_unit)
    except (ValueError, AssertionError) as error:
        raise BagError(bag.path, f"a cloud on {topic} can't be deskewed: {error}") from None


def point_stamps(
    cloud: Any, time_field: str | None = None, seconds_per_unit: float | None = None
) -> NDArray[np.int64]:
    """Return the time of each point of a cloud (N,), row by row [ns since epoch].

    Args:
        cloud: A PointCloud2.
        time_field: As for `clouds`.
        seconds_per_unit: As for `clouds`.

    Raises:
        ValueError: the points have no such field, or a time isn't finite.
    """
    import numpy as np

    from tfloom.tf2_ros.point_clouds.point_cloud2 import points_view

    points = points_view(cloud)
    names = points.dtype.names or ()
    field = time_field or next((name for name in TIME_FIELDS if name in names), None)
    if field is None or field not in names:
        missing = f"{field!r}" if field else f"one of {', '.join(TIME_FIELDS)}"
        raise ValueError(f"the points have no field {missing}; they have: {', '.join(names)}")
    # A field of time has seconds as floats or nanoseconds as integers, unless `seconds_per_unit` says otherwise, since
    # epoch or since the cloud's stamp. Nanoseconds since epoch need all bits of an integer, so without a unit they
    # never become floats.
    times = points[field].reshape(-1)
    if times.dtype.kind in "iu" and seconds_per_unit is None:
        offsets = times.astype(np.int64)
        return offsets if _is_since_epoch(offsets / 1e9) else offsets + _stamp(cloud)
    seconds = times.astype(np.float64) * (1.0 if seconds_per_unit is None else seconds_per_unit)
    if not np.isfinite(seconds).all() or (len(seconds) and np.abs(seconds).max() > 9e9):
        raise ValueError(f"the field {field} has times that are none")
    in_ns = np.rint(seconds * 1e9).astype(np.int64)
    return in_ns if _is_since_epoch(seconds) else in_ns + _stamp(cloud)


def _is_since_epoch(seconds: NDArray[np.float64]) -> bool:
    return len(seconds) > 0 and bool(seconds.max() >= EPOCH_S)
