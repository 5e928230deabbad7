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
