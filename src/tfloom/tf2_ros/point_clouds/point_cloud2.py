"""Conversion of PointCloud2 to numpy arrays and back, with sensor_msgs_py.point_cloud2's interface."""

from __future__ import annotations

import array
import sys
from collections import namedtuple
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tfloom.interfaces.sensor_msgs.msg import PointCloud2, PointField
from tfloom.interfaces.std_msgs.msg import Header

__all__ = [
    "DUMMY_FIELD_PREFIX",
    "create_cloud",
    "create_cloud_xyz32",
    "dtype_from_fields",
    "points_view",
    "read_points",
    "read_points_list",
    "read_points_numpy",
]

DUMMY_FIELD_PREFIX = "unnamed_field"
"""Prefix of the names that `dtype_from_fields` gives to fields without a name."""

MAX_NUMBERS = 100_000
"""Number of numbers that a point may have. Each is a column of an array, and a field may claim billions of them."""
MAX_POINT_STEP = 2**31 - 1
"""The largest size of a point that numpy's types have [bytes]."""

_DATATYPES = {
    PointField.INT8: "i1",
    PointField.UINT8: "u1",
    PointField.INT16: "i2",
    PointField.UINT16: "u2",
    PointField.INT32: "i4",
    PointField.UINT32: "u4",
    PointField.FLOAT32: "f4",
    PointField.FLOAT64: "f8",
    PointField.INT64: "i8",
    PointField.UINT64: "u8",
    PointField.BOOL: "?",
}


def dtype_from_fields(
    fields: Iterable[PointField],
    point_step: int | None = None,
    *,
    is_bigendian: bool = sys.byteorder == "big",
) -> np.dtype[Any]:
    """Return the structured dtype of a point.

    Args:
        fields: Fields of a point. One without a name becomes `unnamed_field_<i>`; a count above 1 gives `<name>_<k>`.
        point_step: Bytes from point to point; None: the sum of the fields' sizes.
        is_bigendian: The byte order of the numbers.

    Raises:
        AssertionError: two fields have one name, or one has no elements.
        ValueError: a field's datatype isn't one of PointField's, a field needs more than `point_step`, or a point has
            more than `MAX_NUMBERS` numbers.
    """
    end = MAX_POINT_STEP if point_step is None else point_step
    if end > MAX_POINT_STEP:
        raise ValueError(f"the point_step of {point_step} is more than {MAX_POINT_STEP}")
    columns: dict[str, tuple[np.dtype[Any], int]] = {}
    """The type and the offset of each number, by its name."""
    for index, field in enumerate(fields):
        if field.datatype not in _DATATYPES:
            raise ValueError(f"field {field.name!r} has the unknown datatype {field.datatype}")
        if field.count <= 0:
            raise AssertionError("Can't handle fields with count = 0.")
        base = field.name or f"{DUMMY_FIELD_PREFIX}_{index}"
        kind = np.dtype((">" if is_bigendian else "<") + _DATATYPES[field.datatype])
        needed = field.offset + field.count * kind.itemsize
        if needed > end:
            limit = "a point can have" if point_step is None else "the point_step"
            raise ValueError(
                f"field {field.name!r} with the offset {field.offset} and the count {field.count} takes {needed} bytes "
                f"of a point, more than {limit}: {end}"
            )
        if len(columns) + field.count > MAX_NUMBERS:
            raise ValueError(
                f"field {field.name!r} with the count {field.count} gives each point more than {MAX_NUMBERS} numbers"
            )
        for element in range(field.count):
            name = base if field.count == 1 else f"{base}_{element}"
            if name in columns:
                raise AssertionError("Duplicate field names are not allowed!")
            columns[name] = kind, field.offset + element * kind.itemsize
    kinds, offsets = zip(*columns.values(), strict=True) if columns else ((), ())
    layout: Any = {"names": list(columns), "formats": kinds, "offsets": offsets}
    if point_step is not None:
        layout["itemsize"] = point_step
    dtype: np.dtype[Any] = np.dtype(layout)
    return dtype


def points_view(cloud: PointCloud2, data: Any = None) -> NDArray[Any]:
    """Return the points (height, width) as a structured view of the cloud's bytes, or of `data` of the same layout.

    Raises:
        AssertionError: two fields have one name, or one has no elements.
        ValueError: there are fewer bytes than the cloud's sizes require, or they are none, as `dtype_from_fields` says.
    """
    dtype = dtype_from_fields(cloud.fields, cloud.point_step, is_bigendian=bool(cloud.is_bigendian))
    cloud_bytes = memoryview(cloud.data if data is None else data).cast("B")
    if cloud.height and cloud.width and not cloud.point_step:
        raise ValueError(f"the cloud has {cloud.width} x {cloud.height} points, and a point_step of 0")
    row_step = max(cloud.row_step, cloud.width * cloud.point_step) if cloud.height > 1 else 0
    needed = max(0, cloud.height - 1) * row_step + cloud.width * cloud.point_step
    if cloud.height and cloud.width and len(cloud_bytes) < needed:
        raise ValueError(f"the cloud's data has {len(cloud_bytes)} bytes, its sizes require {needed}")
    shape, strides = (cloud.height, cloud.width), (row_step, cloud.point_step)
    view: NDArray[Any] = np.ndarray(shape, dtype, buffer=cloud_bytes, strides=strides)
    return view


