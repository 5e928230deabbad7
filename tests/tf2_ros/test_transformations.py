"""tf_transformations' functions: against each other, and against known values."""

from __future__ import annotations

import inspect
import math
import sys
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tfloom.tf2_ros.transformations import transformations as tf

SIGNATURES = """
arcball_constrain_to_axis(point, axis)
arcball_map_to_sphere(point, center, radius)
arcball_nearest_axis(point, axes)
clip_matrix(left, right, bottom, top, near, far, perspective=False)
compose_matrix(scale=None, shear=None, angles=None, translate=None, perspective=None)
concatenate_matrices(*matrices)
decompose_matrix(matrix)
euler_from_matrix(matrix, axes='sxyz')
euler_from_quaternion(quaternion, axes='sxyz')
euler_matrix(ai, aj, ak, axes='sxyz')
identity_matrix()
inverse_matrix(matrix)
is_same_transform(matrix0, matrix1)
orthogonalization_matrix(lengths, angles)
projection_from_matrix(matrix, pseudo=False)
projection_matrix(point, normal, direction=None, perspective=None, pseudo=False)
quaternion_about_axis(angle, axis)
quaternion_conjugate(quaternion)
quaternion_from_euler(ai, aj, ak, axes='sxyz')
quaternion_from_matrix(matrix)
quaternion_inverse(quaternion)
quaternion_matrix(quaternion)
quaternion_multiply(quaternion1, quaternion0)
quaternion_slerp(quat0, quat1, fraction, spin=0, shortestpath=True)
random_quaternion(rand=None)
random_rotation_matrix(rand=None)
random_vector(size)
reflection_from_matrix(matrix)
reflection_matrix(point, normal)
rotation_from_matrix(matrix)
rotation_matrix(angle, direction, point=None)
scale_from_matrix(matrix)
scale_matrix(factor, origin=None, direction=None)
shear_from_matrix(matrix)
shear_matrix(angle, direction, point, normal)
superimposition_matrix(v0, v1, scaling=False, usesvd=True)
translation_from_matrix(matrix)
translation_matrix(direction)
unit_vector(data, axis=None, out=None)
vector_norm(data, axis=None, out=None)
"""
"""What the ROS package tf_transformations has, besides the class Arcball."""


def test_every_function_has_the_name_and_the_arguments_that_programs_use() -> None:
    import tf_transformations

    ours = set()
    for name, function in inspect.getmembers(tf_transformations, inspect.isfunction):
        parameters = inspect.signature(function).parameters.values()
        bare = [parameter.replace(annotation=inspect.Parameter.empty) for parameter in parameters]
        ours.add(f"{name}({', '.join(map(str, bare))})")
    assert set(SIGNATURES.split("\n")[1:-1]) == ours


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
    assert np.allclose(tf.quaternion_slerp(start, -end, 1), -end)  # at the ends, the arguments themselves
    assert np.allclose(tf.quaternion_slerp(start, end, 2), tf.quaternion_about_axis(2.0, (0, 0, 1)))
    assert np.allclose(tf.quaternion_slerp(start, -end, 0.5, shortestpath=False), [0, 0, -0.968912, 0.247404])
    assert np.allclose(
        tf.quaternion_slerp(start, end, 0.5, spin=1), tf.quaternion_about_axis(0.5 + math.pi, (0, 0, 1))
    )
    assert tf.quaternion_slerp(start, start, 0.5).tolist() == [0, 0, 0, 1]


def test_numbers_of_the_reference() -> None:
    assert np.allclose(tf.quaternion_multiply([1, -2, 3, 4], [-5, 6, 7, 8]), [-44, -14, 48, 28])
    turned = tf.rotation_matrix(0.123, (1, 2, 3))
    assert np.allclose(tf.quaternion_from_matrix(turned), [0.0164262, 0.0328524, 0.0492786, 0.9981095])
    assert np.allclose(tf.quaternion_about_axis(0.123, (1, 0, 0)), [0.06146124, 0, 0, 0.99810947])
    assert tf.quaternion_conjugate([1, 2, 3, 4]).tolist() == [-1, -2, -3, 4]
    assert np.allclose(tf.random_quaternion([0.25, 0.5, 0]), [0, -math.sqrt(0.75), 0, 0.5])


