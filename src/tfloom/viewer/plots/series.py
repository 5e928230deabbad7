"""The numbers of one field over time, in bounded memory."""

from __future__ import annotations

import bisect
import math
from array import array

import numpy as np

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

    def _drop(self) -> None:
        # What is dropped is moved in memory, so it is done for many numbers at once.
        if self._length_ns is not None and len(self._stamps) % 64 == 0:
            count = bisect.bisect_left(self._stamps, self._stamps[-1] - self._length_ns)
            del self._stamps[:count]
            del self._values[:count]
        if len(self._stamps) > MAX_SAMPLES:
            chosen = _extremes(np.array(self._values), np.arange(0, len(self._stamps), 4))
            self._stamps = array("q", np.array(self._stamps)[chosen].tobytes())
            self._values = array("d", np.array(self._values)[chosen].tobytes())

    def at(self, stamp_ns: int | None) -> float | None:
        """Return the last number up to a time [ns since epoch], or of all; None where there is none, or a gap."""
        count = len(self._stamps) if stamp_ns is None else bisect.bisect_right(self._stamps, stamp_ns)
        value = self._values[count - 1] if count else math.nan
        return None if math.isnan(value) else value

    def reduced_points(
        self, start_ns: int, end_ns: int, count: int
    ) -> tuple[list[float], list[float | None]]:
        """Return numbers of a time: seconds before its end, and values; None for a gap.

        Args:
            start_ns: Start of the time [ns since epoch].
            end_ns: Its end, which is included.
            count: Number of equal parts of the time, of each of which the least and the greatest value are returned if
                there are more than two for each part.
        """
        first = bisect.bisect_left(self._stamps, start_ns)
        last = bisect.bisect_right(self._stamps, end_ns)
        stamps = np.array(self._stamps[first:last], np.int64)
        values = np.array(self._values[first:last], np.float64)
        if len(stamps) > 2 * count:
            edges = np.searchsorted(stamps, np.linspace(start_ns, end_ns, count, endpoint=False))
            chosen = _extremes(values, np.unique(edges[edges < len(stamps)]))
            stamps, values = stamps[chosen], values[chosen]
        seconds = ((stamps - end_ns) / 1e9).round(4).tolist()
        return seconds, [None if math.isnan(value) else float(f"{value:.7g}") for value in values.tolist()]


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
