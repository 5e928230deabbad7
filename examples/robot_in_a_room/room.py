"""Cast a laser's rays against the walls, boxes and pillars of a room."""

from __future__ import annotations

import numpy as np

# Corners of closed outlines [m], in the frame `map`, in which the robot starts at the origin.
WALLS = ((-3.0, -2.5), (7.0, -2.5), (7.0, 4.5), (-3.0, 4.5))
OUTLINES = (
    WALLS,
    ((1.95, 1.6), (2.05, 1.6), (2.05, 4.5), (1.95, 4.5)),  # a wall between two halves, open below
    ((4.0, -0.4), (5.1, -0.4), (5.1, 0.5), (4.0, 0.5)),  # a table
    ((-3.0, -2.5), (-1.8, -2.5), (-1.8, -1.6), (-3.0, -1.6)),  # a cupboard in a corner
    ((5.6, 3.9), (7.0, 3.9), (7.0, 4.5), (5.6, 4.5)),  # a shelf in another one
)
PILLARS = ((0.1, 2.3, 0.25), (5.2, 2.2, 0.2))
"""x, y, radius [m]."""


class Room:
    """Walls as line segments, and pillars as circles.

    Args:
        outlines: Closed outlines, each by its corners (N, 2) [m].
        pillars: x, y and radius of each pillar [m].
    """

    def __init__(self, outlines: object = OUTLINES, pillars: object = PILLARS) -> None:
        starts, ends = [np.empty((0, 2))], [np.empty((0, 2))]
        for outline in outlines:  # type: ignore[attr-defined]
            corners = np.asarray(outline, float)
            starts.append(corners)
            ends.append(np.roll(corners, -1, axis=0))
        self.starts = np.concatenate(starts)
        self.edges = np.concatenate(ends) - self.starts
        circles = np.asarray(pillars, float).reshape(-1, 3)
        self.centres, self.radii = circles[:, :2], circles[:, 2]

    def ranges(self, position: tuple[float, float], angles: np.ndarray) -> np.ndarray:
        """Return the distance from a position to what is nearest at each angle [m]; inf where there is nothing.

        A ray meets a segment where position + range * direction = start + part * edge, with `part` from 0 to 1.
        """
        directions = np.stack((np.cos(angles), np.sin(angles)), axis=1)[:, np.newaxis]
        with np.errstate(divide="ignore", invalid="ignore"):
            to_start = self.starts - position
            along = cross(directions, self.edges)  # 0 for parallel lines, which gives inf or nan
            distance = cross(to_start, self.edges) / along
            part = cross(to_start, directions) / along
            # Rounding must not open a gap at a corner, where two segments meet.
            met = (distance >= 0.0) & (part >= -1e-9) & (part <= 1.0 + 1e-9)
            walls = np.where(met, distance, np.inf)
            # A ray meets a circle at the nearest distance to its centre along the ray, less half the chord.
            to_centre = self.centres - position
            nearest = (directions * to_centre).sum(axis=2)
            half_chord = np.sqrt(self.radii**2 - (to_centre**2).sum(axis=1) + nearest**2)  # nan: passes by
            entry = nearest - half_chord
            pillars = np.where(entry >= 0.0, entry, np.inf)
        return np.concatenate((walls, pillars), axis=1).min(axis=1, initial=np.inf)

    def clearance(self, x: float, y: float) -> float:
        """Return the distance from a position to the nearest wall or pillar [m]; below 0 within a pillar."""
        to_position = (x, y) - self.starts
        part = np.clip((to_position * self.edges).sum(axis=1) / (self.edges**2).sum(axis=1), 0.0, 1.0)
        walls = np.linalg.norm(to_position - part[:, np.newaxis] * self.edges, axis=1)
        pillars = np.linalg.norm(self.centres - (x, y), axis=1) - self.radii
        return float(min(walls.min(initial=np.inf), pillars.min(initial=np.inf)))


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
