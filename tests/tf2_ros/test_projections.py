"""Projections, fits and the trackball of tf_transformations, by their effect on points."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tfloom.tf2_ros.transformations import arcball, projections
from tfloom.tf2_ros.transformations import transformations as tf

points = st.tuples(*[st.floats(-5, 5)] * 3).map(np.array)
directions = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 0.1).map(np.array)
CUBE = np.array([[x, y, z, 1.0] for x in (-1, 1) for y in (-2, 2) for z in (-3, 3)]).T


def seen(matrix: np.ndarray, point: np.ndarray) -> np.ndarray:
    x, y, z, w = matrix @ [*point, 1]
    return np.array([x, y, z]) / w


def height(point: np.ndarray, plane: np.ndarray, normal: np.ndarray) -> float:
    return float((point - plane) @ normal / np.linalg.norm(normal))


@given(points, directions, directions, points)
def test_parallel_projection_maps_along_its_direction_to_the_plane(
    plane: np.ndarray, normal: np.ndarray, direction: np.ndarray, point: np.ndarray
) -> None:
    assume(abs(tf.unit_vector(normal) @ tf.unit_vector(direction)) > 0.1)
    for along, matrix in (
        (direction, projections.projection_matrix(plane, normal, direction)),
        (normal, projections.projection_matrix(plane, normal)),
    ):
        shadow = seen(matrix, point)
        assert height(shadow, plane, normal) == pytest.approx(0, abs=1e-9)
        assert np.allclose(np.cross(shadow - point, along), 0, atol=1e-7)
        assert np.allclose(matrix @ matrix, matrix, atol=1e-7)
        again = projections.projection_matrix(*projections.projection_from_matrix(-3 * matrix))
        assert np.allclose(again, matrix, atol=1e-6)


@given(points, directions, points, points)
def test_perspective_projection_maps_along_the_line_of_sight(
    plane: np.ndarray, normal: np.ndarray, eye: np.ndarray, point: np.ndarray
) -> None:
    assume(abs(height(eye, plane, normal)) > 0.1)
    assume(abs(height(eye, point, normal)) > 0.1)
    matrix = projections.projection_matrix(plane, normal, perspective=eye)
    shadow = seen(matrix, point)
    assert height(shadow, plane, normal) == pytest.approx(0, abs=1e-6)
    assert np.allclose(np.cross(shadow - eye, point - eye), 0, atol=1e-5)
    flat = projections.projection_matrix(plane, normal)
    deep = projections.projection_matrix(plane, normal, perspective=eye, pseudo=True)
    assert np.allclose(flat @ deep, matrix)
    for projection, pseudo in ((matrix, False), (deep, True)):
        parts = projections.projection_from_matrix(2 * projection, pseudo)
        assert np.allclose(parts[3], eye, atol=1e-5)
        again = projections.projection_matrix(*parts)
        scale = (projection * again).sum() / (again * again).sum()
        assert np.allclose(scale * again, projection, atol=1e-5)


def test_known_projections() -> None:
    assert projections.projection_matrix((0, 0, 0), (1, 0, 0)).tolist() == np.diag([0.0, 1, 1, 1]).tolist()
    skew = projections.projection_matrix((3, 0, 0), (1, 1, 0), (1, 0, 0))
    assert np.allclose(seen(skew, np.array([7.0, 5, 9])), [-2, 5, 9])
    point, normal, direction, perspective, pseudo = projections.projection_from_matrix(
        projections.projection_matrix((0, 0, 2), (0, 0, 5))
    )
    assert (point.tolist(), np.abs(normal).tolist()) == ([0, 0, 2, 1], [0, 0, 1])
    assert (direction, perspective, pseudo) == (None, None, False)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: projections.projection_matrix((0, 0, 0), (0, 0, 0)), "normal has no direction"),
        (
            lambda: projections.projection_matrix((0, 0, 0), (0, 0, 1), (1, 0, 0)),
            "direction lies in the plane",
        ),
        (lambda: projections.projection_from_matrix(np.identity(4)), "not a projection"),
        (lambda: projections.projection_from_matrix(np.diag([0, 0, 1, 1])), "not a projection"),
        (lambda: projections.projection_from_matrix(np.diag([0, 2, 1, 1])), "moves points within the plane"),
        (lambda: projections.clip_matrix(1, 0, 0, 1, 1, 2), "invalid frustrum"),
        (lambda: projections.clip_matrix(0, 1, 0, 1, 0, 2, perspective=True), "near <= 0"),
        (
            lambda: projections.orthogonalization_matrix((1, 1, 1), (120, 120, 130)),
            "no cell has these angles",
        ),
        (lambda: projections.superimposition_matrix(np.zeros((3, 2)), np.zeros((3, 2))), r"not \(3, 2\) and"),
        (
            lambda: projections.superimposition_matrix(np.zeros((3, 4)), np.zeros((3, 5))),
            r"\(3, 4\) and \(3, 5\)",
        ),
        (lambda: arcball.Arcball([1, 2, 3]), "initial not a quaternion or matrix"),
    ],
)
def test_invalid_arguments_raise(call: object, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        call()


def test_clip_matrix_maps_the_corners_to_one() -> None:
    low, high = np.array([-1.0, 2, 3]), np.array([4.0, 6, 10])
    bounds = (-1, 4, 2, 6, 3, 10)
    box = projections.clip_matrix(*bounds)
    assert np.allclose(seen(box, low), -1)
    assert np.allclose(seen(box, high), 1)
    pyramid = projections.clip_matrix(*bounds, perspective=True)
    assert np.allclose(seen(pyramid, low), -1)
    assert np.allclose(seen(pyramid, np.array([4, 6, 3])), [1, 1, -1])
    assert np.allclose(seen(pyramid, np.array([4, 6, 3]) * 10 / 3), 1)


def test_crystal_cells() -> None:
    assert np.allclose(
        projections.orthogonalization_matrix((10, 10, 10), (90, 90, 90)), np.diag([10, 10, 10, 1])
    )
    lengths, angles = np.array([9.8, 12.0, 15.5]), np.array([87.2, 80.7, 69.7])
    matrix = projections.orthogonalization_matrix(lengths, angles)
    assert matrix.sum() == pytest.approx(43.063229)
    edges = matrix[:3, :3].T
    assert np.linalg.norm(edges, axis=1) == pytest.approx(lengths)
    units = edges / lengths[:, np.newaxis]
    cosines = [units[1] @ units[2], units[2] @ units[0], units[0] @ units[1]]
    assert np.degrees(np.arccos(cosines)) == pytest.approx(angles)


@pytest.mark.parametrize("usesvd", [True, False])
@pytest.mark.parametrize("rows", [3, 4])
def test_superimposition_recovers_rotation_translation_and_scale(usesvd: bool, rows: int) -> None:
    random = np.random.default_rng(3)
    for scale in (1.0, 0.3, 7.0):
        matrix = tf.translation_matrix(random.normal(size=3)) @ tf.random_rotation_matrix(random.random(3))
        matrix[:3, :3] *= scale
        start = np.vstack((random.normal(size=(3, 50)), np.ones(50)))
        end = matrix @ start
        found = projections.superimposition_matrix(start[:rows], end[:rows], scale != 1, usesvd)
        assert np.allclose(found, matrix)
    mirrored = start * [[-1], [1], [1], [1]]
    found = projections.superimposition_matrix(start, mirrored, usesvd=usesvd)
    assert np.linalg.det(found) == pytest.approx(1)  # a rotation, not a reflection
    assert np.allclose(projections.superimposition_matrix(CUBE, CUBE), np.identity(4))


def test_superimposition_has_the_least_squared_error() -> None:
    random = np.random.default_rng(4)
    start, end = random.normal(size=(2, 3, 20))
    found = projections.superimposition_matrix(start, end)
    assert np.allclose(found, projections.superimposition_matrix(start, end, usesvd=False))

    def error(matrix: np.ndarray) -> float:
        return float(((matrix[:3, :3] @ start + matrix[:3, 3:] - end) ** 2).sum())

    for _ in range(20):
        nudge = tf.rotation_matrix(1e-3, random.normal(size=3)) @ tf.translation_matrix(
            1e-3 * random.normal(size=3)
        )
        assert error(nudge @ found) > error(found)


def test_trackball_rotates_with_the_drag() -> None:
    ball = arcball.Arcball(initial=np.identity(4))
    ball.place([320, 320], 320)
    ball.down([500, 250])
    ball.drag([475, 275])
    assert ball.matrix().sum() == pytest.approx(3.90583455)
    first = ball.matrix()
    ball.next()
    assert np.allclose(ball.matrix(), first @ first)
    ball.drag([500, 250])
    assert np.allclose(ball.matrix(), np.identity(4))


def test_trackball_rotates_by_twice_the_angle() -> None:
    ball = arcball.Arcball()
    ball.place([0, 0], 1)
    ball.down([0, 0])
    ball.drag([0.5, 0])  # 30° on the sphere, to the right: about y, towards x
    assert np.allclose(ball.matrix(), tf.rotation_matrix(np.pi / 3, (0, 1, 0)))
    assert np.allclose(arcball.arcball_map_to_sphere([3, -4], [0, 0], 1), [0.6, 0.8, 0])


def test_trackball_can_be_constrained_to_axes() -> None:
    ball = arcball.Arcball(initial=[0, 0, 0, 1])
    ball.place([320, 320], 320)
    ball.setaxes([1, 1, 0], [-1, 1, 0])
    assert not ball.getconstrain()
    ball.setconstrain(True)
    assert ball.getconstrain()
    ball.down([400, 200])
    ball.drag([200, 400])
    assert ball.matrix().sum() == pytest.approx(0.2055924)
    _, axis, _ = tf.rotation_from_matrix(ball.matrix())
    assert np.allclose(np.abs(axis), [np.sqrt(0.5), np.sqrt(0.5), 0])
    ball.setaxes()
    ball.down([400, 200])
    ball.drag([200, 410])
    assert not np.allclose(np.abs(tf.rotation_from_matrix(ball.matrix())[1]), [np.sqrt(0.5), np.sqrt(0.5), 0])


def test_points_on_an_axis_are_constrained_to_a_point_of_the_circle() -> None:
    assert arcball.arcball_constrain_to_axis([0, 0, 1], [0, 0, 1]).tolist() == [1, 0, 0]
    assert arcball.arcball_constrain_to_axis([1, 0, 0], [1, 0, 0]).tolist() == [0, 1, 0]
    assert arcball.arcball_nearest_axis([0, 0.6, 0.8], [[1, 0, 0], [0, 1, 0]]).tolist() == [1, 0, 0]
