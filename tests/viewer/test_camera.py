"""From the screen to the floor."""

from __future__ import annotations

import math
from typing import Any

import pytest

from tfloom.tf2.transform import Transform
from tfloom.viewer.camera import Camera, floor_point, is_usable

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


def test_camera_that_is_none() -> None:
    view = {"position": (1.0, 2, 3), "look_at": (0, 0, 0), "rotation_wxyz": (1, 0, 0, 0)}
    camera: dict[str, Any] = {**view, "fov_rad": 1.0, "aspect": 1.5}
    assert is_usable(**camera)
    nan = math.nan
    for changed in (
        {"position": (1.0, 2.0)},
        {"position": (1.0, 2.0, nan)},
        {"position": (1.0, 2.0, 1e308)},
        {"look_at": (math.inf, 0.0, 0.0)},
        {"rotation_wxyz": (0.0, 0.0, 0.0, 0.0)},
        {"rotation_wxyz": (1e-9, 0.0, 0.0, 0.0)},
        {"rotation_wxyz": (nan, nan, nan, nan)},
        {"rotation_wxyz": (1.0,)},
        {"fov_rad": 0.0},
        {"fov_rad": math.pi},
        {"fov_rad": nan},
        {"aspect": 0.0},
        {"aspect": math.inf},
    ):
        assert not is_usable(**(camera | changed)), changed
