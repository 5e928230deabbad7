"""How far shapes reach, and that a camera sees all of them."""

from __future__ import annotations

import json
import math
import tracemalloc
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from tfloom.tf2.transform import Transform
from tfloom.viewer import extents, shapes
from tfloom.viewer.extents import Extent, extent_of, view_of

HERE = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)
QUARTER_TURN = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
GREY = (1, 1, 1)
NOTHING = np.empty((0, 3))
PAIR = np.array([[[0, 0, 0], [1, 2, 3]]], np.float32)
COLOR = np.zeros(3, np.uint8)
SHAPES: list[tuple[Any, tuple[float, ...], tuple[float, ...]]] = [
    (shapes.Points(PAIR[0], COLOR), (0, 0, 0), (1, 2, 3)),
    (shapes.Points(np.array([[np.nan, 0, 0], [1, 1, 1]], np.float32), COLOR), (1, 1, 1), (1, 1, 1)),
    (shapes.Lines(PAIR, COLOR), (0, 0, 0), (1, 2, 3)),
    (shapes.Arrows(PAIR, GREY), (0, 0, 0), (1, 2, 3)),
    (shapes.Axes(PAIR[0], np.zeros((2, 4), np.float32)), (0, 0, 0), (1, 2, 3)),
    (shapes.Mesh(PAIR[0], np.zeros((1, 3), np.uint32), GREY), (0, 0, 0), (1, 2, 3)),
    (shapes.Box((1, 2, 3), GREY), (-0.5, -1, -1.5), (0.5, 1, 1.5)),
    (shapes.Ball((1, 2, 3), GREY), (-1, -2, -3), (1, 2, 3)),
    (shapes.Cylinder(1, 4, GREY), (-1, -1, -2), (1, 1, 2)),
    (shapes.Copies("box", PAIR[0], (2, 2, 2), COLOR), (-1, -1, -1), (2, 3, 4)),
    (shapes.Text("t"), (0, 0, 0), (0, 0, 0)),
    (shapes.Picture(np.zeros((1, 1, 3), np.uint8), (2, 3)), (0, 0, 0), (2, 3, 0)),
]


@pytest.mark.parametrize(("shape", "low", "high"), SHAPES, ids=lambda value: type(value).__name__)
def test_each_shape_has_its_reach(shape: Any, low: tuple[float, ...], high: tuple[float, ...]) -> None:
    extent = extent_of(NOTHING, [(shape, HERE)])
    assert extent is not None
    assert (extent.low.tolist(), extent.high.tolist()) == (list(low), list(high))


def test_each_kind_of_shape_is_tried() -> None:
    assert {type(shape) for shape, _, _ in SHAPES} | {shapes.Model} == set(shapes.Shape.__args__)  # type: ignore[attr-defined]


def test_poses_count_and_what_has_none_does_not() -> None:
    box = shapes.Box((2.0, 4.0, 6.0), GREY)
    extent = extent_of(np.array([[9.0, 0.0, 0.0]]), [(box, ((1.0, 0.0, 0.0), QUARTER_TURN)), (box, None)])
    assert extent is not None
    np.testing.assert_allclose([extent.low, extent.high], [[-1, -1, -3], [9, 1, 3]], atol=1e-12)
    assert extent_of(NOTHING, [(box, None), (shapes.Model(b"no glTF"), HERE)]) is None
    assert extent_of(np.array([[math.nan, 0.0, 0.0], [1e13, 0.0, 0.0]]), []) is None


def test_model_reaches_as_far_as_its_nodes_are_moved() -> None:
    trimesh = pytest.importorskip("trimesh")
    scene = trimesh.Scene()
    turned = np.array([[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]], np.float64)
    scene.add_geometry(trimesh.creation.box((1, 2, 3)), transform=turned)
    extent = extent_of(NOTHING, [(shapes.Model(scene.export(file_type="glb"), (1.0, 1.0, 2.0)), HERE)])
    assert extent is not None
    np.testing.assert_allclose([extent.low, extent.high], [[4, -0.5, -6], [6, 0.5, 6]], atol=1e-6)


def model(content: str) -> shapes.Model:
    text = content.encode()
    return shapes.Model(
        b"glTF" + bytes(8) + len(text).to_bytes(4, "little") + b"JSON" + text, (1.0, 1.0, 1.0)
    )


def content_of(least: int = 0, children: Sequence[int] = (), primitives: int = 1) -> dict[str, Any]:
    return {
        "nodes": [{"mesh": 0, "children": children}],
        "scenes": [{"nodes": [0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}] * primitives}],
        "accessors": [{"min": [least, 0, 0], "max": [1, 1, 1]}],
    }


@pytest.mark.parametrize(
    "content",
    ["[" * 100_000, json.dumps(content_of(least=10**400)), '{"scenes": 5}'],
    ids=["deep", "a number of 400 digits", "no scenes"],
)
def test_model_that_says_nothing_sensible_has_no_reach(content: str) -> None:
    assert extent_of(NOTHING, [(model(content), HERE)]) is None


def test_model_of_more_nodes_than_are_looked_at_costs_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(extents, "MAX_NODES", 100)
    shape = model(json.dumps(content_of(children=[0] * 1000, primitives=30)))
    tracemalloc.start()
    extent = extent_of(NOTHING, [(shape, HERE)])
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert extent is not None
    np.testing.assert_allclose(extent.high, 1.0)
    assert peak < 1_000_000


@pytest.mark.parametrize("aspect", [0.3, 1.0, 3.0])
@pytest.mark.parametrize("direction", [(-3.0, -4.0, 4.0), (1.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.1, 0.0, -5.0)])
def test_camera_sees_all_from_its_side(aspect: float, direction: tuple[float, float, float]) -> None:
    extent = Extent(np.array([1.0, -2.0, 3.0]), np.array([2.0, 4.0, 3.5]))
    view = view_of(extent, 1.0, aspect, direction)
    middle = (extent.low + extent.high) / 2.0
    assert view.look_at == tuple(middle)
    back = np.array(view.position) - middle
    if any(direction):
        np.testing.assert_allclose(
            back / np.linalg.norm(back), np.array(direction) / np.linalg.norm(direction)
        )
    ahead = -back / np.linalg.norm(back)
    right = np.cross(ahead, (0.0, 0.0, 1.0))
    right = right / np.linalg.norm(right) if np.linalg.norm(right) else np.array((1.0, 0.0, 0.0))
    up = np.cross(right, ahead)
    reaches = []
    for x in (0, 1):
        for y in (0, 1):
            for z in (0, 1):
                corner = np.where([x, y, z], extent.high, extent.low) - np.array(view.position)
                depth = corner @ ahead
                across, above = corner @ right / depth, corner @ up / depth
                reaches += [abs(across) / (math.tan(0.5) * aspect), abs(above) / math.tan(0.5)]
    assert 0.25 < max(reaches) < 1.0


def test_nothing_is_looked_at_from_within() -> None:
    point = Extent(np.zeros(3), np.zeros(3))
    assert math.dist(view_of(point, 1.0, 1.0).position, (0.0, 0.0, 0.0)) > 0.1


def test_pose_of_a_shape_is_that_of_its_corners() -> None:
    pose = (0.5, 1.0, -2.0), Transform.from_rpy(0.3, -0.2, 1.1).rotation_xyzw
    extent = extent_of(NOTHING, [(shapes.Box((2.0, 2.0, 2.0), GREY), pose)])
    assert extent is not None
    assert extent.radius_m > math.sqrt(3.0)
