"""How a frame moves in another one: position and angles at each stamp, and where data is missing."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from tfloom.tf2.buffer import Buffer

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tfloom._native import Edge
    from tfloom.tf2.trajectory import Trajectory

GAP_PERIODS = 5.0
"""Data is missing where an edge has no sample for more than this many of its periods …"""
MIN_GAP_S = 0.05
"""… and for more than this time [s]."""


class Motion(NamedTuple):
    """The poses of a frame in another one."""

    target_frame: str
    source_frame: str
    times_ns: NDArray[np.int64]
    """(N,) stamps, ascending [ns since epoch]."""
    positions: NDArray[np.float64]
    """(N, 3) [m]"""
    angles_deg: NDArray[np.float64]
    """(N, 3) roll, pitch and yaw about the fixed axes x, y and z, in this order, from -180 to 180 [deg]."""
    gaps_ns: list[tuple[int, int]]
    """Where an edge of the chain has no sample: from its last one before to the next one [ns since epoch]."""

    @property
    def duration_s(self) -> float:
        """Time from the first to the last stamp [s]."""
        return int(self.times_ns[-1] - self.times_ns[0]) / 1e9

    def pieces(self) -> list[slice]:
        """Return the parts of the poses between gaps."""
        import numpy as np

        ends = [int(np.searchsorted(self.times_ns, start, "right")) for start, _ in self.gaps_ns]
        borders = sorted({0, *ends, len(self.times_ns)})
        return [slice(start, end) for start, end in pairwise(borders)]


def motion_of(buffer: Buffer, target_frame: str, source_frame: str) -> Motion:
    """Return the motion at the stamps of all samples of the chain's moving transforms.

    Where one of them has no sample, there is no pose, because an interpolated one would be invented.

    Args:
        buffer: The transforms.
        target_frame: Frame in which the poses are expressed.
        source_frame: The frame that moves.

    Raises:
        TransformException: the frames are not connected, or no time is common to all transforms between them.
    """
    import numpy as np

    way = buffer.trajectory(target_frame, source_frame, strict=False)
    edges = [edge for edge in buffer.explain(target_frame, source_frame).edges if not edge.is_static]
    gaps = _merged([gap for edge in edges for gap in _gaps(buffer, edge)])
    # Between two distant samples of an edge, the buffer interpolates: the other edges' stamps there would draw a motion
    # that nobody has measured. Keep the gap's ends, which are samples.
    is_known = np.ones(len(way.stamps_ns), bool)
    for start, end in gaps:
        is_known &= (way.stamps_ns <= start) | (way.stamps_ns >= end)
    if len(way.stamps_ns):
        first, last = int(way.stamps_ns[0]), int(way.stamps_ns[-1])
        gaps = [(start, end) for start, end in gaps if end > first and start < last]
    return Motion(
        target_frame,
        source_frame,
        way.stamps_ns[is_known],
        way.positions[is_known],
        np.degrees(_angles(way))[is_known],
        gaps,
    )


def _gaps(buffer: Buffer, edge: Edge) -> list[tuple[int, int]]:
    """Return where an edge has no sample for much longer than its median period."""
    import numpy as np

    stamps = buffer.to_arrays(edge.frame_id, edge.child_frame_id).stamps_ns
    periods = np.diff(stamps)
    if len(periods) < 2:
        return []
    limit = max(GAP_PERIODS * float(np.median(periods)), MIN_GAP_S * 1e9)
    return [(int(stamps[i]), int(stamps[i + 1])) for i in np.flatnonzero(periods > limit)]


def _merged(gaps: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return gaps in order, those that overlap as one."""
    merged: list[tuple[int, int]] = []
    for start, end in sorted(gaps):
        # Sorted by their starts, so a gap can only overlap the last one so far.
        if merged and start < merged[-1][1]:
            merged[-1] = merged[-1][0], max(end, merged[-1][1])
        else:
            merged.append((start, end))
    return merged


def _angles(way: Trajectory) -> NDArray[np.float64]:
    """Return roll, pitch and yaw (N, 3) [rad]."""
    import numpy as np

    x, y, z, w = way.rotations_xyzw.T
    return np.column_stack(
        [
            np.arctan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
            np.arcsin(np.clip(2 * (w * y - z * x), -1.0, 1.0)),
            np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
        ]
    )
