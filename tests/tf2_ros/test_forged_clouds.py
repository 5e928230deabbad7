"""Clouds whose description does not fit their bytes, in all that reads clouds: an error soon, or the points."""

from __future__ import annotations

import array
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from tests.tf2_ros.conftest import SECOND, field, transform_stamped

from tfloom.bag.moved_clouds import point_stamps
from tfloom.interfaces.sensor_msgs.msg import PointCloud2, PointField
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.point_clouds.point_cloud import deskew_cloud, do_transform_cloud
from tfloom.tf2_ros.point_clouds.point_cloud2 import (
    MAX_NUMBERS,
    dtype_from_fields,
    points_view,
    read_points,
    read_points_list,
    read_points_numpy,
)
from tfloom.viewer.displays.point_cloud import PointCloudDisplay
from tfloom.viewer.displays.settings import CLOUD_SETTINGS, usual_values
from tfloom.viewer.shapes import DisplayError

MAX_S = 10.0
"""A reader that takes longer hangs, also on a slow machine [s]."""
MOST = 2**32 - 1
TRANSFORM = transform_stamped("map", "base", SECOND, (1.0, 2.0, 3.0))


XYZT = [field("x"), field("y", 4), field("z", 8), field("t", 12)]


def cloud_of(fields: list[PointField] = XYZT, size: int = 32, **attributes: Any) -> PointCloud2:
    """Return a cloud of two points of sixteen bytes, but for some attributes."""
    usual = {"height": 1, "width": 2, "point_step": 16, "row_step": 32, "is_bigendian": False}
    return PointCloud2(fields=fields, data=array.array("B", bytes(size)), **{**usual, **attributes})


def show(cloud: PointCloud2) -> None:
    display = PointCloudDisplay(usual_values(CLOUD_SETTINGS))
    display.take(cloud, 0)
    display.shapes(0)


def deskew(cloud: PointCloud2) -> PointCloud2:
    buffer = Buffer()
    buffer.set_transform(TRANSFORM, "me")
    cloud.header.frame_id = "base"
    stamps = np.full(min(cloud.width * cloud.height, 1000), SECOND)
    moved: PointCloud2 = deskew_cloud(buffer, cloud, stamps, "map", "map", SECOND)
    return moved


READERS: dict[str, Callable[[PointCloud2], object]] = {
    "points_view": points_view,
    "read_points": read_points,
    "read_points, skip_nans": lambda cloud: read_points(cloud, skip_nans=True),
    "read_points_list": read_points_list,
    "read_points_numpy": read_points_numpy,
    "do_transform_cloud": lambda cloud: do_transform_cloud(cloud, TRANSFORM),
    "deskew_cloud": deskew,
    "point_stamps": point_stamps,
    "display": show,
}

