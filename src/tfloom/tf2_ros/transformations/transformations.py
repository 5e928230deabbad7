"""Functions for rotations and matrices, by tf_transformations' names, on numpy and, for some, transforms3d.

Quaternions are (x, y, z, w). Matrices are homogeneous, (4, 4). Angles are in radians. Axes of Euler angles are four
letters: `s` for static or `r` for rotating axes, then the three axes: `sxyz` is roll, pitch, yaw.

The other functions of tf_transformations are in `projections` and `arcball`.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tfloom.common.text import given_text
from tfloom.tf2.transform import Transform

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "compose_matrix",
    "concatenate_matrices",
    "decompose_matrix",
    "euler_from_matrix",
    "euler_from_quaternion",
    "euler_matrix",
    "identity_matrix",
    "inverse_matrix",
    "is_same_transform",
    "quaternion_about_axis",
    "quaternion_conjugate",
    "quaternion_from_euler",
    "quaternion_from_matrix",
    "quaternion_inverse",
    "quaternion_matrix",
    "quaternion_multiply",
    "quaternion_slerp",
    "random_quaternion",
    "random_rotation_matrix",
    "random_vector",
    "reflection_from_matrix",
    "reflection_matrix",
    "rotation_from_matrix",
    "rotation_matrix",
    "scale_from_matrix",
    "scale_matrix",
    "shear_from_matrix",
    "shear_matrix",
    "translation_from_matrix",
    "translation_matrix",
    "unit_vector",
    "vector_norm",
]

Matrix = NDArray[np.float64]


def _transforms3d(module: str) -> ModuleType:
    from importlib import import_module

    try:
        return import_module(f"transforms3d.{module}")
    except ImportError as error:
        raise ImportError(
            "Euler angles, reflections, scales and shears need transforms3d: pip install 'tfloom[transformations]'"
        ) from error


def identity_matrix() -> Matrix:
    """Return the identity matrix."""
    return np.identity(4)


def translation_matrix(direction: ArrayLike) -> Matrix:
    """Return the matrix of a translation by a vector."""
    matrix = np.identity(4)
    matrix[:3, 3] = np.asarray(direction)[:3]
    return matrix


def translation_from_matrix(matrix: ArrayLike) -> Matrix:
    """Return the translation vector of a matrix."""
    vector: Matrix = np.array(matrix, np.float64)[:3, 3].copy()
    return vector


def inverse_matrix(matrix: ArrayLike) -> Matrix:
    """Return the inverse of a matrix; LinAlgError if it is singular."""
    inverse: Matrix = np.linalg.inv(np.asarray(matrix, np.float64))
    return inverse


def concatenate_matrices(*matrices: ArrayLike) -> Matrix:
    """Return the product of matrices, from left to right."""
    product = np.identity(4)
    for matrix in matrices:
        product = product @ np.asarray(matrix, np.float64)
    return product


def is_same_transform(matrix0: ArrayLike, matrix1: ArrayLike) -> bool:
    """Return whether two matrices are equal up to a common factor."""
    first, second = np.asarray(matrix0, np.float64), np.asarray(matrix1, np.float64)
    return bool(np.allclose(first / first[3, 3], second / second[3, 3]))


def rotation_matrix(angle: float, direction: ArrayLike, point: ArrayLike | None = None) -> Matrix:
    """Return the matrix of a rotation by `angle` about an axis through `point`, or through the origin."""
    axis = [float(value) for value in np.asarray(direction, np.float64)[:3]]
    matrix = np.asarray(Transform.from_axis_angle(axis, angle).rows(), np.float64)
    if point is not None:
        place = np.asarray(point, np.float64)[:3]
        matrix[:3, 3] = place - matrix[:3, :3] @ place
    return matrix


def rotation_from_matrix(matrix: ArrayLike) -> tuple[float, Matrix, Matrix]:
    """Return angle, unit axis, and a point of the axis (4,) of a rotation matrix.

    Raises:
        ValueError: the matrix is not a rotation.
    """
    values = np.asarray(matrix, np.float64)
    axis, angle = Transform.from_matrix(values).axis_angle
    # The point is a fixed point of the matrix: (I - R) p = t, whose least-norm solution is nearest to the origin.
    point, *_ = np.linalg.lstsq(np.identity(3) - values[:3, :3], values[:3, 3], rcond=1e-9)
    if not np.allclose(values[:3, :3] @ point + values[:3, 3], point, atol=1e-6):
        raise ValueError("the matrix moves along its axis, so it is not a rotation about a point")
    return angle, np.array(axis), np.append(point, 1.0)


def quaternion_matrix(quaternion: ArrayLike) -> Matrix:
    """Return the rotation matrix of a quaternion of any length; the identity for zero."""
    return _rotation_matrix(_four(quaternion))


def quaternion_from_matrix(matrix: ArrayLike) -> Matrix:
    """Return the unit quaternion of a matrix's rotation, w ≥ 0; scale and shear are removed by decomposition.

    Raises:
        ValueError: the matrix has no rotation.
    """
    affine = np.array(matrix, np.float64)
    try:
        rotation = Transform.from_matrix(affine)
    except ValueError:
        if affine.shape != (4, 4):
            raise
        affine[:3, :3] = _transforms3d("affines").decompose(affine)[1]
        rotation = Transform.from_matrix(affine)
    q = np.array(rotation.rotation_xyzw)
    return -q if q[3] < 0 else q


def quaternion_multiply(quaternion1: ArrayLike, quaternion0: ArrayLike) -> Matrix:
    """Return the product `quaternion1 * quaternion0`."""
    x1, y1, z1, w1 = _four(quaternion1)
    x0, y0, z0, w0 = _four(quaternion0)
    return np.array(
        [
            w1 * x0 + x1 * w0 + y1 * z0 - z1 * y0,
            w1 * y0 - x1 * z0 + y1 * w0 + z1 * x0,
            w1 * z0 + x1 * y0 - y1 * x0 + z1 * w0,
            w1 * w0 - x1 * x0 - y1 * y0 - z1 * z0,
        ]
    )


def quaternion_conjugate(quaternion: ArrayLike) -> Matrix:
    """Return the conjugate, which is the inverse of a unit quaternion."""
    x, y, z, w = _four(quaternion)
    return np.array([-x, -y, -z, w])


def quaternion_inverse(quaternion: ArrayLike) -> Matrix:
    """Return the inverse of a quaternion of any length but zero."""
    q = np.array(_four(quaternion))
    return quaternion_conjugate(q) / float(q @ q)


def quaternion_about_axis(angle: float, axis: ArrayLike) -> Matrix:
    """Return the unit quaternion of a rotation by `angle` about `axis`."""
    unit = np.asarray(axis, np.float64)[:3]
    length = np.linalg.norm(unit)
    if not length > 0:
        raise ValueError("axis has no direction: it's zero, or not finite")
    return np.append(math.sin(angle / 2) / length * unit, math.cos(angle / 2))


def quaternion_slerp(
    quat0: ArrayLike, quat1: ArrayLike, fraction: float, spin: int = 0, shortestpath: bool = True
) -> Matrix:
    """Return the spherical linear interpolation from one quaternion (fraction 0) to another (fraction 1).

    A fraction below 0 or above 1 extrapolates. `spin` adds half turns; without `shortestpath` the arc may be the
    longer one.
    """
    first: Matrix = unit_vector(_four(quat0))
    second: Matrix = unit_vector(_four(quat1))
    if fraction in (0.0, 1.0):
        return second if fraction == 1.0 else first
    if shortestpath and float(first @ second) < 0:
        second = -second
    angle = 2 * math.atan2(float(np.linalg.norm(first - second)), float(np.linalg.norm(first + second)))
    if spin % 2:  # after another half turn, the quaternion is that of the same rotation with the other sign
        second = -second
    angle += spin * math.pi
    sine = math.sin(angle)
    if abs(sine) < np.finfo(float).eps * 4:
        return first
    mixed: Matrix = (math.sin((1 - fraction) * angle) * first + math.sin(fraction * angle) * second) / sine
    return mixed


def euler_matrix(ai: float, aj: float, ak: float, axes: str = "sxyz") -> Matrix:
    """Return the matrix of Euler angles."""
    matrix = np.identity(4)
    matrix[:3, :3] = _transforms3d("euler").euler2mat(ai, aj, ak, axes)
    return matrix


def euler_from_matrix(matrix: ArrayLike, axes: str = "sxyz") -> tuple[float, float, float]:
    """Return the Euler angles of a matrix's rotation."""
    return _angles(_transforms3d("euler").mat2euler(np.asarray(matrix, np.float64)[:3, :3], axes))


