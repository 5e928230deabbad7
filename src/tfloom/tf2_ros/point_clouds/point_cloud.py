"""Transforms PointCloud2. Importing this registers it for `Buffer.transform`."""

from __future__ import annotations

import array
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tfloom import _native
from tfloom.interfaces.sensor_msgs.msg import PointCloud2
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_ros.buffer_interface import ConvertRegistration, TransformRegistration
from tfloom.tf2_ros.geometry import from_msg_msg, to_msg_msg, value_of
from tfloom.tf2_ros.point_clouds.point_cloud2 import points_view

__all__ = ["deskew_cloud", "do_transform_cloud", "from_msg_msg", "to_msg_msg", "transform_points"]

_CLOUD_ATTRIBUTES = ("height", "width", "is_bigendian", "point_step", "row_step", "is_dense")
_FIELD_ATTRIBUTES = ("name", "offset", "datatype", "count")
_MOVE_CLOUD = {
    np.dtype(np.float32): _native.move_cloud_float32,
    np.dtype(np.float64): _native.move_cloud_float64,
}


def transform_points(point_cloud: ArrayLike, transform: Any) -> NDArray[np.float64]:
    """Transform points (N, 3) by a Transform message; the result is float64."""
    points = np.ascontiguousarray(point_cloud, np.float64)
    moved = np.empty_like(points)
    _native.move_points_float64(_row(transform), points, moved)
    return moved


def do_transform_cloud(cloud: Any, transform: Any) -> Any:
    """Transform a cloud by a Transform or TransformStamped message.

    The argument is not changed. The result has the same size, padding, other fields and `is_dense`, and the same stamp;
    its frame is that of a TransformStamped.

    Raises:
        AssertionError: the cloud has no fields x, y and z.
    """
    result, points = _copied(cloud)
    _move(points, result.data, _row(transform))
    if hasattr(transform, "header"):
        result.header.frame_id = transform.header.frame_id
    return result


def deskew_cloud(
    buffer: Buffer,
    cloud: Any,
    stamps_ns: ArrayLike,
    target_frame: str,
    fixed_frame: str,
    target_stamp_ns: int = 0,
) -> Any:
    """Return a cloud whose points were measured one after the other, as if at one time; see `Buffer.deskew`.

    `stamps_ns` has a stamp for each point, row by row. The header has the target's frame, and its stamp unless that
    is the latest.

    Raises:
        AssertionError: the cloud has no fields x, y and z.
        TransformException: as `lookup`.
    """
    result, points = _copied(cloud)
    xyz = _gather(points)
    source_frame = cloud.header.frame_id
    buffer.deskew(xyz, stamps_ns, target_frame, source_frame, fixed_frame, target_stamp_ns, out=xyz)
    _scatter(points, xyz)
    result.header.frame_id = target_frame
    if target_stamp_ns:
        result.header.stamp.sec, result.header.stamp.nanosec = divmod(target_stamp_ns, 1_000_000_000)
    return result


def _copied(cloud: Any) -> tuple[Any, NDArray[Any]]:
    """Return a copy of a cloud and a view of the copy's points."""
    names = [field.name for field in cloud.fields]
    if not {"x", "y", "z"} <= set(names):
        raise AssertionError("Point cloud needs the fields x, y, and z for the transformation")
    result = _with_attributes_of(cloud, _CLOUD_ATTRIBUTES)
    result.header = _copied_header(cloud.header)
    result.fields = [_with_attributes_of(field, _FIELD_ATTRIBUTES) for field in cloud.fields]
    data = cloud.data
    is_byte_array = isinstance(data, array.array) and data.typecode == "B"
    result.data = array.array("B", data if is_byte_array else bytes(data))
    return result, points_view(result, result.data)


def _copied_header(header: Any) -> Any:
    result = type(header)()
    result.stamp = _with_attributes_of(header.stamp, ("sec", "nanosec"))
    result.frame_id = header.frame_id
    return result


def _with_attributes_of(message: Any, names: tuple[str, ...]) -> Any:
    """Return a new message of the same class. It takes a sixth of the time of `copy.copy`."""
    result = type(message)()
    for name in names:
        setattr(result, name, getattr(message, name))
    return result


def _move(points: NDArray[Any], cloud_bytes: Any, row: NDArray[np.float64]) -> None:
    """Transform the points of a cloud, a view of `cloud_bytes`, in place."""
    fields: Any = points.dtype.fields
    types = {fields[axis][0] for axis in "xyz"}
    for dtype, move_cloud in _MOVE_CLOUD.items():
        if types == {dtype}:
            move_cloud(row, cloud_bytes, points.shape, points.strides, [fields[axis][1] for axis in "xyz"])
            return
    xyz = _gather(points)  # of another byte order, or of several types
    move = _native.move_points_float32 if xyz.dtype == np.float32 else _native.move_points_float64
    move(row, xyz, xyz)
    _scatter(points, xyz)


def _gather(points: NDArray[Any]) -> NDArray[Any]:
    kind = (
        np.float32
        if all(points.dtype[axis].newbyteorder("=") == np.float32 for axis in "xyz")
        else np.float64
    )
    xyz = np.empty((points.size, 3), kind)
    for column, axis in enumerate("xyz"):
        xyz[:, column] = points[axis].reshape(-1)
    return xyz


def _scatter(points: NDArray[Any], xyz: NDArray[Any]) -> None:
    for column, axis in enumerate("xyz"):
        points[axis] = xyz[:, column].reshape(points.shape)


def _row(transform: Any) -> NDArray[np.float64]:
    value = value_of(transform)
    return np.array(value.translation + value.rotation_xyzw)


TransformRegistration().add(PointCloud2, do_transform_cloud)
ConvertRegistration().add_to_msg(PointCloud2, to_msg_msg)
ConvertRegistration().add_from_msg(PointCloud2, from_msg_msg)