FORGED: dict[str, tuple[Callable[[], PointCloud2], str]] = {
    "count of none": (lambda: cloud_of([*XYZT[:3], field("t", 12, count=0)]), "count = 0"),
    "count of millions": (
        lambda: cloud_of([*XYZT, field("many", 12, PointField.UINT8, 2_000_000)]),
        "field 'many' with the offset 12 and the count 2000000 takes 2000012 bytes .* point_step: 16|more than 500",
    ),
    "count of millions in four bytes": (
        lambda: cloud_of([field("x", count=2_000_000)], 4, width=1, point_step=4, row_step=4),
        "field 'x' .* the count 2000000 takes 8000000 bytes .* point_step: 4|needs the fields x|more than 500",
    ),
    "greatest count": (
        lambda: cloud_of([*XYZT, field("many", 0, PointField.FLOAT64, MOST)]),
        "field 'many' .* more than the point_step|more than 500 numbers",
    ),
    "as many numbers as an empty cloud may claim": (
        lambda: cloud_of(
            [*XYZT, field("many", 16, PointField.UINT8, 2**30)], 0, width=0, point_step=2**31 - 1
        ),
        f"field 'many' with the count {2**30} gives each point more than {MAX_NUMBERS} numbers|more than 500",
    ),
    "offset beyond the point": (
        lambda: cloud_of([*XYZT[:3], field("t", 13)]),
        "field 't' with the offset 13 and the count 1 takes 17 bytes of a point, more than the point_step: 16",
    ),
    "greatest offset": (
        lambda: cloud_of([*XYZT, field("far", MOST)]),
        f"field 'far' with the offset {MOST} and the count 1 takes {MOST + 4} bytes",
    ),
    "unknown datatype": (
        lambda: cloud_of([*XYZT, field("odd", 0, 12)]),
        "field 'odd' has the unknown datatype 12",
    ),
    "datatype of none": (
        lambda: cloud_of([*XYZT, field("odd", 0, 0)]),
        "field 'odd' has the unknown datatype 0",
    ),
    "names twice": (lambda: cloud_of([*XYZT, field("x", 4)]), "Duplicate field names"),
    "names of elements twice": (
        lambda: cloud_of([*XYZT, field("a", 0, PointField.UINT8, 2), field("a_1")]),
        "Duplicate field names",
    ),
    "data too short": (lambda: cloud_of(size=31), "the cloud's data has 31 bytes, its sizes require 32"),
    "no data": (lambda: cloud_of(size=0), "the cloud's data has 0 bytes, its sizes require 32"),
    "width too large": (lambda: cloud_of(width=MOST), "the cloud's data has 32 bytes, its sizes require "),
    "height too large": (lambda: cloud_of(height=MOST), "the cloud's data has 32 bytes, its sizes require "),
    "product that overflows": (
        lambda: cloud_of(width=2**31, height=2**31, point_step=16, row_step=0),
        "the cloud's data has 32 bytes, its sizes require ",
    ),
    "rows too long": (lambda: cloud_of(height=2, width=1, row_step=MOST), "has 32 bytes, its sizes require "),
    "points of no size": (
        lambda: cloud_of([], width=MOST, point_step=0),
        "points, and a point_step of 0|needs the fields x, y, and z",
    ),
    "points of the greatest size": (
        lambda: cloud_of(point_step=MOST),
        f"the point_step of {MOST} is more than {2**31 - 1}",
    ),
}


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("forged", FORGED)
def test_forged_cloud_is_an_error(forged: str, reader: str) -> None:
    make, text = FORGED[forged]
    cloud = make()
    if reader == "read_points_numpy":
        text += "|All fields need to have the same datatype"
    begin_s = time.monotonic()
    with pytest.raises((ValueError, AssertionError, DisplayError), match=text):
        READERS[reader](cloud)
    assert time.monotonic() - begin_s < MAX_S


ACCEPTED: dict[str, Callable[[], PointCloud2]] = {
    "usual": cloud_of,
    "overlapping fields": lambda: cloud_of(
        [*XYZT, field("same", 2), field("bytes", 0, PointField.UINT8, 16)]
    ),
    "all in one place": lambda: cloud_of([field(name) for name in "xyzt"]),
    "rows shorter than their points": lambda: cloud_of(height=2, width=1, row_step=3),
    "rows of one row that are too long": lambda: cloud_of(row_step=MOST),
    "more data than points": lambda: cloud_of(size=100),
    "big-endian": lambda: cloud_of(is_bigendian=True),
    "no points": lambda: cloud_of(width=0, size=0),
    "no rows": lambda: cloud_of(height=0, width=MOST, size=0),
    "no columns": lambda: cloud_of(height=1000, width=0, size=0),
}


@pytest.mark.parametrize("reader", sorted(READERS.keys() - {"read_points_numpy"}))
@pytest.mark.parametrize("accepted", ACCEPTED)
def test_odd_cloud_is_read(accepted: str, reader: str) -> None:
    READERS[reader](ACCEPTED[accepted]())


def test_values_of_odd_clouds() -> None:
    values = np.arange(8, dtype=">f4")
    cloud = cloud_of(is_bigendian=True)
    cloud.data = array.array("B", values.tobytes())
    assert read_points(cloud)["y"].tolist() == [1.0, 5.0]
    assert read_points(cloud)["y"].dtype.isnative
    overlapping = cloud_of(
        [field("x"), field("low", 0, PointField.UINT16), field("high", 2, PointField.UINT16)]
    )
    overlapping.data = array.array("B", np.array([0x00020001] * 8, "<u4").tobytes())
    assert read_points(overlapping)[["low", "high"]].tolist() == [(1, 2)] * 2


def test_as_many_numbers_as_a_point_may_have() -> None:
    names = dtype_from_fields([field("x", 0, PointField.UINT8, MAX_NUMBERS)]).names
    assert names is not None
    assert (len(names), names[-1]) == (MAX_NUMBERS, f"x_{MAX_NUMBERS - 1}")
    with pytest.raises(ValueError, match="gives each point more than"):
        dtype_from_fields([field("x", 0, PointField.UINT8, MAX_NUMBERS), field("y", MAX_NUMBERS)])
    with pytest.raises(ValueError, match=r"field 'x' .* bytes of a point, more than a point can have"):
        dtype_from_fields([field("x", MOST)])
