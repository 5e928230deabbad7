"""The numbers of one field over time, in bounded memory."""

from __future__ import annotations

import bisect
import math
from array import array
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["MAX_SAMPLES", "Series"]

MAX_SAMPLES = 100_000
"""Number of samples that are kept; of more, the least and the greatest of each four are."""
MAX_NUMBER = 1e300
"""A greater number, and one that isn't finite, is a gap: pages compute differences."""


class Series:
    """Numbers by their stamps. One thread may use it.

    Args:
        length_ns: Age, before the newest number, above which numbers are dropped [ns]; None: no limit.
    """

    def __init__(self, length_ns: int | None) -> None:
        self._length_ns = length_ns
        self._stamps = array("q")
        self._values = array("d")
        self.kept_from_ns: int | None = None
        """Time from which numbers are kept though they are old, as while a page looks at them [ns since epoch]."""
        self._turned_rad = 0.0
        """By how much the first number is unrolled, because of those before it that were dropped [rad]."""

    def __len__(self) -> int:
        return len(self._stamps)

    @property
    def span(self) -> tuple[int, int] | None:
        """The first and the last stamp [ns since epoch]; None while there is no number."""
        return (self._stamps[0], self._stamps[-1]) if self._stamps else None

    def add(self, stamp_ns: int, value: float) -> None:
        """Add a number."""
        if not abs(value) <= MAX_NUMBER:
            value = math.nan
        if not self._stamps or stamp_ns >= self._stamps[-1]:
            self._stamps.append(stamp_ns)
            self._values.append(value)
        else:
            place = bisect.bisect_right(self._stamps, stamp_ns)
            self._stamps.insert(place, stamp_ns)
            self._values.insert(place, value)
        self._drop()

    def clear(self) -> None:
        """Drop all numbers."""
        del self._stamps[:]
        del self._values[:]
        self._turned_rad = 0.0

    def _drop(self) -> None:
        # What is dropped is moved in memory, so it is done for many numbers at once.
        if self._length_ns is not None and len(self._stamps) % 64 == 0:
            oldest_ns = self._stamps[-1] - self._length_ns
            if self.kept_from_ns is not None:
                oldest_ns = min(oldest_ns, self.kept_from_ns)
            count = bisect.bisect_left(self._stamps, oldest_ns)
            if count:
                self._note_turns(np.arange(count, len(self._values)))
            del self._stamps[:count]
            del self._values[:count]
        if len(self._stamps) > MAX_SAMPLES:
            chosen = _extremes(np.array(self._values), np.arange(0, len(self._stamps), 4))
            self._note_turns(chosen)
            self._stamps = array("q", np.array(self._stamps)[chosen].tobytes())
            self._values = array("d", np.array(self._values)[chosen].tobytes())

    def _note_turns(self, kept: NDArray[np.intp]) -> None:
        """Note by how much the first number is unrolled of those whose indices are kept; it may be behind a gap."""
        values = np.array(self._values)
        known = kept[~np.isnan(values[kept])]
        if len(known):
            values = values[: int(known[0]) + 1]
            self._turned_rad = float(_unrolled(values, self._turned_rad)[-1] - values[-1])

    def values(self, *, unrolls: bool) -> NDArray[np.float64]:
        """Return all numbers; a gap is NaN.

        Args:
            unrolls: Whether they are angles [rad] that go on beyond half a turn: of two in a row that are further apart
                than that, the later one is moved by whole turns.
        """
        values = np.array(self._values, np.float64)
        return _unrolled(values, self._turned_rad) if unrolls else values

    def at(self, stamp_ns: int | None, *, unrolls: bool = False) -> float | None:
        """Return the last number up to a time [ns since epoch], or of all; None where there is none, or a gap."""
        count = len(self._stamps) if stamp_ns is None else bisect.bisect_right(self._stamps, stamp_ns)
        if not count:
            return None
        value = float(self.values(unrolls=True)[count - 1]) if unrolls else self._values[count - 1]
        return None if math.isnan(value) else value

    def between(
        self, start_ns: int, end_ns: int, *, unrolls: bool = False
    ) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
        """Return the stamps [ns since epoch] and the numbers of a time, both ends included; a gap is NaN."""
        first = bisect.bisect_left(self._stamps, start_ns)
        last = bisect.bisect_right(self._stamps, end_ns)
        return np.array(self._stamps[first:last], np.int64), self.values(unrolls=unrolls)[first:last]

    def reduced_points(
        self, start_ns: int, end_ns: int, count: int, *, unrolls: bool = False
    ) -> tuple[list[float], list[float | None]]:
        """Return numbers of a time: seconds before its end, and values; None for a gap.

        Those next to it on both sides are included, because lines reach them.

        Args:
            start_ns: Start of the time [ns since epoch].
            end_ns: Its end, which is included.
            count: Number of equal parts of the time, of each of which the least and the greatest value are returned if
                there are more than two for each part.
            unrolls: Whether the numbers are angles that go on beyond half a turn, as in `values`.
        """
        first = max(bisect.bisect_left(self._stamps, start_ns) - 1, 0)
        last = bisect.bisect_right(self._stamps, end_ns) + 1
        stamps = np.array(self._stamps[first:last], np.int64)
        values = self.values(unrolls=unrolls)[first:last]
        if len(stamps) > 2 * count:
            edges = np.searchsorted(stamps, np.linspace(start_ns, end_ns, count, endpoint=False))
            beside = [place for place in (0, len(stamps) - 1) if not start_ns <= stamps[place] <= end_ns]
            chosen = _extremes(values, np.unique([*edges[edges < len(stamps)], *beside]))
            stamps, values = stamps[chosen], values[chosen]
        # So many digits that stamps differ on the page, too.
        digits = min(9, 4 + math.ceil(max(0.0, -math.log10(max(end_ns - start_ns, 1) / 1e9))))
        seconds = ((stamps - end_ns) / 1e9).round(digits).tolist()
        return seconds, [None if math.isnan(value) else float(f"{value:.7g}") for value in values.tolist()]


def _unrolled(values: NDArray[np.float64], turned_rad: float) -> NDArray[np.float64]:
    """Return angles [rad] without jumps of whole turns, from the first one on, which is moved by an angle."""
    unrolled: NDArray[np.float64] = values.copy()
    is_number = ~np.isnan(values)
    unrolled[is_number] = np.unwrap(values[is_number]) + turned_rad
    return unrolled


def _extremes(values: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """Return the indices of the least and the greatest value of each part, in order; of a part of gaps, its first."""
    chosen = []
    for start, end in zip(starts, [*starts[1:], len(values)], strict=True):
        part = values[start:end]
        is_number = ~np.isnan(part)
        if not is_number.any():
            chosen.append(start)
            continue
        chosen += sorted({int(start + np.nanargmin(part)), int(start + np.nanargmax(part))})
    return np.array(chosen, np.intp)
