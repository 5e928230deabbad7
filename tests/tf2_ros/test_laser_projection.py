"""`laser_geometry`: the points of a laser scan."""

from __future__ import annotations

import math

import numpy as np
import pytest
from laser_geometry import LaserProjection
from laser_geometry.laser_geometry import LaserProjection as SameProjection
from sensor_msgs.msg import LaserScan, PointField
from sensor_msgs_py.point_cloud2 import read_points
from std_msgs.msg import Header

Option = LaserProjection.ChannelOption


def scan(**options: object) -> LaserScan:
    values: dict[str, object] = {
        "header": Header(frame_id="laser"),
        "angle_min": -math.pi / 2,
        "angle_increment": math.pi / 4,
        "time_increment": 0.1,
        "range_min": 0.5,
        "range_max": 10.0,
        "ranges": [1.0, 0.4, math.nan, 2.0, 10.0],
        "intensities": [7.0, 8.0, 9.0, 10.0, 11.0],
    }
    return LaserScan(**{**values, **options})


def test_valid_ranges_become_points() -> None:
    assert SameProjection is LaserProjection
    cloud = LaserProjection().projectLaser(scan())
    assert (cloud.header.frame_id, cloud.height, cloud.width, cloud.is_dense) == ("laser", 1, 2, False)
    assert [(field.name, field.offset, field.datatype) for field in cloud.fields] == [
        ("x", 0, PointField.FLOAT32),
        ("y", 4, PointField.FLOAT32),
        ("z", 8, PointField.FLOAT32),
        ("intensity", 12, PointField.FLOAT32),
        ("index", 16, PointField.INT32),
    ]
    points = read_points(cloud)
    root = math.sqrt(2.0)
    assert np.allclose(
        [points["x"], points["y"], points["z"]], [[0.0, root], [-1.0, root], [0.0, 0.0]], atol=1e-6
    )
    assert points["index"].tolist() == [0, 3]
    assert points["intensity"].tolist() == [7.0, 10.0]


@pytest.mark.parametrize(("cutoff", "kept"), [(-1.0, [0, 3, 4]), (20.0, [0, 3, 4]), (2.0, [0]), (0.1, [])])
def test_cutoff(cutoff: float, kept: list[int]) -> None:
    far = scan(ranges=[1.0, 0.4, math.inf, 2.0, 9.0])
    assert read_points(LaserProjection().projectLaser(far, cutoff))["index"].tolist() == kept


def test_all_channels() -> None:
    options = Option.INTENSITY | Option.INDEX | Option.DISTANCE | Option.TIMESTAMP | Option.VIEWPOINT
    points = read_points(LaserProjection().projectLaser(scan(), channel_options=options))
    assert points.dtype.names == (
        *("x", "y", "z", "intensity", "index", "distances", "stamps"),
        *("vp_x", "vp_y", "vp_z"),
    )
    assert points["distances"].tolist() == [1.0, 2.0]
    assert points["stamps"] == pytest.approx([0.0, 0.3])
    bare = LaserProjection().projectLaser(scan(intensities=[]), channel_options=Option.INTENSITY)
    assert [field.name for field in bare.fields] == ["x", "y", "z"]
    short = read_points(LaserProjection().projectLaser(scan(intensities=[7.0])))
    assert short["intensity"].tolist() == [7.0, 0.0]
