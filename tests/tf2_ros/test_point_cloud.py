"""Conversion of clouds to numpy and back, and their transforms: padded, organised, of either byte order."""

from __future__ import annotations

import array
import math
import sys
from copy import deepcopy
from typing import Any

import numpy as np
import pytest
from tests.tf2_ros.conftest import SECOND, field, transform_stamped

from tfloom import _native
from tfloom.interfaces.sensor_msgs.msg import PointCloud2, PointField
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.point_clouds import point_cloud
from tfloom.tf2_ros.point_clouds.point_cloud2 import (
    create_cloud,
    create_cloud_xyz32,
    dtype_from_fields,
    points_view,
    read_points,
    read_points_list,
    read_points_numpy,
)

HEADER = Header(frame_id="A", stamp=Time(seconds=2).to_msg())
TRANSFORM = transform_stamped("B", "A", 2 * SECOND, (10.0, 20.0, 30.0), (1.0, 0.0, 0.0, 0.0))
FIELDS = [field("x"), field("y", 4), field("z", 8), field("ring", 14, PointField.UINT16)]


def structured(shape: tuple[int, ...], point_step: int = 32) -> np.ndarray:
    points = np.zeros(shape, dtype_from_fields(FIELDS, point_step))
    count = points.size
    for index, axis in enumerate("xyz"):
        points[axis] = (np.arange(count, dtype=np.float32) + 0.25 * index).reshape(shape)
    points["ring"] = np.arange(count).reshape(shape)
    return points


@pytest.mark.parametrize("shape", [(6,), (2, 3)])
@pytest.mark.parametrize("point_step", [16, 32])
def test_transform_changes_the_points_of_a_cloud_only(shape: tuple[int, ...], point_step: int) -> None:
    points = structured(shape, point_step)
    cloud = create_cloud(HEADER, FIELDS, points, point_step)
    cloud.is_dense = True
    before = deepcopy(cloud)
    moved = point_cloud.do_transform_cloud(cloud, TRANSFORM)
    assert cloud == before
    assert (
        (moved.height, moved.width) == (cloud.height, cloud.width) == ((1, 6) if len(shape) == 1 else shape)
    )
    assert (moved.point_step, moved.row_step, moved.is_dense) == (point_step, cloud.row_step, True)
    assert (moved.header.frame_id, moved.header.stamp.sec) == ("B", 2)
    out = read_points(moved)
    flat = points.reshape(-1)
    assert np.allclose(out["x"], flat["x"] + 10)
    assert np.allclose(out["y"], 20 - flat["y"])
    assert np.allclose(out["z"], 30 - flat["z"])
    assert (out["ring"] == flat["ring"]).all()


def test_unstamped_transform_keeps_the_frame() -> None:
    cloud = create_cloud_xyz32(HEADER, [(1, 2, 3)])
    moved = point_cloud.do_transform_cloud(cloud, TRANSFORM.transform)
    assert moved.header.frame_id == "A"
    assert read_points_numpy(moved).tolist() == [[11, 18, 27]]


def test_buffer_transforms_clouds() -> None:
    buffer = Buffer()
    buffer.set_transform(transform_stamped("B", "A", 2 * SECOND, (1.0, 0.0, 0.0)), "me")
    moved = buffer.transform(create_cloud_xyz32(HEADER, [(1, 2, 3)]), "B")
    assert read_points_numpy(moved).tolist() == [[2, 2, 3]]


def test_big_endian_cloud() -> None:
    dtype = dtype_from_fields(FIELDS, 16, is_bigendian=sys.byteorder == "little")
    points = structured((3,), 16).astype(dtype)
    cloud = PointCloud2(
        header=HEADER, height=1, width=3, fields=FIELDS, point_step=16, row_step=48,
        is_bigendian=sys.byteorder == "little", data=array.array("B", points.tobytes()),
    )  # fmt: skip
    before = bytes(cloud.data)
    assert read_points(cloud)["y"].tolist() == [0.25, 1.25, 2.25]
    moved = point_cloud.do_transform_cloud(cloud, TRANSFORM)
    assert read_points(moved)["y"].tolist() == [19.75, 18.75, 17.75]
    assert bytes(cloud.data) == before


def test_padded_rows() -> None:
    rows = np.zeros((2, 64), np.uint8)
    points = structured((2, 3), 16)
    rows[:, :48] = points.view(np.uint8).reshape(2, 48)
    cloud = PointCloud2(
        header=HEADER, height=2, width=3, fields=FIELDS, point_step=16, row_step=64,
        is_bigendian=False, data=array.array("B", rows.tobytes()),
    )  # fmt: skip
    assert (read_points(cloud)["ring"] == np.arange(6)).all()
    moved = point_cloud.do_transform_cloud(cloud, TRANSFORM)
    assert len(moved.data) == 128
    assert np.allclose(read_points(moved)["x"], np.arange(6) + 10)


