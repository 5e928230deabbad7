"""What a place on the screen shows."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from tfloom.viewer import shapes
from tfloom.viewer.camera import Camera
from tfloom.viewer.frames import FramePoses
from tfloom.viewer.picking import frame_at, nearest_shape

CAMERA = Camera((0.0, 0.0, 10.0), (1.0, 0.0, 0.0, 0.0), math.radians(60.0), 2.0)
"""It looks down from 10 m."""
HERE = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)
HEIGHT_PX = 500.0
GREY = (1, 1, 1)
COLOR = np.zeros(3, np.uint8)
TRIANGLE = np.array([[-1, -1, 0.5], [1, -1, 0.5], [0, 2, 0.5]], np.float32)
SHAPES: list[tuple[Any, float]] = [
    (shapes.Points(np.array([[3, 3, 3], [0.01, 0, 1], [0, 0.01, 2]], np.float32), COLOR), 8.0),
    (shapes.Lines(np.array([[[-1, 0, 1], [1, 0, 3]]], np.float32), COLOR), 8.0),
    (shapes.Lines(np.array([[[0, 0, 1], [0, 0, 3]]], np.float32), COLOR), 9.0),
    (shapes.Arrows(np.array([[[-1, 0.01, 1], [1, 0.01, 1]]], np.float32), GREY), 9.0),
    (shapes.Axes(np.zeros((1, 3), np.float32), np.zeros((1, 4), np.float32)), 10.0),
    (shapes.Mesh(TRIANGLE, np.array([[0, 1, 2]], np.uint32), GREY), 9.5),
    (shapes.Box((1, 2, 3), GREY), 8.5),
    (shapes.Ball((1, 2, 3), GREY), 7.0),
    (shapes.Cylinder(1, 4, GREY), 8.0),
    (shapes.Copies("box", np.array([[0, 0, 0], [0, 0, 2], [9, 9, 9]], np.float32), (1, 1, 1), COLOR), 7.5),
    (shapes.Text("t"), 10.0),
    (shapes.Picture(np.zeros((1, 1, 3), np.uint8), (2, 3)), 10.0),
]


def met(shape: Any, pose: Any, across: float = 0.5, down: float = 0.5) -> Any:
    return nearest_shape(CAMERA, across, down, {"/a": [(shape, pose)]}, HEIGHT_PX)


@pytest.mark.parametrize(("shape", "distance_m"), SHAPES, ids=lambda value: type(value).__name__)
def test_shape_is_met_where_it_is(shape: Any, distance_m: float) -> None:
    found = met(shape, HERE)
    assert (found.display, found.number) == ("/a", 0)
    assert found.distance_m == pytest.approx(distance_m, abs=1e-3)
    assert found.point == pytest.approx((0.0, 0.0, 10.0 - distance_m), abs=1e-3)
    assert met(shape, None) is None  # it is hidden
    assert met(shape, ((0.0, 0.0, 30.0), HERE[1])) is None  # it is behind the camera
    assert met(shape, ((40.0, 0.0, 0.0), HERE[1])) is None
    # Where it is moved to, it is met: 10 m down, half the height of the picture is 5.77 m.
    beside = met(shape, ((2.0, 0.0, 0.0), HERE[1]), 0.5 + 2.0 / (2.0 * 2.0 * 10.0 * math.tan(math.pi / 6.0)))
    assert beside is not None


def test_turned_cylinder_is_met_at_its_side() -> None:
    lying = (0.0, 0.0, 0.0), (0.0, math.sqrt(0.5), 0.0, math.sqrt(0.5))
    assert met(shapes.Cylinder(1, 8, GREY), lying).distance_m == pytest.approx(9.0)
    assert met(shapes.Cylinder(1, 8, GREY), lying, 0.6).distance_m == pytest.approx(9.0 * 1.026, abs=0.05)


def test_nearest_of_several_is_met() -> None:
    box = shapes.Box((1, 1, 1), GREY)
    low, high = ((0.0, 0.0, -5.0), HERE[1]), ((0.0, 0.0, 5.0), HERE[1])
    found = nearest_shape(CAMERA, 0.5, 0.5, {"/a": [(box, low)], "/b": [(box, low), (box, high)]}, HEIGHT_PX)
    assert found is not None
    assert (found.display, found.number, found.point) == ("/b", 1, pytest.approx((0.0, 0.0, 5.5), abs=1e-3))


def test_camera_within_a_box_sees_its_far_side() -> None:
    assert met(shapes.Box((40, 40, 40), GREY), HERE).distance_m == pytest.approx(30.0, abs=1e-3)


def test_shapes_of_nothing_are_never_met() -> None:
    nothing = np.empty((0, 3), np.float32)
    for shape in (
        shapes.Points(nothing, COLOR),
        shapes.Lines(np.empty((0, 2, 3), np.float32), COLOR),
        shapes.Mesh(nothing, np.empty((0, 3), np.uint32), GREY),
        shapes.Mesh(np.zeros((3, 3), np.float32), np.array([[0, 1, 2]], np.uint32), GREY),
        shapes.Points(np.full((2, 3), np.nan, np.float32), COLOR),
        shapes.Copies("ball", nothing, (1, 1, 1), COLOR),
        shapes.Model(b"no glTF"),
    ):
        assert met(shape, HERE) is None, shape


def test_frame_at_a_place() -> None:
    positions = np.array([(0.0, 0.0, 0.0), (0.0, 0.0, 4.0), (3.0, 0.0, 0.0), (0.0, 0.0, 20.0)])
    poses = FramePoses(
        ["low", "high", "beside", "behind"], positions, np.tile((0, 0, 0, 1.0), (4, 1)), np.full(4, -1)
    )
    assert frame_at(CAMERA, 0.5, 0.5, poses, HEIGHT_PX) == "high"
    assert frame_at(CAMERA, 0.5, 0.9, poses, HEIGHT_PX) is None
    across = 0.5 + 3.0 / (2.0 * 2.0 * 10.0 * math.tan(math.pi / 6.0))
    assert frame_at(CAMERA, across, 0.5, poses, HEIGHT_PX) == "beside"
    assert frame_at(CAMERA, across + 9.0 / 1000.0, 0.5, poses, HEIGHT_PX) == "beside"  # 9 px aside
    assert frame_at(CAMERA, across + 11.0 / 1000.0, 0.5, poses, HEIGHT_PX) is None
    near = positions + np.array([(0.0, 0.0, 0.0), (0.15, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)])
    assert (
        frame_at(CAMERA, 0.5, 0.5, poses._replace(positions=near), HEIGHT_PX, 20.0) == "low"
    )  # 10 px nearer
    none = FramePoses([], np.empty((0, 3)), np.empty((0, 4)), np.empty(0, np.int64))
    assert frame_at(CAMERA, 0.5, 0.5, none, HEIGHT_PX) is None