def euler_from_quaternion(quaternion: ArrayLike, axes: str = "sxyz") -> tuple[float, float, float]:
    """Return the Euler angles of a quaternion."""
    return euler_from_matrix(_rotation_matrix(_four(quaternion)), axes)


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: str = "sxyz") -> Matrix:
    """Return the unit quaternion of Euler angles."""
    w, x, y, z = _transforms3d("euler").euler2quat(ai, aj, ak, axes)
    return np.array([x, y, z, w])


def reflection_matrix(point: ArrayLike, normal: ArrayLike) -> Matrix:
    """Return the matrix of a reflection at the plane through a point."""
    return np.asarray(_transforms3d("reflections").rfnorm2aff(_three(normal), _three(point)), np.float64)


def reflection_from_matrix(matrix: ArrayLike) -> tuple[Matrix, Matrix]:
    """Return a point of a reflection's plane (4,) and its normal (3,); ValueError if it is not a reflection."""
    normal, point = _transforms3d("reflections").aff2rfnorm(np.asarray(matrix, np.float64))
    return np.append(point, 1.0), normal


def scale_matrix(
    factor: float, origin: ArrayLike | None = None, direction: ArrayLike | None = None
) -> Matrix:
    """Return the matrix that scales about an origin, in one direction or in all; factor -1 is a point reflection."""
    parts = [None if part is None else _three(part) for part in (direction, origin)]
    return np.asarray(_transforms3d("zooms").zfdir2aff(factor, *parts), np.float64)