LAYOUTS = {
    "packed": ("xyz", "f4", (0, 4, 8), 12),
    "packed, float64": ("xyz", "f8", (0, 8, 16), 24),
    "padded": ("xyz", "f4", (0, 4, 8), 32),
    "padded, float64": ("xyz", "f8", (8, 16, 24), 40),
    "unaligned": ("xyz", "f4", (1, 5, 9), 15),
    "apart": ("xyz", "f4", (12, 0, 5), 17),
    "another byte order": ("xyz", "swapped", (0, 4, 8), 16),
    "integers": ("xyz", "i4", (0, 4, 8), 12),
}


@pytest.mark.parametrize("size", [(1, 0), (0, 3), (1, 1), (1, 7), (3, 5), (2, 300)])
@pytest.mark.parametrize("row_padding", [0, 3])
@pytest.mark.parametrize("layout", LAYOUTS)
def test_layouts_of_clouds(layout: str, row_padding: int, size: tuple[int, int]) -> None:
    names, kind, offsets, point_step = LAYOUTS[layout]
    is_bigendian = (sys.byteorder == "big") != (kind == "swapped")
    kind = "f4" if kind == "swapped" else kind
    datatype = {"f4": PointField.FLOAT32, "f8": PointField.FLOAT64, "i4": PointField.INT32}[kind]
    fields = [field(name, offset, datatype) for name, offset in zip(names, offsets, strict=True)]
    height, width = size
    row_step = width * point_step + row_padding
    random = np.random.default_rng(5)
    data = random.integers(0, 256, height * row_step, np.uint8)
    cloud = PointCloud2(
        header=HEADER, height=height, width=width, fields=fields, point_step=point_step, row_step=row_step,
        is_bigendian=is_bigendian, data=array.array("B", data.tobytes()),
    )  # fmt: skip
    xyz = (random.normal(size=(height, width, 3)) * 100).astype(kind)
    points = points_view(cloud)
    for axis in range(3):
        points["xyz"[axis]] = xyz[..., axis]
    before = bytes(cloud.data)
    transform = transform_stamped("B", "A", 2 * SECOND, (10.0, 20.0, 30.0), (0.1, -0.7, 0.5, 0.5))
    moved = point_cloud.do_transform_cloud(cloud, transform)
    assert bytes(cloud.data) == before

    expected = point_cloud.transform_points(xyz.reshape(-1, 3), transform).reshape(xyz.shape)
    found = points_view(moved)
    for axis in range(3):
        difference = np.abs(found["xyz"[axis]] - expected[..., axis])
        assert difference.max(initial=0) < {"f4": 1e-3, "f8": 1e-12, "i4": 1.0}[kind]
        found["xyz"[axis]] = xyz[..., axis]
    assert bytes(moved.data) == before  # nothing but the coordinates has changed


@pytest.mark.parametrize(
    ("shape", "steps", "offsets"),
    [
        ((1, 3), (0, 12), (0, 4, 9)),
        ((1, 4), (0, 12), (0, 4, 8)),
        ((2, 2), (13, 12), (0, 4, 8)),
        ((1, 2**63), (0, 2), (0, 4, 8)),
        ((2**40, 1), (2**40, 12), (0, 4, 8)),
        ((1, 1), (0, 12), (0, 4, 2**64 - 1)),
    ],
)
def test_points_outside_the_bytes_raise(
    shape: tuple[int, int], steps: tuple[int, int], offsets: tuple[int, int, int]
) -> None:
    cloud_bytes = np.zeros(36, np.uint8)
    with pytest.raises(ValueError, match="the points must lie within the bytes"):
        _native.move_cloud_float32(np.array([0.0, 0, 0, 0, 0, 0, 1]), cloud_bytes, shape, steps, offsets)
    _native.move_cloud_float32(np.array([1.0, 2, 3, 0, 0, 0, 1]), cloud_bytes, (1, 3), (0, 12), (0, 4, 8))
    assert cloud_bytes.view(np.float32).tolist() == [1, 2, 3] * 3


