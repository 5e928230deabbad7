"""tf_transformations' functions: against each other, and against known values."""

from __future__ import annotations

import math
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tfloom.tf2_ros import transformations as tf

angles = st.floats(-1.5, 1.5)
quaternions = st.tuples(*[st.floats(-1, 1)] * 4).filter(lambda q: np.linalg.norm(q) > 0.1)


@given(quaternions, quaternions)
def test_products_and_matrices(a: tuple, b: tuple) -> None:
    a, b = tf.unit_vector(a), tf.unit_vector(b)
    product = tf.quaternion_multiply(a, b)
    assert np.allclose(
        tf.quaternion_matrix(product), tf.quaternion_matrix(a) @ tf.quaternion_matrix(b), atol=1e-9
    )
    assert np.allclose(tf.quaternion_multiply(a, tf.quaternion_inverse(a)), [0, 0, 0, 1], atol=1e-9)
    assert np.allclose(
        tf.quaternion_matrix(tf.quaternion_from_matrix(tf.quaternion_matrix(a))), tf.quaternion_matrix(a)
    )


@given(st.floats(0.01, 3.1), st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 0.1))
def test_rotations_about_an_axis(angle: float, axis: tuple) -> None:
    matrix = tf.rotation_matrix(angle, axis, (1, 2, 3))
    assert np.allclose(matrix @ [1, 2, 3, 1], [1, 2, 3, 1])
    assert np.allclose(tf.quaternion_matrix(tf.quaternion_about_axis(angle, axis))[:3, :3], matrix[:3, :3])
    back, direction, point = tf.rotation_from_matrix(matrix)
    assert tf.is_same_transform(tf.rotation_matrix(back, direction, point), matrix)


def test_slerp() -> None:
    start, end = (0, 0, 0, 1), tf.quaternion_about_axis(1.0, (0, 0, 1))
    assert np.allclose(tf.quaternion_slerp(start, end, 0.25), tf.quaternion_about_axis(0.25, (0, 0, 1)))
    assert np.allclose(tf.quaternion_slerp(start, -end, 0.25), tf.quaternion_about_axis(0.25, (0, 0, 1)))
    assert np.allclose(tf.quaternion_slerp(start, end, 1), end)


def test_matrices() -> None:
    moved = tf.translation_matrix((1, 2, 3))
    assert tf.translation_from_matrix(moved).tolist() == [1, 2, 3]
    assert np.allclose(tf.concatenate_matrices(moved, tf.inverse_matrix(moved)), tf.identity_matrix())
    assert tf.vector_norm([3, 4]) == 5
    assert np.allclose(tf.unit_vector([[3, 4], [0, 2]], axis=1), [[0.6, 0.8], [0, 1]])
    assert np.allclose(tf.quaternion_matrix((0, 0, 0, 0)), np.eye(4))
    assert np.linalg.norm(tf.random_quaternion()) == pytest.approx(1)
    assert np.allclose(np.linalg.det(tf.random_rotation_matrix()), 1)


def test_what_is_no_rotation() -> None:
    with pytest.raises(ValueError, match="no rotation"):
        tf.rotation_from_matrix(2 * np.eye(4))
    with pytest.raises(ValueError, match="moves along its axis"):
        tf.rotation_from_matrix(tf.translation_matrix((0, 0, 1)) @ tf.rotation_matrix(1, (0, 0, 1)))


def test_euler_angles_say_what_they_need(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "transforms3d.euler", None)
    with pytest.raises(ImportError, match=r"tfloom\[transformations\]"):
        tf.quaternion_from_euler(1, 2, 3)


class TestEuler:
    @pytest.fixture(autouse=True)
    def _needs_transforms3d(self) -> None:
        pytest.importorskip(
            "transforms3d", reason="transforms3d is not installed: pip install tfloom[transformations]"
        )

    def test_known_values(self) -> None:
        half = math.sqrt(0.5)
        assert np.allclose(tf.quaternion_from_euler(0, 0, math.pi / 2), [0, 0, half, half])
        assert np.allclose(tf.euler_from_quaternion([half, 0, 0, half]), [math.pi / 2, 0, 0])

    @pytest.mark.parametrize("axes", ["sxyz", "rxyz", "szyx", "rzxz"])
    def test_there_and_back(self, axes: str) -> None:
        for given_angles in [(0.1, 0.2, 0.3), (1.0, 0.5, -1.2)]:
            matrix = tf.euler_matrix(*given_angles, axes)
            assert np.allclose(tf.euler_from_matrix(matrix, axes), given_angles)
            assert np.allclose(tf.quaternion_matrix(tf.quaternion_from_euler(*given_angles, axes)), matrix)

    def test_compose(self) -> None:
        matrix = tf.compose_matrix((1, 2, 3), (0.1, 0, 0.2), (0.1, 0.2, 0.3), (4, 5, 6))
        scale, shear, turned, translate, perspective = tf.decompose_matrix(matrix)
        assert np.allclose(
            [*scale, *shear, *turned, *translate], [1, 2, 3, 0.1, 0, 0.2, 0.1, 0.2, 0.3, 4, 5, 6]
        )
        assert perspective.tolist() == [0, 0, 0, 1]


points = st.tuples(*[st.floats(-5, 5)] * 3)
directions = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 0.1)


@given(points, directions)
def test_reflections(point: tuple, normal: tuple) -> None:
    matrix = tf.reflection_matrix(point, normal)
    unit = tf.unit_vector(normal)
    assert np.allclose(matrix @ [*point, 1], [*point, 1])
    assert np.allclose(matrix @ [*(point + unit), 1], [*(point - unit), 1])
    assert np.allclose(tf.reflection_matrix(*tf.reflection_from_matrix(matrix)), matrix)


@given(st.floats(1.1, 5), points, directions)
def test_scales(factor: float, origin: tuple, direction: tuple) -> None:
    unit = tf.unit_vector(direction)
    across = np.cross(unit, np.add(np.roll(unit, 1), (0.1, 0.2, 0.3)))
    for matrix, expected in (
        (tf.scale_matrix(factor, origin), factor),
        (tf.scale_matrix(factor, origin, direction), 1.0),
    ):
        assert np.allclose(matrix @ [*(origin + unit), 1], [*(origin + factor * unit), 1])
        assert np.allclose(matrix @ [*(origin + across), 1], [*(origin + expected * across), 1])
        assert np.allclose(tf.scale_matrix(*tf.scale_from_matrix(matrix)), matrix)
    assert np.allclose(tf.scale_matrix(-1.0), np.diag([-1, -1, -1, 1]))


@given(st.floats(0.1, 1.2), points)
def test_shears(angle: float, point: tuple) -> None:
    matrix = tf.shear_matrix(angle, (1, 0, 0), point, (0, 0, 1))
    moved = matrix @ [point[0], point[1], point[2] + 2, 1]
    assert np.allclose(moved, [point[0] + 2 * math.tan(angle), point[1], point[2] + 2, 1])
    assert np.allclose(tf.shear_matrix(*tf.shear_from_matrix(matrix)), matrix, atol=1e-6)
    with pytest.raises(ValueError):
        tf.shear_matrix(angle, (1, 0, 1), point, (0, 0, 1))