def test_random_rotations_are_uniform() -> None:
    """The mean of R is 0, and of the trace squared 1, for a uniform distribution."""
    matrices = np.array([tf.random_rotation_matrix()[:3, :3] for _ in range(4000)])
    assert np.abs(matrices.mean(axis=0)).max() < 0.05
    assert (np.trace(matrices, axis1=1, axis2=2) ** 2).mean() == pytest.approx(1, abs=0.15)
    numbers = tf.random_vector(10_000)
    assert ((numbers >= 0) & (numbers < 1)).all()
    assert tf.random_vector((2, 3)).shape == (2, 3)


def test_lengths_written_to_an_array() -> None:
    vectors = np.arange(1.0, 25.0).reshape(2, 4, 3)
    lengths, units = np.empty((2, 3)), np.empty_like(vectors)
    assert tf.vector_norm(vectors, axis=1, out=lengths) is None
    assert np.allclose(lengths, np.linalg.norm(vectors, axis=1))
    assert tf.unit_vector(vectors, axis=1, out=units) is None
    assert np.allclose(np.linalg.norm(units, axis=1), 1)
    assert tf.unit_vector(vectors, axis=-1) == pytest.approx(
        vectors / np.linalg.norm(vectors, axis=-1)[..., None]
    )
    own = vectors.copy()
    tf.unit_vector(own, axis=1, out=own)
    assert (own == units).all()
    assert tf.vector_norm([]) == 0


def test_matrices_and_vectors_have_their_known_values() -> None:
    moved = tf.translation_matrix((1, 2, 3))
    assert tf.translation_from_matrix(moved).tolist() == [1, 2, 3]
    assert np.allclose(tf.concatenate_matrices(moved, tf.inverse_matrix(moved)), tf.identity_matrix())
    assert tf.vector_norm([3, 4]) == 5
    assert np.allclose(tf.unit_vector([[3, 4], [0, 2]], axis=1), [[0.6, 0.8], [0, 1]])
    assert np.allclose(tf.quaternion_matrix((0, 0, 0, 0)), np.eye(4))
    assert np.linalg.norm(tf.random_quaternion()) == pytest.approx(1)
    assert np.allclose(np.linalg.det(tf.random_rotation_matrix()), 1)


def test_matrix_without_rotation_raises() -> None:
    with pytest.raises(ValueError, match="no rotation"):
        tf.rotation_from_matrix(2 * np.eye(4))
    with pytest.raises(ValueError, match="moves along its axis"):
        tf.rotation_from_matrix(tf.translation_matrix((0, 0, 1)) @ tf.rotation_matrix(1, (0, 0, 1)))


def test_axis_without_direction_raises() -> None:
    with pytest.raises(ValueError, match="no direction"):
        tf.quaternion_about_axis(1, (0, 0, 0))


def test_euler_angles_without_transforms3d_raise_with_the_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "transforms3d.euler", None)
    with pytest.raises(ImportError, match=r"tfloom\[transformations\]"):
        tf.quaternion_from_euler(1, 2, 3)


AXES = [
    frame + "".join(axes)
    for frame in "sr"
    for axes in product("xyz", repeat=3)
    if axes[0] != axes[1] != axes[2]
]


