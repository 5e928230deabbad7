"""The way of a frame through another one, as arrays and as text."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tfloom._native import Buffer, Edge

__all__ = ["Trajectory", "chosen_stamps"]


class Trajectory(NamedTuple):
    """Poses of a frame in another one, in the order of their stamps."""

    target_frame: str
    """The frame in which the poses are expressed."""
    source_frame: str
    """The frame whose way this is."""
    stamps_ns: NDArray[np.int64]
    """(N,) [ns since epoch]"""
    positions: NDArray[np.float64]
    """(N, 3) [m]"""
    rotations_xyzw: NDArray[np.float64]
    """(N, 4) unit quaternions."""

    @property
    def length_m(self) -> float:
        """Length of the way from position to position [m]."""
        import numpy as np

        return float(np.linalg.norm(np.diff(self.positions, axis=0), axis=1).sum())

    @property
    def duration_s(self) -> float:
        """Time from the first to the last stamp [s]; 0 without poses."""
        return int(self.stamps_ns[-1] - self.stamps_ns[0]) / 1e9 if len(self.stamps_ns) else 0.0

    def matrices(self) -> NDArray[np.float64]:
        """Return the poses as matrices (N, 4, 4)."""
        import numpy as np

        from tfloom import _native

        out = np.empty((len(self.positions), 4, 4))
        _native.matrices(np.hstack((self.positions, self.rotations_xyzw)), out)
        return out

    def to_pandas(self) -> Any:
        """Return a DataFrame with the columns x, y, z, qx, qy, qz, qw, indexed by the stamps as times in UTC.

        Raises:
            ImportError: pandas isn't installed.
        """
        import numpy as np

        try:
            import pandas as pd
        except ImportError:
            raise ImportError(
                "pandas is needed for a DataFrame: install it by `pip install pandas`"
            ) from None
        index = pd.DatetimeIndex(pd.to_datetime(self.stamps_ns, unit="ns", utc=True), name="stamp")
        table = np.hstack((self.positions, self.rotations_xyzw))
        return pd.DataFrame(table, index, columns=["x", "y", "z", "qx", "qy", "qz", "qw"])

    def tum_text(self) -> str:
        """Return the poses in TUM's format: lines of stamp [s], x, y, z, qx, qy, qz, qw."""
        lines = []
        for stamp, position, rotation in zip(
            self.stamps_ns.tolist(), self.positions.tolist(), self.rotations_xyzw.tolist(), strict=True
        ):
            sec, nanosec = divmod(stamp, 1_000_000_000)
            lines.append(f"{sec}.{nanosec:09d} " + " ".join(map(repr, [*position, *rotation])))
        return "".join(f"{line}\n" for line in lines)

    def kitti_text(self) -> str:
        """Return the poses in KITTI's format: lines of the first three rows of each matrix, without stamps."""
        rows = self.matrices()[:, :3, :].reshape(-1, 12).tolist()
        return "".join(" ".join(map(repr, row)) + "\n" for row in rows)

    def write_tum(self, path: str | os.PathLike[str]) -> None:
        """Write `tum_text` to a file, which appears complete or not at all.

        Raises:
            OSError: the file can't be written.
        """
        from tfloom.common.files import write_file

        write_file(path, self.tum_text())

    def write_kitti(self, path: str | os.PathLike[str]) -> None:
        """Write `kitti_text` to a file, which appears complete or not at all.

        Raises:
            OSError: the file can't be written.
        """
        from tfloom.common.files import write_file

        write_file(path, self.kitti_text())

    def __repr__(self) -> str:
        text = f"{len(self.stamps_ns)} poses, {self.duration_s:.3f} s, {self.length_m:.3f} m"
        return f"<Trajectory of {self.source_frame} in {self.target_frame}: {text}>"

    def _repr_html_(self) -> str:
        """Return what a notebook shows: a table, and a drawing from above."""
        from tfloom.tf2.html import trajectory_html

        frames = (self.target_frame, self.source_frame)
        return trajectory_html(frames, self.stamps_ns, self.positions, self.length_m)


def shared_history(edges: list[Edge]) -> tuple[int, int] | None:
    """Return the first and last stamp at which a chain is known [ns since epoch]; None if all of it is static."""
    moving = [edge for edge in edges if not edge.is_static]
    if not moving:
        return None
    return max(edge.oldest_ns for edge in moving), min(edge.newest_ns for edge in moving)


def stored_stamps(buffer: Buffer, edges: list[Edge]) -> NDArray[np.int64]:
    """Return the stamps of all samples of a chain that lie in its shared history, ascending, each once."""
    import numpy as np

    span = shared_history(edges)
    if span is None:
        return np.empty(0, np.int64)
    stamps = [
        np.frombuffer(buffer.samples(edge.frame_id, edge.child_frame_id)[0], np.int64)
        for edge in edges
        if not edge.is_static
    ]
    together = np.unique(np.concatenate(stamps))
    return together[(together >= span[0]) & (together <= span[1])]


def rate_error(rate_hz: object) -> Exception | None:
    """Return the error of a rate [Hz] that is neither None nor usable, for callers whose tracebacks shall be short."""
    if rate_hz is None:
        return None
    if not hasattr(rate_hz, "__float__"):
        return TypeError(
            f"rate_hz must be a number, as 20, not {rate_hz!r} of class {type(rate_hz).__name__}"
        )
    is_usable = 0 < float(rate_hz) < 1e9
    return None if is_usable else ValueError(f"rate_hz must be above 0 and below 1e9, not {rate_hz}")


def regular_stamps(rate_hz: float, start_ns: int, end_ns: int) -> NDArray[np.int64]:
    """Return stamps from start to end, both included, at a rate; each is rounded to whole nanoseconds by itself.

    Raises:
        ValueError: the rate isn't positive, or gives more than 100 million stamps.
    """
    import numpy as np

    if (error := rate_error(rate_hz)) is not None:
        raise error
    count = max(0.0, (end_ns - start_ns) * rate_hz / 1e9)
    if count > 1e8:
        raise ValueError(f"{rate_hz} Hz from {start_ns} to {end_ns} ns are more than 100 million stamps")
    steps = np.arange(int(count + 1e-6) + 1)
    stamps: NDArray[np.int64] = start_ns + np.rint(steps * (1e9 / rate_hz)).astype(np.int64)
    return stamps[stamps <= end_ns]


def chosen_stamps(
    buffer: Buffer,
    edges: list[Edge],
    stamps_ns: NDArray[np.int64] | None,
    rate_hz: float | None,
    span: tuple[int | None, int | None],
) -> NDArray[np.int64]:
    """Return the stamps of a trajectory, as `Buffer.trajectory` describes them.

    Args:
        buffer: The transforms.
        edges: Those of the chain.
        stamps_ns: (N,) The wanted stamps.
        rate_hz: The wanted rate.
        span: The bounds.

    Raises:
        ValueError: both stamps and a rate are given, or the rate isn't positive.
    """
    import numpy as np

    if stamps_ns is not None and rate_hz is not None:
        raise ValueError("give stamps_ns or rate_hz, not both")
    if rate_hz is not None:
        history = shared_history(edges) or (0, -1)
        start = history[0] if span[0] is None else max(history[0], span[0])
        end = history[1] if span[1] is None else min(history[1], span[1])
        return regular_stamps(rate_hz, start, end) if start <= end else np.empty(0, np.int64)
    stamps = stored_stamps(buffer, edges) if stamps_ns is None else stamps_ns
    if span[0] is not None:
        stamps = stamps[stamps >= span[0]]
    if span[1] is not None:
        stamps = stamps[stamps <= span[1]]
    return stamps