def read_points(
    cloud: PointCloud2,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> NDArray[Any]:
    """Return the points as a structured array (N,), a copy in this machine's byte order.

    Args:
        cloud: The cloud; it is not changed.
        field_names: Names of the fields; None: all.
        skip_nans: Whether to omit points with a NaN in one of these.
        uvs: Indices of the points to return; None: all.
        reshape_organized_cloud: Whether the result for an organised cloud has the shape (height, width).

    Raises:
        AssertionError: the cloud has no such field.
        ValueError: there are fewer bytes than the cloud's sizes require.
    """
    points = points_view(cloud)
    if field_names is not None:
        wanted = list(field_names)
        if not set(wanted) <= set(points.dtype.names or ()):
            raise AssertionError("Requests field is not in the fields of the PointCloud!")
        points = points[wanted]
    points = points.astype(points.dtype.newbyteorder("="), copy=True)
    organised = points
    points = points.reshape(-1)
    if skip_nans:
        is_nan = np.zeros(len(points), bool)
        for name in points.dtype.names or ():
            is_nan |= np.isnan(points[name])
        points = points[~is_nan]
    if uvs is not None:
        points = points[uvs if isinstance(uvs, np.ndarray) else np.fromiter(uvs, int)]
    if reshape_organized_cloud and cloud.height > 1 and points.size == organised.size:
        return points.reshape(organised.shape)
    return points


def read_points_numpy(
    cloud: PointCloud2,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> NDArray[Any]:
    """Return the points as a plain array (N, fields), for fields of one type; see `read_points`.

    Raises:
        AssertionError: the fields have different types.
    """
    names = [field.name for field in cloud.fields if field_names is None or field.name in field_names]
    kinds = {field.datatype for field in cloud.fields if field.name in names}
    if len(kinds) > 1:
        raise AssertionError("All fields need to have the same datatype. Use `read_points()` otherwise.")
    points = read_points(cloud, field_names, skip_nans, uvs, reshape_organized_cloud)
    return np.stack([points[name] for name in points.dtype.names or ()], axis=-1)


def read_points_list(
    cloud: PointCloud2,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
) -> list[Any]:
    """Return the points as named tuples; see `read_points`."""
    points = read_points(cloud, field_names, skip_nans, uvs)
    point = namedtuple("Point", points.dtype.names or ())  # type: ignore[misc]  # noqa: PYI024, names are data
    return [point._make(values) for values in points.tolist()]


def create_cloud(
    header: Header, fields: Iterable[PointField], points: Any, point_step: int | None = None
) -> PointCloud2:
    """Return a new cloud.

    Args:
        header: Its header.
        fields: Fields of a point.
        points: A structured array of the fields' dtype, a plain array (N, fields), or an iterable of points. A
            structured array (height, width), or a plain one (height, width, fields), makes an organised cloud.
        point_step: Bytes from point to point; None: those of a structured array, else the sum of the fields' sizes.

    Raises:
        AssertionError: the array doesn't fit the fields.
        ValueError: a point has more or fewer numbers than the fields, or one that its field can't hold.
    """
    listed = list(fields)
    if point_step is None and isinstance(points, np.ndarray) and points.dtype.names is not None:
        # Points that are too small for the fields don't match them, which the check below says.
        point_step = max(points.dtype.itemsize, dtype_from_fields(listed).itemsize)
    dtype = dtype_from_fields(listed, point_step)
    if not isinstance(points, np.ndarray):
        with _refusing("points"):
            table = np.array([tuple(point) for point in points], dtype)
    elif points.dtype.names is None:
        if any(field.datatype != listed[0].datatype for field in listed):
            raise AssertionError(
                "All fields need to have the same datatype. Pass a structured NumPy array with multiple dtypes "
                "otherwise."
            )
        table = _structured(points, dtype)
    else:
        if points.dtype != dtype:
            raise AssertionError(
                "PointFields and structured NumPy array dtype do not match for all fields! Check their field order, "
                "names and types."
            )
        table = points
    if table.ndim > 2:
        raise AssertionError(
            "Too many dimensions for organized cloud! Points can only be organized in max. two dimensional space"
        )
    height, width = table.shape if table.ndim == 2 else (1, table.shape[0])
    return PointCloud2(
        header=header,
        height=height,
        width=width,
        is_dense=False,
        is_bigendian=sys.byteorder != "little",
        fields=listed,
        point_step=dtype.itemsize,
        row_step=dtype.itemsize * width,
        data=array.array("B", np.ascontiguousarray(table).tobytes()),
    )


@contextmanager
def _refusing(what: str) -> Iterator[None]:
    """Refuse numbers that are infinite, or not there, only in the field's type, as 1e50 in float32."""
    try:
        with np.errstate(over="raise", invalid="raise"):
            yield
    except FloatingPointError as error:
        raise ValueError(f"{what}: a number is beyond its field's type: {error}") from None


def _structured(points: NDArray[Any], dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return the points of a plain array (…, fields) as a structured one."""
    names = dtype.names or ()
    if points.shape == (0,):  # np.array([])
        return np.zeros(0, dtype)
    if points.ndim < 2 or points.shape[-1] != len(names):
        raise ValueError(
            f"points of the shape {points.shape} don't fit the {len(names)} numbers of a point: {', '.join(names)}. "
            f"Pass an array (N, {len(names)}), as points[:, :{len(names)}], or a field for each column"
        )
    table = np.zeros(points.shape[:-1], dtype)
    for column, name in enumerate(names):
        numbers = points[..., column]
        with _refusing(name):
            table[name] = numbers
        if dtype[name].kind in "biu" and (np.trunc(numbers) != table[name]).any():
            raise ValueError(f"{name}: a number is beyond its field's type, {dtype[name].name}")
    return table


def create_cloud_xyz32(header: Header, points: Any) -> PointCloud2:
    """Return a cloud of float32 x, y and z from an array (N, 3) or an iterable of points.

    Raises:
        ValueError: a point has more or fewer numbers, or one beyond float32.
    """
    fields = [
        PointField(name=name, offset=4 * index, datatype=PointField.FLOAT32, count=1)
        for index, name in enumerate("xyz")
    ]
    return create_cloud(header, fields, points)
