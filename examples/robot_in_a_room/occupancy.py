"""Keep a map of what a laser saw: a grid that grows, with the log odds that each cell is occupied."""

from __future__ import annotations

import math

import numpy as np
from planar import Pose2D

RESOLUTION_M = 0.05
MARGIN_CELLS = 40
"""Number of cells by which the grid grows beyond what it needs."""
MAX_SIDE_CELLS = 2000
HIT, PASSED = 0.9, -0.35
"""What a scan adds to the log odds of a cell in which a ray ends, and of one that it passes."""
LIMITS = (-2.5, 3.5)
"""Limits of the log odds, so that a changed cell soon gets its new state."""


class GridError(Exception):
    """What can't be added to the map; the text has the reason."""


def placed(pose: Pose2D, points: np.ndarray) -> np.ndarray:
    """Return points (N, 2) of the pose's own frame in the frame of the pose."""
    cos, sin = math.cos(pose.yaw), math.sin(pose.yaw)
    return points @ np.array([[cos, sin], [-sin, cos]]) + (pose.x, pose.y)


class OccupancyMap:
    """The map; `log_odds` (rows along y, columns along x) is 0 where nothing is known.

    Each cell also has the number of rays that ended there, and the sum of where in the cell they did: the mean lies on
    a wall more exactly than the middle of the cell.
    """

    def __init__(self) -> None:
        self.origin = np.zeros(2)
        """Lower left corner [m]."""
        self.log_odds = np.zeros((0, 0), np.float32)
        self.counts = np.zeros((0, 0), np.int64)
        self.sums = np.zeros((0, 0, 2))
        """Of columns and rows, in cells from a cell's lower left corner."""

    def cells(self, points: np.ndarray) -> np.ndarray:
        """Return the column and row (N, 2) of each point; also of those outside the grid."""
        return np.floor((points - self.origin) / RESOLUTION_M).astype(np.int64)

    def insert(self, laser: Pose2D, hits: np.ndarray, passes: np.ndarray) -> None:
        """Add a scan: rays from the laser's pose that end at `hits` (N, 2), and others that met nothing up to `passes`.

        Both are in the laser's frame [m].

        Raises:
            GridError: the map would become larger than `MAX_SIDE_CELLS`.
        """
        ends = placed(laser, np.concatenate((hits, passes)))
        start = np.array([laser.x, laser.y])
        self._grow(np.vstack((ends, start)))
        # A point in each cell's width on each ray. Cells that many rays pass count once.
        way = ends - start
        lengths = np.linalg.norm(way, axis=1)
        steps = np.arange(0.0, lengths.max(initial=0.0), RESOLUTION_M)
        with np.errstate(divide="ignore", invalid="ignore"):
            parts = steps / lengths[:, np.newaxis]
        ray, step = np.nonzero(parts < 1.0)
        on_way = self.cells(start + parts[ray, step, np.newaxis] * way[ray])
        at_end = self.cells(ends[: len(hits)])
        is_passed = np.zeros(self.log_odds.shape, bool)
        is_passed[on_way[:, 1], on_way[:, 0]] = True
        is_passed[at_end[:, 1], at_end[:, 0]] = False
        self.log_odds[is_passed] += PASSED
        is_hit = np.zeros(self.log_odds.shape, bool)
        is_hit[at_end[:, 1], at_end[:, 0]] = True
        self.log_odds[is_hit] += HIT
        np.clip(self.log_odds, *LIMITS, out=self.log_odds)
        in_cell = (ends[: len(hits)] - self.origin) / RESOLUTION_M - at_end
        np.add.at(self.counts, (at_end[:, 1], at_end[:, 0]), 1)
        np.add.at(self.sums, (at_end[:, 1], at_end[:, 0]), in_cell)
        is_gone = self.log_odds <= 0.0
        self.counts[is_gone], self.sums[is_gone] = 0, 0.0

    def _grow(self, points: np.ndarray) -> None:
        rows, columns = self.log_odds.shape
        if not self.log_odds.size:
            self.origin = np.floor(points.min(axis=0) / RESOLUTION_M) * RESOLUTION_M
        cells = self.cells(points)
        low, high = cells.min(axis=0), cells.max(axis=0)
        before = np.where(low < 0, MARGIN_CELLS - low, 0)
        after = np.where(high >= (columns, rows), MARGIN_CELLS + 1 + high - (columns, rows), 0)
        if not before.any() and not after.any():
            return
        if max(before + after + (columns, rows)) > MAX_SIDE_CELLS:
            raise GridError(f"the map would be larger than {MAX_SIDE_CELLS * RESOLUTION_M:.0f} m")
        widths = ((before[1], after[1]), (before[0], after[0]))
        self.log_odds = np.pad(self.log_odds, widths)
        self.counts = np.pad(self.counts, widths)
        self.sums = np.pad(self.sums, (*widths, (0, 0)))
        self.origin -= before * RESOLUTION_M

    def occupied(self) -> tuple[np.ndarray, np.ndarray]:
        """Return column and row of each occupied cell (N, 2), and where its rays ended on average, in cells too."""
        row, column = np.nonzero(self.counts)
        cells = np.stack((column, row), axis=1)
        return cells, cells + self.sums[row, column] / self.counts[row, column, np.newaxis]

    def percentages(self) -> np.ndarray:
        """Return the cells as an OccupancyGrid has them: 0 free to 100 occupied, -1 where nothing is known."""
        odds = np.exp(self.log_odds)
        return np.where(self.log_odds == 0.0, -1, np.rint(100.0 * odds / (1.0 + odds))).astype(np.int8)
