"""Clouds in the scene: a page gets points and their place together, wherever they are."""

from __future__ import annotations

import io
import json
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tfloom.tf2.transform import Transform
from tfloom.viewer import drawing
from tfloom.viewer.drawing import MAX_POINTS_SENT_AGAIN, Drawn, Pose
from tfloom.viewer.frame_models import axes_glb, spikes_between
from tfloom.viewer.shapes import Points

RED = np.array((255, 0, 0), np.uint8)


class FakeScene:
    """A scene with one cloud, and how often its points were sent."""

    def __init__(self) -> None:
        self.node: Any = None

    def add_point_cloud(self, name: str, points: Any, colors: Any, **options: Any) -> Any:
        place = {"position": np.zeros(3), "wxyz": np.eye(4)[0], "visible": True}
        self.node = SimpleNamespace(name=name, points=points, colors=colors, **place, **options)
        return self.node

    def node_pose(self) -> Transform:
        w, x, y, z = self.node.wxyz
        return Transform(tuple(self.node.position), (x, y, z, w))

    def seen(self) -> NDArray[np.float64]:
        """Return where a page shows the points, in double precision."""
        matrix = self.node_pose().matrix()
        seen: NDArray[np.float64] = (
            np.asarray(self.node.points, np.float64) @ matrix[:3, :3].T + matrix[:3, 3]
        )
        return seen


def pose(yaw_rad: float, x: float = 0.0, y: float = 0.0) -> Pose:
    turned = Transform.from_rpy(0.1, -0.2, yaw_rad, (x, y, 0.3))
    return turned.translation, turned.rotation_xyzw


def where(points: NDArray[np.float32], at: Pose) -> NDArray[np.float64]:
    return np.array([Transform(*at).apply(point) for point in points.astype(float)])


def cloud(number: int, count: int = 20) -> Points:
    return Points(np.random.default_rng(number).normal(size=(count, 3)).astype(np.float32), RED)


def test_points_of_a_frame_that_turns_come_with_their_place_and_the_node_stands_still() -> None:
    """A page applies a node's pose and its points in different pictures, so only one of them may change."""
    scene: Any = FakeScene()
    drawn = Drawn(scene, "/scan", cloud(0))
    for number in range(10):
        shape, at = cloud(number), pose(0.4 * number, x=2.0 * number)
        drawn.change(shape)
        drawn.place(at)
        assert np.allclose(scene.seen(), where(shape.positions, at), atol=1e-5)
        assert scene.node_pose() == Transform()
    last = cloud(9)
    drawn.place(pose(9.0))  # its transform came later
    assert np.allclose(scene.seen(), where(last.positions, pose(9.0)), atol=1e-5)
    assert scene.node_pose() == Transform()
    drawn.place(None)
    assert not scene.node.visible


def test_large_cloud_whose_pose_alone_changes_is_moved_and_not_sent_again() -> None:
    scene: Any = FakeScene()
    shape = cloud(1, MAX_POINTS_SENT_AGAIN + 1)
    drawn = Drawn(scene, "/cloud", shape)
    drawn.place(pose(1.0, x=3.0))
    sent = scene.node.points
    for yaw_rad in (1.5, 2.0):
        drawn.place(pose(yaw_rad, y=-4.0))
        assert scene.node.points is sent
        assert np.allclose(scene.seen(), where(shape.positions, pose(yaw_rad, y=-4.0)), atol=1e-5)
    drawn.change(cloud(2, MAX_POINTS_SENT_AGAIN + 1))
    drawn.place(pose(2.0))
    assert scene.node_pose() == Transform()
    assert np.allclose(
        scene.seen(), where(cloud(2, MAX_POINTS_SENT_AGAIN + 1).positions, pose(2.0)), atol=1e-5
    )


def test_points_far_from_the_origin_keep_their_precision() -> None:
    """As in coordinates of a country, whose single precision would be half a metre."""
    scene: Any = FakeScene()
    drawn = Drawn(scene, "/scan", cloud(0))
    for number in range(4):
        shape, at = cloud(number), pose(0.3 * number, x=500_000.1 + 900.0 * number, y=5_800_000.7)
        drawn.change(shape)
        drawn.place(at)
        assert np.allclose(scene.seen(), where(shape.positions, at), atol=1e-3)


def test_points_have_a_size_in_pixels_or_in_metres(monkeypatch: pytest.MonkeyPatch) -> None:
    scene: Any = FakeScene()
    positions = np.zeros((2, 3), np.float32)

    def size(**options: float) -> tuple[float, str]:
        drawn.change(Points(positions, RED, **options))
        return scene.node.point_size, scene.node.point_shape

    drawn = Drawn(scene, "/scan", Points(positions, RED, size_m=0.2, size_px=3.0))
    assert (scene.node.point_size, scene.node.point_shape) == (-0.003, "square")
    assert size(size_m=0.5) == (0.5, "circle")
    assert size(size_m=0.5, size_px=2.0) == (-0.002, "square")
    monkeypatch.setattr(drawing, "HAS_PIXEL_POINTS", False)  # as with another client of viser
    assert size(size_m=0.4, size_px=3.0) == (0.4, "circle")


def test_axes_are_prisms_of_the_colours_of_their_axes_that_are_seen_from_outside() -> None:
    import trimesh

    glb = axes_glb(0.05)
    mesh = trimesh.load(io.BytesIO(glb), file_type="glb", force="mesh", process=False)
    text_end = 20 + int.from_bytes(glb[12:16], "little")
    start = text_end + 8 + json.loads(glb[20:text_end])["bufferViews"][1]["byteOffset"]
    colors = np.frombuffer(glb, "<f4", 3 * len(mesh.vertices), start).reshape(-1, 3)
    assert mesh.bounds == pytest.approx(np.array([[-0.05] * 3, [1.0] * 3]), abs=0.01)
    for axis, part in enumerate(np.array_split(np.asarray(mesh.faces), 3)):
        prism = trimesh.Trimesh(mesh.vertices, part, process=True)
        assert prism.is_watertight
        assert prism.volume == pytest.approx(
            3.0 * 3.0**0.5 / 2.0 * 0.05**2, rel=1e-4
        )  # below 0 where it is turned inside out
        assert np.ptp(prism.vertices, axis=0).argmax() == axis
        linear = np.zeros((len(np.unique(part)), 3))
        linear[:, axis] = ((204 / 255 + 0.055) / 1.055) ** 2.4
        assert colors[np.unique(part)] == pytest.approx(linear, abs=1e-3)


def test_spikes_lead_from_the_first_to_the_second_end_whatever_the_direction() -> None:
    chance = np.random.default_rng(1)
    ends = chance.normal(size=(20, 2, 3))
    ends[:4, 0] = 0.0
    ends[:4, 1] = [(2.0, 0.0, 0.0), (-2.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 0.0, 0.0)]
    spikes = spikes_between(ends, np.zeros((20, 3), np.uint8), 0.1)
    assert np.linalg.norm(spikes.batched_wxyzs, axis=1) == pytest.approx(1.0)
    for (start, end), (w, x, y, z), scale in zip(
        ends, spikes.batched_wxyzs.tolist(), spikes.batched_scales.tolist(), strict=True
    ):
        tip = Transform(start.tolist(), (x, y, z, w)).apply((scale[0], 0.0, 0.0))
        assert tip == pytest.approx(end.tolist(), abs=1e-5)
        assert scale[1:] == pytest.approx([0.1, 0.1])
