"""Find the pose at which a laser's scan fits a map best, near the pose where it is expected."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from occupancy import RESOLUTION_M, OccupancyMap, placed
from planar import Pose2D, turned

REACH_CELLS = 3
"""Distance from an occupied cell at which a point no longer counts."""
SIGMA_CELLS = 1.5
MIN_POINTS = 30
MIN_FIT = 0.55
"""Part of the points that must lie near occupied cells."""
FLAT = 0.03
"""Smallest part of the walls that has to face another way; with less, they fix the pose in one direction only."""
PRIOR = 0.03
"""How much lower a pose at the edge of the search is rated than the expected one, where the best fit is 1."""


class Search(NamedTuple):
    """Where to search around the expected pose: `reach` cells in steps of `stride`, and angles [rad]."""

    reach: int
    stride: int
    angle: float
    angle_step: float
    max_points: int


NEAR = Search(reach=6, stride=1, angle=0.2, angle_step=0.02, max_points=180)
WIDE = Search(reach=20, stride=2, angle=0.5, angle_step=0.025, max_points=90)


class Match(NamedTuple):
    """The result of a search; the pose is the expected one if the scan does not fit."""

    pose: Pose2D
    fit: float
    """From 0 to 1."""
    problem: str
    """Why the pose, or a part of it, is the expected one; empty if all of it is found."""
    is_found: bool


def match(grid: OccupancyMap, points: np.ndarray, expected: Pose2D, search: Search = NEAR) -> Match:
    """Search the pose of the laser.

    All poses of a raster are compared, coarse and then finer, because a search that only climbs would stay at a wrong
    pose that is better than those beside it.

    Args:
        grid: The map.
        points: Where rays met something (N, 2), in the laser's frame [m].
        expected: The laser's expected pose in the map.
        search: The raster.
    """
    if len(points) < MIN_POINTS:
        return Match(expected, 0.0, f"the laser sees too little: {len(points)} points", False)
    chosen = points[:: -(-len(points) // search.max_points)]
    pad = search.reach + REACH_CELLS + 2
    field = likelihood(grid, pad)
    origin = grid.origin - pad * RESOLUTION_M
    pose = coarse(field, origin, chosen, expected, search)
    # The steps are halved, and the pose moves to the best of its 27 neighbours, itself included.
    step, angle = search.stride * RESOLUTION_M / 2.0, search.angle_step / 2.0
    while step > RESOLUTION_M / 16.0:
        pose = best_neighbour(field, origin, chosen, pose, step, angle)
        step, angle = step / 2.0, angle / 2.0
    values = interpolated(field, origin, placed(pose, chosen))
    fit = float((values > 0.3).mean())
    if fit < MIN_FIT:
        return Match(expected, fit, f"the scan does not fit the map: {100 * fit:.0f} % of its points", False)
    free = free_direction(points)
    if free is None:
        return Match(pose, fit, "", True)
    # In a corridor each place along it fits as well: keep the expected one.
    free = placed(Pose2D(0.0, 0.0, pose.yaw), free[np.newaxis])[0]
    moved = np.array([pose.x - expected.x, pose.y - expected.y])
    moved -= free * (free @ moved)
    pose = Pose2D(expected.x + moved[0], expected.y + moved[1], pose.yaw)
    return Match(pose, fit, "all walls run alike: along them the odometry counts alone", True)


def likelihood(grid: OccupancyMap, pad: int) -> np.ndarray:
    """Return 1 where walls are, less around them, and 0 from `REACH_CELLS` on, with so many more cells at each side."""
    rows, columns = grid.log_odds.shape
    field = np.zeros((rows + 2 * pad, columns + 2 * pad))
    cells, walls = grid.occupied()
    reach = range(-REACH_CELLS, REACH_CELLS + 1)
    for shift in ((dx, dy) for dx in reach for dy in reach):
        # Each occupied cell has one neighbour at this shift, so that none is written twice.
        middles = cells + shift + 0.5
        distance = ((middles - walls) ** 2).sum(axis=1)
        value = np.where(distance < REACH_CELLS**2, np.exp(-distance / (2.0 * SIGMA_CELLS**2)), 0.0)
        column, row = (cells + shift + pad).T
        field[row, column] = np.maximum(field[row, column], value)
    return field


def coarse(
    field: np.ndarray, origin: np.ndarray, points: np.ndarray, expected: Pose2D, search: Search
) -> Pose2D:
    """Return the best pose of the raster. Shifts are whole cells: the points of an angle are converted once."""
    shifts = np.arange(-search.reach, search.reach + 1, search.stride)
    dx, dy = (axis.ravel() for axis in np.meshgrid(shifts, shifts))
    count = round(search.angle / search.angle_step)
    rows, columns = field.shape
    best = (-np.inf, expected)
    for turn in np.arange(-count, count + 1) * search.angle_step:
        turned_pose = Pose2D(expected.x, expected.y, turned(expected.yaw + float(turn)))
        column, row = np.floor((placed(turned_pose, points) - origin) / RESOLUTION_M).astype(np.int64).T
        # A point outside is moved into the margin, where the field is 0 for each shift.
        is_inside = (
            (column >= search.reach)
            & (column < columns - search.reach)
            & (row >= search.reach)
            & (row < rows - search.reach)
        )
        index = (row * columns + column)[is_inside]
        values = field.ravel()[index[:, np.newaxis] + (dy * columns + dx)].sum(axis=0) / len(points)
        distance = (dx**2 + dy**2) / search.reach**2 + (turn / search.angle) ** 2
        scores = values - PRIOR * distance
        place = int(scores.argmax())
        if scores[place] > best[0]:
            x = expected.x + float(dx[place]) * RESOLUTION_M
            y = expected.y + float(dy[place]) * RESOLUTION_M
            best = (float(scores[place]), Pose2D(x, y, turned_pose.yaw))
    return best[1]


def best_neighbour(
    field: np.ndarray, origin: np.ndarray, points: np.ndarray, pose: Pose2D, step: float, angle: float
) -> Pose2D:
    neighbours = [
        Pose2D(pose.x + i * step, pose.y + j * step, turned(pose.yaw + k * angle))
        for i in (0, -1, 1)
        for j in (0, -1, 1)
        for k in (0, -1, 1)
    ]
    cloud = np.stack([placed(neighbour, points) for neighbour in neighbours])
    return neighbours[int(interpolated(field, origin, cloud).sum(axis=1).argmax())]


def interpolated(field: np.ndarray, origin: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return the field at points (..., 2), between the centres of its cells; outside as at its edge, which is 0."""
    place = (points - origin) / RESOLUTION_M - 0.5
    rows, columns = field.shape
    place = np.clip(place, 0.0, (columns - 1.001, rows - 1.001))
    cell = place.astype(np.int64)
    u, v = np.moveaxis(place - cell, -1, 0)
    column, row = np.moveaxis(cell, -1, 0)
    low = field[row, column] * (1.0 - u) + field[row, column + 1] * u
    high = field[row + 1, column] * (1.0 - u) + field[row + 1, column + 1] * u
    return low * (1.0 - v) + high * v


def free_direction(points: np.ndarray) -> np.ndarray | None:
    """Return the direction (2,) along which all walls run; None where they don't run alike.

    Points that neighbouring rays found near one another lie on a wall; their estimates of its direction are summed.
    """
    along = np.roll(points, -3, axis=0) - np.roll(points, 3, axis=0)
    lengths = np.linalg.norm(along, axis=1)
    is_wall = (lengths > 1e-6) & (lengths < 0.6)
    if not is_wall.any():
        return None
    along = along[is_wall] / lengths[is_wall, np.newaxis]
    normals = np.stack((-along[:, 1], along[:, 0]), axis=1)
    parts, directions = np.linalg.eigh(normals.T @ normals / len(normals))
    return directions[:, 0] if parts[0] < FLAT else None
