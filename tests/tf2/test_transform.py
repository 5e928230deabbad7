"""Transforms form a group, and convert to every other form and back."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.oracles.transforms import matrix

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.transform import Transform

numbers = st.floats(-100, 100)
angles = st.floats(-math.pi, math.pi)
transforms = st.builds(
    Transform,
    st.tuples(numbers, numbers, numbers),
    st.tuples(*[st.floats(-1, 1)] * 4).filter(lambda q: np.linalg.norm(q) > 0.1),
)


def is_close(a: Transform, b: Transform) -> bool:
    return np.allclose(a.matrix(), b.matrix(), rtol=1e-9, atol=1e-9)


@given(transforms, transforms, transforms)
def test_transforms_form_a_group(a: Transform, b: Transform, c: Transform) -> None:
    assert is_close((a @ b) @ c, a @ (b @ c))
    assert is_close(a @ Transform(), a)
    assert is_close(Transform() @ a, a)
    assert is_close(a @ a.inverse(), Transform())
    assert is_close((a @ b).inverse(), b.inverse() @ a.inverse())


@given(transforms, transforms, st.tuples(numbers, numbers, numbers))
def test_matrix_and_points(a: Transform, b: Transform, point: tuple[float, ...]) -> None:
    assert np.allclose(a.matrix(), matrix(np.array(a.translation), np.array(a.rotation_xyzw)), atol=1e-12)
    assert np.allclose((a @ b).matrix(), a.matrix() @ b.matrix(), atol=1e-9)
    assert np.allclose(a.apply(point), (a.matrix() @ [*point, 1])[:3], atol=1e-9)
    assert is_close(Transform.from_matrix(a.matrix()), a)
    assert is_close(Transform.from_matrix(a.rows()[:3]), a)


@given(transforms)
def test_conversions_to_other_forms(a: Transform) -> None:
    assert is_close(Transform.from_axis_angle(*a.axis_angle, a.translation), a)
    assert is_close(Transform.from_rpy(*a.rpy_rad, a.translation), a)
    assert pickle.loads(pickle.dumps(a)) == a or is_close(pickle.loads(pickle.dumps(a)), a)


@given(angles, st.floats(-1.57, 1.57), angles)
def test_rpy(roll: float, pitch: float, yaw: float) -> None:
    back = Transform.from_rpy(roll, pitch, yaw).rpy_rad
    assert np.allclose(np.sin(back), np.sin([roll, pitch, yaw]), atol=1e-9)
    assert np.allclose(np.cos(back), np.cos([roll, pitch, yaw]), atol=1e-9)


@pytest.mark.parametrize("pitch", [math.pi / 2, -math.pi / 2])
def test_rpy_in_gimbal_lock(pitch: float) -> None:
    turned = Transform.from_rpy(0.3, pitch, 0.8)
    roll, same_pitch, yaw = turned.rpy_rad
    assert (yaw, same_pitch) == (0, pytest.approx(pitch, abs=1e-12))
    assert is_close(Transform.from_rpy(roll, same_pitch, 0), turned)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("away", [10.0**-power for power in range(1, 17)])
def test_rpy_near_gimbal_lock_loses_nothing(away: float, sign: int) -> None:
    turned = Transform.from_rpy(0.3, sign * (math.pi / 2 - away), 0.8)
    assert np.allclose(Transform.from_rpy(*turned.rpy_rad).matrix(), turned.matrix(), rtol=0, atol=2e-12)


@pytest.mark.parametrize(
    ("rotation", "rpy"),
    [
        ((1, 0, 0, 0), (math.pi, 0, 0)),
        ((0, 1, 0, 0), (math.pi, 0, math.pi)),
        ((0, 0, 1, 0), (0, 0, math.pi)),
        ((0, 1, 0, 1), (0, math.pi / 2, 0)),
    ],
)
def test_rpy_of_half_and_quarter_turns(rotation: tuple, rpy: tuple) -> None:
    assert Transform((0, 0, 0), rotation).rpy_rad == pytest.approx(rpy, abs=1e-12)


@given(transforms, transforms, st.floats(0, 1))
def test_interpolation(a: Transform, b: Transform, ratio: float) -> None:
    assert is_close(a.interpolate(b, 0), a)
    assert is_close(a.interpolate(b, 1), b)
    assert np.linalg.norm(a.interpolate(b, ratio).rotation_xyzw) == pytest.approx(1, abs=1e-9)


def test_transforms_are_values() -> None:
    a = Transform((1, 2, 3), (0, 0, 0.6, 0.8))
    assert a == Transform((1, 2, 3), (0, 0, 0.6, 0.8))
    assert a != Transform()
    assert a != "a transform"
    assert len({a, Transform((1, 2, 3), (0, 0, 0.6, 0.8))}) == 1
    assert repr(Transform()) == "Transform(translation=(0.0, 0.0, 0.0), rotation_xyzw=(0.0, 0.0, 0.0, 1.0))"
    with pytest.raises(AttributeError):
        a.translation = (0, 0, 0)


def test_lookup_result_can_be_composed() -> None:
    buffer = Buffer()
    buffer.set("a", "b", 1, (1, 2, 3), (0, 0, 1, 1))
    buffer.set("b", "c", 1, (4, 5, 6), (1, 0, 0, 1))
    a_from_b, b_from_c = buffer.lookup("a", "b").transform, buffer.lookup("b", "c").transform
    assert is_close(a_from_b @ b_from_c, buffer.lookup("a", "c").transform)


@pytest.mark.parametrize(
    "make",
    [
        lambda: Transform((0, 0, 0), (0, 0, 0, 0)),
        lambda: Transform((0, 0, 0), (math.nan, 0, 0, 1)),
        lambda: Transform.from_axis_angle((0, 0, 0), 1.0),
        lambda: Transform.from_matrix(np.diag([1, 1, -1, 1])),
        lambda: Transform.from_matrix(2 * np.eye(4)),
        lambda: Transform.from_matrix(np.eye(3)),
    ],
)
def test_invalid_transforms_raise(make: object) -> None:
    with pytest.raises(ValueError, match=r"rotation|direction|shape"):
        make()


def test_scipy() -> None:
    rotation = pytest.importorskip("scipy.spatial.transform", reason="scipy is not installed").Rotation
    a = Transform.from_rpy(0.1, 0.2, 0.3, (1, 2, 3))
    assert np.allclose(a.to_scipy().as_matrix(), a.matrix()[:3, :3])
    assert is_close(Transform.from_scipy(rotation.from_euler("xyz", [0.1, 0.2, 0.3]), (1, 2, 3)), a)