def scale_from_matrix(matrix: ArrayLike) -> tuple[float, Matrix, Matrix | None]:
    """Return a scale's factor, origin (4,) and direction (3,), None for all; ValueError if it is not a scale."""
    factor, direction, origin = _transforms3d("zooms").aff2zfdir(np.asarray(matrix, np.float64))
    return float(factor), np.append(origin, 1.0), direction


def shear_matrix(angle: float, direction: ArrayLike, point: ArrayLike, normal: ArrayLike) -> Matrix:
    """Return the matrix of a shear along a direction in the plane through a point; ValueError if it isn't in it."""
    parts = _three(direction), _three(normal), _three(point)
    if abs(np.dot(parts[0], parts[1])) > 1e-6 * vector_norm(parts[0]) * vector_norm(parts[1]):
        raise ValueError("direction must lie in the plane: it isn't at right angles to normal")
    return np.asarray(_transforms3d("shears").sadn2aff(angle, *parts), np.float64)


def shear_from_matrix(matrix: ArrayLike) -> tuple[float, Matrix, Matrix, Matrix]:
    """Return a shear's angle, direction (3,), plane point (4,) and normal (3,); ValueError if it is not a shear."""
    angle, direction, normal, point = _transforms3d("shears").aff2sadn(np.asarray(matrix, np.float64))
    return float(angle), direction, np.append(point, 1.0), normal


def compose_matrix(
    scale: ArrayLike | None = None,
    shear: ArrayLike | None = None,
    angles: ArrayLike | None = None,
    translate: ArrayLike | None = None,
    perspective: ArrayLike | None = None,
) -> Matrix:
    """Return the matrix that shears, scales, rotates by static-axis Euler angles, translates, projects, in this order.

    `perspective` is the last row (4,) of the projection.
    """
    matrix = _transforms3d("affines").compose(
        np.zeros(3) if translate is None else np.asarray(translate, np.float64)[:3],
        np.identity(3) if angles is None else euler_matrix(*np.asarray(angles, np.float64))[:3, :3],
        np.ones(3) if scale is None else np.asarray(scale, np.float64),
        np.zeros(3) if shear is None else np.asarray(shear, np.float64),
    )
    if perspective is None:
        return np.asarray(matrix, np.float64)
    projection = np.identity(4)
    projection[3, :] = np.asarray(perspective, np.float64)[:4]
    projected: Matrix = projection @ matrix
    return projected