def test_there_are_24_sequences_of_axes() -> None:
    assert len(AXES) == 24


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

    @pytest.mark.parametrize("axes", AXES)
    def test_every_sequence_of_axes(self, axes: str) -> None:
        """By definition: a product of three rotations, static axes from the right, rotating ones from the left."""
        for given_angles in [
            (0.1, 0.2, 0.3),
            (1.0, 0.5, -1.2),
            (-3.0, 1.5, 3.1),
            (0.4, math.pi / 2, 0.3),
            (1, 0, 2),
        ]:
            turns = [
                tf.rotation_matrix(angle, np.identity(3)["xyz".index(axis)])
                for angle, axis in zip(given_angles, axes[1:], strict=True)
            ]
            expected = tf.concatenate_matrices(*(turns if axes[0] == "r" else turns[::-1]))
            matrix = tf.euler_matrix(*given_angles, axes)
            assert np.allclose(matrix, expected)
            assert np.allclose(tf.euler_matrix(*tf.euler_from_matrix(matrix, axes), axes), expected)
            quaternion = tf.quaternion_from_euler(*given_angles, axes)
            assert np.allclose(tf.quaternion_matrix(quaternion), expected)
            assert np.allclose(tf.euler_matrix(*tf.euler_from_quaternion(quaternion, axes), axes), expected)

    def test_axes_as_numbers(self) -> None:
        """First axis, parity, repetition of the first axis, rotating axes."""
        assert np.allclose(tf.euler_matrix(1, 2, 3, (0, 1, 0, 1)), tf.euler_matrix(1, 2, 3, "ryzx"))
        assert np.allclose(np.sum(tf.euler_matrix(1, 2, 3, (0, 1, 0, 1))[0]), -0.383436184)

    def test_numbers_of_the_reference(self) -> None:
        assert np.allclose(np.sum(tf.euler_matrix(1, 2, 3, "syxz")[0]), -1.34786452)
        assert np.allclose(
            tf.quaternion_from_euler(1, 2, 3, "ryxz"), [0.310622, -0.718287, 0.444435, 0.435953]
        )
        assert np.allclose(tf.euler_from_quaternion([0.06146124, 0, 0, 0.99810947]), [0.123, 0, 0])

    def test_compose(self) -> None:
        matrix = tf.compose_matrix((1, 2, 3), (0.1, 0, 0.2), (0.1, 0.2, 0.3), (4, 5, 6))
        scale, shear, turned, translate, perspective = tf.decompose_matrix(matrix)
        assert np.allclose(
            [*scale, *shear, *turned, *translate], [1, 2, 3, 0.1, 0, 0.2, 0.1, 0.2, 0.3, 4, 5, 6]
        )
        assert perspective.tolist() == [0, 0, 0, 1]
        assert np.allclose(tf.compose_matrix(), np.identity(4))

    @given(st.data())
    def test_decomposing_undoes_composing(self, data: st.DataObject) -> None:
        def draw(count: int, low: float, high: float) -> list[float]:
            return data.draw(st.tuples(*[st.floats(low, high)] * count))

        parts = draw(3, 0.5, 2), draw(3, -0.5, 0.5), draw(3, -1.5, 1.5), draw(3, -5, 5), draw(4, -0.5, 0.5)
        matrix = tf.compose_matrix(*parts)
        for ours, theirs in zip(tf.decompose_matrix(matrix), parts, strict=True):
            assert np.allclose(ours, theirs, atol=1e-6)
        point = np.array([1.0, 2, 3, 1])
        moved = tf.compose_matrix(*parts[:4]) @ point
        assert np.allclose(matrix @ point, [*moved[:3], parts[4] @ moved])

    def test_degenerate_matrix_raises(self) -> None:
        with pytest.raises(ValueError, match="degenerate"):
            tf.decompose_matrix(np.diag([1, 1, 0, 1]))
        with pytest.raises(ValueError):
            tf.quaternion_from_matrix(np.identity(3))

    def test_the_rotation_of_a_matrix_that_scales(self) -> None:
        turned = tf.quaternion_about_axis(0.7, (1, 2, 3))
        assert np.allclose(
            tf.quaternion_from_matrix(tf.quaternion_matrix(turned) @ tf.scale_matrix(2.5)), turned
        )
        rounded = tf.quaternion_matrix(turned).round(3)
        assert np.allclose(tf.quaternion_from_matrix(rounded), turned, atol=1e-3)

    def test_known_sequence(self) -> None:
        """Each of translation, rotation, shear and scale is recovered."""
        shear = tf.shear_matrix(-1.234, (1, 0, 0), (0, 0, 0), (0, 0, 1))
        turned = tf.random_rotation_matrix()
        matrix = tf.concatenate_matrices(
            tf.translation_matrix((1, 2, 3)), turned, shear, tf.scale_matrix(1.23)
        )
        scale, shears, turns, moved, _ = tf.decompose_matrix(matrix)
        assert np.allclose(scale, 1.23)
        assert np.allclose(moved, (1, 2, 3))
        assert np.allclose(shears, (0, math.tan(-1.234), 0))
        assert tf.is_same_transform(turned, tf.euler_matrix(*turns))


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
