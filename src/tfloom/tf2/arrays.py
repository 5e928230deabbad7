"""The buffer for numpy arrays: many stamps and many points at once. The first call imports numpy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom import _native
from tfloom.tf2.frames import Frames

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from tfloom.tf2.trajectory import Trajectory

__all__ = ["Arrays", "Poses", "Samples"]


BEYOND = "stamps_ns must fit into 64 bits of nanoseconds: years 1677 to 2262"


class Poses(NamedTuple):
    """Transforms at many stamps."""

    positions: NDArray[np.float64]
    """(N, 3) [m]"""
    rotations_xyzw: NDArray[np.float64]
    """(N, 4) unit quaternions."""
    known: NDArray[np.bool_]
    """(N,) bool, False where the lookup failed; the row is then NaN."""

    def matrices(self) -> NDArray[np.float64]:
        """Return them as matrices (N, 4, 4)."""
        import numpy as np

        out = np.empty((len(self.positions), 4, 4))
        _native.matrices(np.hstack((self.positions, self.rotations_xyzw)), out)
        return out


class Samples(NamedTuple):
    """The stored samples of one edge, oldest first."""

    stamps_ns: NDArray[np.int64]
    """(N,)"""
    positions: NDArray[np.float64]
    """(N, 3) [m]"""
    rotations_xyzw: NDArray[np.float64]
    """(N, 4)"""


class Arrays(Frames):
    """The part of a buffer that accepts and returns arrays."""

    def lookup_many(
        self,
        target_frame: str,
        source_frame: str,
        stamps_ns: ArrayLike,
        *,
        strict: bool = True,
        workers: int = 1,
    ) -> Poses:
        """Return target_from_source at many stamps, each as `lookup` returns it.

        Ascending stamps are fastest; any order is valid. Transforms inserted during the call may affect some rows.

        Args:
            target_frame: Frame to express the data in.
            source_frame: Frame the data is expressed in.
            stamps_ns: (N,) integers or datetime64 [ns since epoch]; 0 is the latest time.
            strict: Whether to raise for a stamp whose lookup fails.
            workers: Number of threads.

        Raises:
            TransformException: as `lookup`, for the first stamp that fails if `strict`; its `index` is the stamp's.
            TypeError: the stamps are not integers.
            ValueError: they are not one-dimensional, beyond 64 bits of nanoseconds, or NaT.
        """
        import numpy as np

        stamps = _stamps(stamps_ns)
        rows = np.empty((len(stamps), 7))
        known_flags = np.zeros(len(stamps), np.uint8)
        self.fill_many(target_frame, source_frame, stamps, rows, known_flags, strict, max(1, workers))
        is_known = known_flags.view(np.bool_)
        if not strict:
            rows[~is_known] = np.nan
        return Poses(rows[:, :3], rows[:, 3:], is_known)

    def trajectory(
        self,
        target_frame: str,
        source_frame: str,
        stamps_ns: ArrayLike | None = None,
        *,
        rate_hz: float | None = None,
        start_ns: int | None = None,
        end_ns: int | None = None,
        strict: bool = True,
    ) -> Trajectory:
        """Return the way of `source_frame` through `target_frame`.

        Without stamps and rate, the stamps are those of all samples of the chain's moving transforms that lie in the
        time for which the whole chain is known.

        Args:
            target_frame: Frame to express the poses in.
            source_frame: The frame that moves.
            stamps_ns: (N,) integers [ns since epoch], as those of another topic; None: see above.
            rate_hz: Rate at which to sample the time for which the whole chain is known [Hz].
            start_ns: The least stamp [ns since epoch]; None: no bound.
            end_ns: The greatest one [ns since epoch]; None: no bound.
            strict: Whether to raise for a stamp whose lookup fails; if not, it is left out.

        Raises:
            TransformException: as `lookup`, for the first stamp that fails if `strict`.
            ValueError: both stamps and a rate are given, or the rate isn't positive.
        """
        from tfloom.tf2.trajectory import Trajectory, chosen_stamps, rate_error

        if (error := rate_error(rate_hz)) is not None:
            raise error
        chain = self.explain(target_frame, source_frame)
        if chain.error is not None:
            raise chain.error
        given_stamps = None if stamps_ns is None else _stamps(stamps_ns)
        stamps = chosen_stamps(self, chain.edges, given_stamps, rate_hz, (start_ns, end_ns))
        poses = self.lookup_many(target_frame, source_frame, stamps, strict=strict)
        is_known = poses.known
        positions, rotations = poses.positions[is_known], poses.rotations_xyzw[is_known]
        return Trajectory(target_frame, source_frame, stamps[is_known], positions, rotations)

    def transform_points(
        self,
        points: ArrayLike,
        target_frame: str,
        source_frame: str,
        stamp_ns: int = 0,
        *,
        out: NDArray[Any] | None = None,
    ) -> NDArray[Any]:
        """Return points of `source_frame` in `target_frame`.

        Args:
            points: (N, 3) float32 or float64 [m]; other numbers become float64.
            target_frame: Frame to express the points in.
            source_frame: Frame the points are expressed in.
            stamp_ns: Time of the transform [ns since epoch]; 0 is the latest.
            out: Array to write into, of the points' shape and type, C-contiguous; it may be `points`.

        Returns:
            `out`, or a new array: (N, 3) of the points' type.

        Raises:
            TransformException: as `lookup`.
            TypeError, ValueError: an array has the wrong type or shape.
        """
        checked = _points(points)
        result = _out(checked, out)
        transform = self.lookup(target_frame, source_frame, stamp_ns)
        move = _native.move_points_float32 if checked.dtype == "float32" else _native.move_points_float64
        move(_row(transform), checked, result)
        return result

    def deskew(
        self,
        points: ArrayLike,
        stamps_ns: ArrayLike,
        target_frame: str,
        source_frame: str,
        fixed_frame: str,
        target_stamp_ns: int = 0,
        *,
        out: NDArray[Any] | None = None,
        workers: int = 1,
    ) -> NDArray[Any]:
        """Return points that a moving sensor measured one after the other, as if measured at one time.

        Point i is transformed from `source_frame` at `stamps_ns[i]` by way of `fixed_frame`, which does not move, to
        `target_frame` at `target_stamp_ns`.

        Args:
            points: (N, 3) float32 or float64 [m]; other numbers become float64.
            stamps_ns: (N,) time of each point [ns since epoch].
            target_frame: Frame to express the points in.
            source_frame: The sensor's frame.
            fixed_frame: A frame that did not move during the scan: odom or map.
            target_stamp_ns: Common time of the result [ns since epoch]; 0 is the latest.
            out: Array to write into, as in `transform_points`.
            workers: Number of threads.

        Returns:
            `out`, or a new array: (N, 3) of the points' type.

        Raises:
            TransformException: as `lookup`; for a point's stamp, its `index` is the point's.
            TypeError, ValueError: an array has the wrong type or shape.
        """
        checked = _points(points)
        stamps = _stamps(stamps_ns)
        if len(stamps) != len(checked):
            raise ValueError(
                f"there must be a stamp for each point: {len(checked)} points, {len(stamps)} stamps"
            )
        if out is not None:
            _out(checked, out)
        result = _out(checked, None)  # `out` stays unchanged where a lookup fails
        first = self.lookup(target_frame, fixed_frame, target_stamp_ns)
        fill = self.deskew_float32 if checked.dtype == "float32" else self.deskew_float64
        fill(fixed_frame, source_frame, _row(first), stamps, checked, result, max(1, workers))
        if out is None:
            return result
        out[...] = result
        return out

    def set_many(
        self,
        frame_id: str,
        child_frame_id: str,
        stamps_ns: ArrayLike,
        positions: ArrayLike,
        rotations_xyzw: ArrayLike,
        authority: str = "",
    ) -> int:
        """Store parent_from_child at many times, as `set` does for each.

        Args:
            frame_id: The parent frame.
            child_frame_id: The child frame.
            stamps_ns: (N,) integers or datetime64 [ns since epoch], in any order.
            positions: (N, 3) [m].
            rotations_xyzw: (N, 4) quaternions, of any length but zero.
            authority: Name of the publisher.

        Returns:
            Number of stored transforms; the others were rejected, for the reasons of `set`.

        Raises:
            TypeError, ValueError: an array has the wrong type or shape.
        """
        stamps = _stamps(stamps_ns)
        table = _table(positions, 3, "positions", len(stamps))
        rotations = _table(rotations_xyzw, 4, "rotations_xyzw", len(stamps))
        return self.store_many(frame_id, child_frame_id, stamps, table, rotations, authority)

    def to_arrays(self, frame_id: str, child_frame_id: str) -> Samples:
        """Return the stored samples of an edge; empty arrays if there is no such edge."""
        import numpy as np

        stamps, rows = self.samples(frame_id, child_frame_id)
        table = np.frombuffer(rows).reshape(-1, 7)
        return Samples(np.frombuffer(stamps, np.int64), table[:, :3], table[:, 3:])


def _stamps(stamps_ns: ArrayLike) -> NDArray[np.int64]:
    import numpy as np

    stamps = np.asarray(stamps_ns)
    if stamps.ndim != 1:
        raise ValueError(f"stamps_ns must be of shape (N,), not {stamps.shape}")
    if stamps.size == 0:
        return np.empty(0, np.int64)
    if stamps.dtype.kind == "M":
        return _stamps_of_dates(stamps)
    if stamps.dtype.kind == "O" or (stamps.dtype == np.uint64 and stamps.max() > np.iinfo(np.int64).max):
        raise ValueError(BEYOND)
    if stamps.dtype.kind not in "iu":
        raise TypeError(f"stamps_ns must be integers, nanoseconds since the epoch, not {stamps.dtype}")
    return np.ascontiguousarray(stamps, np.int64)


def _stamps_of_dates(dates: NDArray[np.datetime64]) -> NDArray[np.int64]:
    import numpy as np

    if np.isnat(dates).any():
        raise ValueError("stamps_ns contains NaT")
    try:
        in_ns = dates.astype("datetime64[ns]")
    except OverflowError:  # from numpy 2.5 on; before it, they wrap
        raise ValueError(BEYOND) from None
    if in_ns.dtype != dates.dtype:  # numpy wraps around where the nanoseconds don't fit
        seconds = dates.astype("datetime64[s]").view(np.int64)
        limit = np.iinfo(np.int64).max // 1_000_000_000
        if seconds.max() >= limit or seconds.min() < -limit:
            raise ValueError(BEYOND)
    return np.ascontiguousarray(in_ns.view(np.int64))


def _points(points: ArrayLike) -> NDArray[Any]:
    import numpy as np

    array = np.asarray(points)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"points must be numbers, not {array.dtype}")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"points must be of shape (N, 3), not {array.shape}")
    kind = np.float32 if array.dtype == np.float32 else np.float64
    return np.ascontiguousarray(array, kind)


def _out(points: NDArray[Any], out: NDArray[Any] | None) -> NDArray[Any]:
    import numpy as np

    if out is None:
        return np.empty_like(points)
    if out.shape != points.shape or out.dtype != points.dtype:
        raise ValueError(
            f"out must be {points.dtype} of shape {points.shape}, not {out.dtype} of {out.shape}"
        )
    if not out.flags.c_contiguous or not out.flags.writeable:
        raise ValueError("out must be C-contiguous and writeable")
    return out


def _table(values: ArrayLike, columns: int, name: str, rows: int) -> NDArray[np.float64]:
    import numpy as np

    table = np.asarray(values)
    if table.dtype.kind not in "fiu":
        raise TypeError(f"{name} must be numbers, not {table.dtype}")
    if table.shape != (rows, columns):
        raise ValueError(f"{name} must be of shape ({rows}, {columns}), not {table.shape}")
    return np.ascontiguousarray(table, np.float64)


def _row(transform: _native.StampedTransform) -> NDArray[np.float64]:
    import numpy as np

    return np.array(transform.translation + transform.rotation_xyzw)