def decompose_matrix(matrix: ArrayLike) -> tuple[Matrix, Matrix, tuple[float, float, float], Matrix, Matrix]:
    """Return scale, shear, static-axis Euler angles, translation and perspective, as `compose_matrix` takes them.

    Raises:
        ValueError: the matrix is degenerate.
    """
    values = np.asarray(matrix, np.float64)
    affine = values.copy()
    affine[3, :] = 0.0, 0.0, 0.0, 1.0
    if np.linalg.matrix_rank(affine) < 4:
        raise ValueError("the matrix is degenerate: it takes space to a plane, a line or a point")
    perspective: Matrix = values[3] @ np.linalg.inv(affine)
    translate, turn, scale, shear = _transforms3d("affines").decompose(affine)
    return scale, shear, _angles(_transforms3d("euler").mat2euler(turn)), translate, perspective


def random_quaternion(rand: ArrayLike | None = None) -> Matrix:
    """Return a unit quaternion, uniform over all rotations; computed from three numbers in [0, 1] if given."""
    # K. Shoemake, "Uniform random rotations", Graphics Gems III, 1992.
    u, v, w = np.random.default_rng().random(3) if rand is None else np.asarray(rand, np.float64)
    inner, outer = math.sqrt(1 - u), math.sqrt(u)
    first, second = 2 * math.pi * v, 2 * math.pi * w
    return np.array(
        [inner * math.sin(first), inner * math.cos(first), outer * math.sin(second), outer * math.cos(second)]
    )


def random_rotation_matrix(rand: ArrayLike | None = None) -> Matrix:
    """Return the matrix of `random_quaternion`."""
    return quaternion_matrix(random_quaternion(rand))


def random_vector(size: int | tuple[int, ...]) -> Matrix:
    """Return an array of random numbers in [0, 1)."""
    return np.random.default_rng().random(size)


def vector_norm(data: ArrayLike, axis: int | None = None, out: Matrix | None = None) -> Any:
    """Return the length of a vector, or of each along an axis; None if it is written to `out`."""
    values = np.asarray(data, np.float64)
    if out is None:
        return np.sqrt((values * values).sum(axis=axis))
    np.sqrt(np.sum(values * values, axis=axis, out=out), out=out)
    return None


def unit_vector(data: ArrayLike, axis: int | None = None, out: Matrix | None = None) -> Any:
    """Return the normalized vector, or each along an axis; None if it is written to `out`."""
    values = np.asarray(data, np.float64)
    length = np.sqrt((values * values).sum(axis=axis))
    unit: Matrix = np.divide(values, length if axis is None else np.expand_dims(length, axis), out=out)
    return unit if out is None else None


def _three(vector: ArrayLike) -> Matrix:
    return np.asarray(vector, np.float64)[:3]


def _four(quaternion: ArrayLike) -> tuple[float, float, float, float]:
    try:
        x, y, z, w = np.asarray(quaternion, np.float64).tolist()
    except (TypeError, ValueError) as error:
        meant = ": write [q.x, q.y, q.z, q.w]" if hasattr(quaternion, "w") else ""
        given = given_text(quaternion)
        raise type(error)(f"a quaternion is four numbers x, y, z, w, got {given}{meant}") from None
    return x, y, z, w


def _rotation_matrix(q: tuple[float, float, float, float]) -> Matrix:
    return np.identity(4) if not any(q) else np.asarray(Transform((0.0, 0.0, 0.0), q).rows(), np.float64)


def _angles(values: Any) -> tuple[float, float, float]:
    first, second, third = (float(value) for value in values)
    return first, second, third
