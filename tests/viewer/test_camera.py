"""From the screen to the floor."""

from __future__ import annotations

import math

import pytest

from tfloom.tf2.transform import Transform
from tfloom.viewer.camera import Camera, floor_point

DOWN = (1.0, 0.0, 0.0, 0.0)
"""A camera that looks down, with x to the right and the screen's upper side along y."""


def test_camera_above_sees_the_floor_below_its_middle() -> None:
    camera = Camera((2.0, 3.0, 4.0), DOWN, math.radians(90.0), 2.0)
    assert floor_point(camera, 0.5, 0.5) == pytest.approx((2.0, 3.0))
    # 90 degrees at 4 m show 4 m up and down, and twice as much to the sides.
    assert floor_point(camera, 1.0, 0.5) == pytest.approx((10.0, 3.0))
    assert floor_point(camera, 0.5, 0.0) == pytest.approx((2.0, 7.0))


def test_oblique_camera() -> None:
    ahead_and_down = Transform.from_rpy(
        math.radians(-120.0), 0.0, 0.0
    ).rotation_xyzw  # 30 degrees below the horizon
    camera = Camera((0.0, 0.0, 1.0), ahead_and_down, math.radians(60.0), 1.0)
    x, y = floor_point(camera, 0.5, 0.5)
    assert (x, y) == pytest.approx((0.0, math.sqrt(3.0)))


def test_place_that_shows_no_floor() -> None:
    level = Transform.from_rpy(math.radians(-90.0), 0.0, 0.0).rotation_xyzw
    camera = Camera((0.0, 0.0, 1.0), level, math.radians(60.0), 1.0)
    assert floor_point(camera, 0.5, 0.2) is None  # the sky
    assert floor_point(camera, 0.5, 0.5) is None  # the horizon
    assert floor_point(camera, 0.5, 0.8) is not None
    assert floor_point(camera._replace(position=(0.0, 0.0, 0.0)), 0.5, 0.8) is None  # within the floor
