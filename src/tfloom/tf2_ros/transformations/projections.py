"""Projections, and matrices fitted to points, by the names of tf_transformations. Matrices are homogeneous, (4, 4)."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tfloom.tf2_ros.transformations.transformations import quaternion_matrix

__all__ = [
    "clip_matrix",
    "orthogonalization_matrix",
    "projection_from_matrix",
    "projection_matrix",
    "superimposition_matrix",
]

Matrix = NDArray[np.float64]

NOTHING = 1e-8
"""Absolute values below this are treated as zero, in a matrix scaled to size one."""


def projection_matrix(
    point: ArrayLike,
    normal: ArrayLike,
    direction: ArrayLike | None = None,
    perspective: ArrayLike | None = None,
    pseudo: bool = False,
) -> Matrix:
    """Return the matrix that projects onto a plane.

    Args:
        point: A point of the plane.
        normal: The plane's normal, of any length but zero.
        direction: Direction of a parallel projection; None: the normal.
        perspective: Viewpoint of a perspective projection; None: the projection is parallel.
        pseudo: Whether a perspective projection keeps relative depth: its result, projected onto the plane along the
            normal, is the perspective projection.

    Raises:
        ValueError: the normal is zero, or the direction lies in the plane.
    """
    place, unit = _three(point), _unit(normal)
    offset = float(place @ unit)
    matrix = np.identity(4)
    if perspective is not None:
        # A point x is mapped to (h + n·(p - x)) x + (n·x - n·p) e, up to scale, with the eye e and h = n·(e - p).
        eye = _three(perspective)
        image = eye + unit if pseudo else eye
        matrix[:3, :3] *= float((eye - place) @ unit)
        matrix[:3, :3] -= np.outer(image, unit)
        matrix[:3, 3] = offset * image
        matrix[3] = *-unit, float(eye @ unit)
        return matrix
    # A point x is moved along the direction d by as much as brings it onto the plane: x + (n·(p - x) / n·d) d.
    along = unit if direction is None else _three(direction)
    share = float(along @ unit)
    if abs(share) <= NOTHING * float(np.linalg.norm(along)):
        raise ValueError("direction lies in the plane: nothing along it meets the plane")
    matrix[:3, :3] -= np.outer(along, unit) / share
    matrix[:3, 3] = along * (offset / share)
    return matrix


def projection_from_matrix(
    matrix: ArrayLike, pseudo: bool = False
) -> tuple[Matrix, Matrix, Matrix | None, Matrix | None, bool]:
    """Return the arguments of `projection_matrix` that result in a matrix.

    Args:
        matrix: The projection, of any scale; of a positive one if `pseudo`.
        pseudo: Whether it keeps relative depth.

    Returns:
        A point of the plane (4,), its unit normal (3,), the unit direction (3,) of a parallel projection if it isn't
        the normal, the viewpoint (3,) of a perspective projection, and `pseudo`, False for a parallel one.

    Raises:
        ValueError: the matrix is not a projection.
    """
    scaled_matrix = np.asarray(matrix, np.float64)
    scaled_matrix = scaled_matrix / np.abs(scaled_matrix).max()
    if pseudo and np.linalg.norm(scaled_matrix[3, :3]) > NOTHING:
        return _pseudo_parts(scaled_matrix)
    # The plane is the matrix's range, and the direction or the eye is its null space.
    outputs, sizes, inputs = np.linalg.svd(scaled_matrix)
    plane, lost = outputs[:, 3], inputs[3]
    if sizes[3] > NOTHING or sizes[2] <= NOTHING or np.linalg.norm(plane[:3]) <= NOTHING:
        raise ValueError("the matrix is not a projection: it doesn't take all of space to one plane")
    length = float(np.linalg.norm(plane[:3]))
    normal = plane[:3] / length
    point = np.append(-plane[3] / length * normal, 1.0)
    direction = perspective = None
    if abs(lost[3]) > NOTHING:
        perspective = lost[:3] / lost[3]
    else:
        unit = lost[:3] / np.linalg.norm(lost[:3])
        direction = None if np.linalg.norm(np.cross(unit, normal)) <= NOTHING else unit
    _require_same(scaled_matrix, projection_matrix(point, normal, direction, perspective))
    return point, normal, direction, perspective, False


def _pseudo_parts(matrix: Matrix) -> tuple[Matrix, Matrix, None, Matrix, bool]:
    # The last row is (-n, e·n); the trace of the rest is 3 h - e·n - 1, with the eye's height h = n·(e - p).
    matrix = matrix / np.linalg.norm(matrix[3, :3])
    normal = -matrix[3, :3]
    height = (float(np.trace(matrix[:3, :3])) + matrix[3, 3] + 1) / 3
    perspective: Matrix = (height * np.identity(3) - np.outer(normal, normal) - matrix[:3, :3]) @ normal
    point = np.append((matrix[3, 3] - height) * normal, 1.0)
    _require_same(matrix, projection_matrix(point, normal, None, perspective, pseudo=True))
    return point, normal, None, perspective, True


def _require_same(matrix: Matrix, rebuilt_matrix: Matrix) -> None:
    scale = float((matrix * rebuilt_matrix).sum() / (rebuilt_matrix * rebuilt_matrix).sum())
    if not np.allclose(matrix, scale * rebuilt_matrix, rtol=0, atol=1e-6):
        raise ValueError("the matrix is not a projection: it moves points within the plane")


def clip_matrix(
    left: float, right: float, bottom: float, top: float, near: float, far: float, perspective: bool = False
) -> Matrix:
    """Return the matrix from a view's volume, a box, to coordinates from -1 to 1.

    With `perspective` the volume is a truncated pyramid: the eye is at the origin, its view is along z, and the
    bounds of x and y are those at `near`. The product must then be divided by its last element.

    Raises:
        ValueError: the bounds are not in order, or `near` is not in front of the eye.
    """
    low, high = np.array([left, bottom, near], np.float64), np.array([right, top, far], np.float64)
    if not (low < high).all():
        raise ValueError("invalid frustrum: left < right, bottom < top and near < far must hold")
    if perspective and near <= np.finfo(float).eps * 4:
        raise ValueError("invalid frustrum: near <= 0")
    size, middle = high - low, (high + low) / (high - low)
    matrix = np.zeros((4, 4))
    if not perspective:
        matrix[:3, :3] = np.diag(2 / size)
        matrix[:3, 3] = -middle
        matrix[3, 3] = 1
        return matrix
    matrix[:2, :2] = np.diag(-2 * near / size[:2])
    matrix[:3, 2] = *middle[:2], -middle[2]
    matrix[2, 3] = 2 * near * far / size[2]
    matrix[3, 2] = -1
    return matrix


def orthogonalization_matrix(lengths: ArrayLike, angles: ArrayLike) -> Matrix:
    """Return the matrix from a crystal cell's coordinates to Cartesian ones; its inverse converts back.

    Args:
        lengths: Lengths of the cell's edges a, b, c.
        angles: Angles between b and c, c and a, a and b [degrees].
    """
    a, b, c = (float(value) for value in np.asarray(lengths, np.float64))
    alpha, beta, gamma = np.radians(np.asarray(angles, np.float64))
    # The cosine of the angle between the planes through a and c, and b and c; c points along z, b lies in y and z.
    turned = (math.cos(alpha) * math.cos(beta) - math.cos(gamma)) / (math.sin(alpha) * math.sin(beta))
    if abs(turned) > 1:
        raise ValueError("no cell has these angles: each must be less than the other two together")
    matrix = np.identity(4)
    matrix[:3, 0] = np.array(
        [math.sin(beta) * math.sqrt(1 - turned**2), -math.sin(beta) * turned, math.cos(beta)]
    )
    matrix[:3, 0] *= a
    matrix[:3, 1] = 0, b * math.sin(alpha), b * math.cos(alpha)
    matrix[:3, 2] = 0, 0, c
    return matrix


def superimposition_matrix(
    v0: ArrayLike, v1: ArrayLike, scaling: bool = False, usesvd: bool = True
) -> Matrix:
    """Return the rigid transform of one set of points onto another, with the least sum of squared distances.

    Args:
        v0: Points as columns, (3, N) or (4, N), N ≥ 3.
        v1: The corresponding target points, of the same shape.
        scaling: Whether to scale them too, uniformly.
        usesvd: By singular values (Kabsch), else by the greatest eigenvector of a quaternion form (Horn).

    Raises:
        ValueError: the two differ in shape, or hold fewer than three points.
    """
    first, second = np.asarray(v0, np.float64)[:3], np.asarray(v1, np.float64)[:3]
    if first.ndim != 2 or first.shape != second.shape or first.shape[0] != 3 or first.shape[1] < 3:
        raise ValueError(
            f"v0 and v1 must both be of shape (3, N) or (4, N), N ≥ 3, not {np.shape(v0)} and {np.shape(v1)}"
        )
    start, end = first.mean(axis=1), second.mean(axis=1)
    first, second = first - start[:, np.newaxis], second - end[:, np.newaxis]
    matrix = _turn_by_svd(second @ first.T) if usesvd else _turn_by_quaternion(second @ first.T)
    if scaling:
        matrix[:3, :3] *= math.sqrt((second**2).sum() / (first**2).sum())
    matrix[:3, 3] = end - matrix[:3, :3] @ start
    return matrix


def _turn_by_svd(correlation: Matrix) -> Matrix:
    left, _, right = np.linalg.svd(correlation)
    left[:, 2] *= math.copysign(1, np.linalg.det(left) * np.linalg.det(right))  # not a reflection
    matrix = np.identity(4)
    matrix[:3, :3] = left @ right
    return matrix


def _turn_by_quaternion(correlation: Matrix) -> Matrix:
    # The unit quaternion q of greatest qᵀ K q.
    trace = np.trace(correlation)
    form = np.empty((4, 4))
    form[:3, :3] = correlation + correlation.T - trace * np.identity(3)
    form[3, :3] = form[:3, 3] = [
        correlation[2, 1] - correlation[1, 2],
        correlation[0, 2] - correlation[2, 0],
        correlation[1, 0] - correlation[0, 1],
    ]
    form[3, 3] = trace
    return quaternion_matrix(np.linalg.eigh(form)[1][:, -1])


def _three(vector: ArrayLike) -> Matrix:
    return np.asarray(vector, np.float64)[:3]


def _unit(normal: ArrayLike) -> Matrix:
    vector = _three(normal)
    length = float(np.linalg.norm(vector))
    if not length > 0:
        raise ValueError("normal has no direction: it's zero, or not finite")
    return vector / length