def test_points_are_read_as_arrays() -> None:
    points = structured((2, 3))
    points["x"][1, 1] = np.nan
    cloud = create_cloud(HEADER, FIELDS, points, 32)
    assert read_points(cloud, ["x", "ring"]).dtype.names == ("x", "ring")
    assert read_points(cloud, skip_nans=True)["ring"].tolist() == [0, 1, 2, 3, 5]
    assert read_points(cloud, uvs=[5, 0])["ring"].tolist() == [5, 0]
    assert (read_points(cloud, reshape_organized_cloud=True)["ring"] == points["ring"]).all()
    assert read_points_numpy(cloud, ["y", "z"], reshape_organized_cloud=True).shape == (2, 3, 2)
    first = read_points_list(cloud, ["ring", "y"])[0]
    assert first._fields == ("ring", "y") or first._fields == ("y", "ring")
    assert first.y == 0.0 + 0.25


def test_fields_with_counts_and_without_names() -> None:
    fields = [field("x", count=3)]
    cloud = create_cloud(HEADER, fields, np.arange(12, dtype=np.float32).reshape(4, 3))
    assert (cloud.point_step, cloud.width) == (12, 4)
    assert read_points(cloud).dtype.names == ("x_0", "x_1", "x_2")
    assert (read_points_numpy(cloud) == np.arange(12).reshape(4, 3)).all()
    fields[0].name, fields[0].count = "", 1
    assert dtype_from_fields(fields).names == ("unnamed_field_0",)
    with pytest.raises(ValueError, match="unknown datatype 99"):
        dtype_from_fields([field("x", datatype=99)])
    with pytest.raises(AssertionError, match="count = 0"):
        dtype_from_fields([field("x", count=0)])


@pytest.mark.parametrize("datatype", range(1, 9))
def test_every_datatype(datatype: int) -> None:
    fields = [field("v", datatype=datatype)]
    cloud = create_cloud(HEADER, fields, [(1,), (2,), (100,)])
    assert [point.v for point in read_points_list(cloud)] == [1, 2, 100]
    kind = ["i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8"][datatype - 1]
    assert dtype_from_fields(fields)["v"] == np.dtype(kind)


def test_padding_of_a_structured_array_is_kept() -> None:
    points = structured((4,), 32)
    cloud = create_cloud(HEADER, FIELDS, points)
    assert (cloud.point_step, cloud.row_step, len(cloud.data)) == (32, 128, 128)
    with pytest.raises(AssertionError, match="dtype do not match"):
        create_cloud(HEADER, FIELDS, points, 16)


def test_data_of_other_buffer_types() -> None:
    cloud = create_cloud_xyz32(HEADER, [(1, 2, 3), (4, np.nan, 6)])
    cloud_bytes = bytes(cloud.data)
    for data in (bytearray(cloud_bytes), list(cloud_bytes), np.frombuffer(cloud_bytes, np.uint8)):
        cloud.data = data
        assert read_points(cloud, skip_nans=True).tolist() == [(1, 2, 3)]
    assert read_points(create_cloud_xyz32(HEADER, [])).shape == (0,)


def test_a_deskewed_cloud_equals_deskewed_points() -> None:
    buffer = Buffer()
    for step in range(3):
        turned = transform_stamped(
            "odom", "A", (1 + step) * SECOND, (float(step), 0.0, 0.0), (0.0, 0.0, 0.1 * step, 1.0)
        )
        buffer.set_transform(turned, "me")
    points = structured((2, 3))
    stamps = SECOND + np.arange(6) * SECOND // 3
    cloud = create_cloud(HEADER, FIELDS, points, 32)
    moved = point_cloud.deskew_cloud(buffer, cloud, stamps, "A", "odom", 3 * SECOND)
    expected = buffer.deskew(read_points_numpy(cloud, ["x", "y", "z"]), stamps, "A", "A", "odom", 3 * SECOND)
    assert (read_points_numpy(moved, ["x", "y", "z"]) == expected).all()
    assert (moved.height, moved.header.stamp.sec) == (2, 3)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: read_points(create_cloud_xyz32(HEADER, []), ["w"]), "Requests field is not in the fields"),
        (lambda: create_cloud(HEADER, FIELDS, np.zeros((2, 4))), "All fields need to have the same datatype"),
        (lambda: create_cloud(HEADER, FIELDS[:3], structured((2,))), "dtype do not match"),
        (
            lambda: create_cloud(HEADER, FIELDS, structured((2,))[["x", "y"]].astype("f4,f4")),
            "dtype do not match",
        ),
        (lambda: create_cloud(HEADER, FIELDS[:3], np.zeros((2, 2, 2, 3))), "Too many dimensions"),
        (lambda: dtype_from_fields([FIELDS[0], FIELDS[0]]), "Duplicate field names"),
        (lambda: read_points_numpy(create_cloud(HEADER, FIELDS, structured((2,)), 32)), "same datatype"),
        (
            lambda: point_cloud.do_transform_cloud(
                create_cloud(HEADER, FIELDS[:2], np.zeros((1, 2))), TRANSFORM
            ),
            "Point cloud needs the fields x, y, and z for the transformation",
        ),
    ],
)
def test_unfitting_points_raise(make: object, text: str) -> None:
    with pytest.raises(AssertionError, match=text):
        make()


@pytest.mark.parametrize(
    "points",
    [
        *(np.ones((2, columns)) for columns in (4, 2, 1, 0)),
        *(np.ones(shape) for shape in [(3,), (3, 1), (2, 2, 4), ()]),
        [(1.0, 2.0, 3.0, 4.0)],
        [(1.0, 2.0)],
        [(1.0, 2.0, 3.0), (1.0, 2.0)],
    ],
    ids=lambda points: str(getattr(points, "shape", points)),
)
def test_points_of_another_number_of_columns_are_refused(points: Any) -> None:
    with pytest.raises(
        ValueError, match=r"x, y, z\. Pass an array \(N, 3\)|could not assign tuple of length"
    ):
        create_cloud_xyz32(HEADER, points)


def test_clouds_of_fitting_and_of_no_points_read_back() -> None:
    for shape in [(2, 3), (4, 2, 3), (0, 3)]:
        points = np.arange(math.prod(shape), dtype=float).reshape(shape)
        cloud = create_cloud_xyz32(HEADER, points)
        np.testing.assert_array_equal(read_points_numpy(cloud), points.reshape(-1, 3))
    assert [create_cloud_xyz32(HEADER, empty).width for empty in ([], np.array([]))] == [0, 0]


@pytest.mark.parametrize(
    ("datatype", "number", "is_held"),
    [
        (PointField.FLOAT32, 1e50, False),
        (PointField.FLOAT32, math.inf, True),
        (PointField.FLOAT32, math.nan, True),
        (PointField.FLOAT64, 1e50, True),
        (PointField.UINT8, 255.0, True),
        (PointField.UINT8, 300.0, False),
        (PointField.UINT8, -1.0, False),
        (PointField.INT16, math.nan, False),
        (PointField.UINT32, 12.75, True),
        (PointField.INT64, -(2.0**62), True),
        (PointField.UINT64, -1.0, False),
    ],
)
@pytest.mark.filterwarnings("error")
def test_a_number_beyond_its_fields_type_is_refused(datatype: int, number: float, is_held: bool) -> None:
    fields = [
        PointField(name=name, offset=8 * index, datatype=datatype, count=1) for index, name in enumerate("ab")
    ]
    points = np.array([[1.0, 2.0], [3.0, number]])
    if is_held:
        (_, (_, read)) = read_points(create_cloud(HEADER, fields, points))
        np.testing.assert_equal(float(read), number if datatype != PointField.UINT32 else 12)
        return
    with pytest.raises(ValueError, match="b: a number is beyond its field's type"):
        create_cloud(HEADER, fields, points)
    if datatype == PointField.FLOAT32:
        with pytest.raises(ValueError, match="points: a number is beyond its field's type"):
            create_cloud(HEADER, fields, points.tolist())


def test_a_field_of_bools_holds_bools_alone() -> None:
    fields = [field("valid", 0, PointField.BOOL)]
    cloud = create_cloud(HEADER, fields, np.array([[0.0], [1.0]]))
    assert (cloud.point_step, bytes(cloud.data)) == (1, b"\0\1")
    assert read_points_list(cloud) == [(False,), (True,)]
    for number in (2.0, 0.5, math.nan):
        with pytest.raises(ValueError, match="valid: a number is beyond its field's type, bool"):
            create_cloud(HEADER, fields, np.array([[number]]))


def test_cloud_with_too_few_bytes_raises() -> None:
    cloud = create_cloud_xyz32(HEADER, [(1, 2, 3), (4, 5, 6)])
    cloud.width = 3
    with pytest.raises(ValueError, match="has 24 bytes, its sizes require 36"):
        read_points(cloud)
    cloud.point_step = 4
    with pytest.raises(
        ValueError,
        match=r"field 'y' with the offset 4 .* takes 8 bytes .* more than the point_step: 4",
    ):
        read_points(cloud)


def test_points_as_an_array() -> None:
    moved = point_cloud.transform_points(np.array([[1, 2, 3]], np.float32), TRANSFORM.transform)
    assert (moved.dtype, moved.tolist()) == (np.float64, [[11, 18, 27]])
