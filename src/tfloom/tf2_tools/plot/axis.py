"""A scale with round numbers."""

from __future__ import annotations

import math
from typing import NamedTuple

ROUND = (1.0, 2.0, 2.5, 5.0, 10.0)
ROUND_ANGLES = (15.0, 30.0, 45.0, 90.0)
"""Steps of degrees, where they fit."""


class Axis(NamedTuple):
    """A range of values, and the numbers that are written beside it."""

    low: float
    high: float
    ticks: list[float]

    def share(self, value: float) -> float:
        """Return where a value is, from 0 at the low end to 1 at the high one."""
        return (value - self.low) / (self.high - self.low)

    def text(self, tick: float) -> str:
        """Return a tick with as many digits as the step needs."""
        step = self.ticks[1] - self.ticks[0] if len(self.ticks) > 1 else 1.0
        digits = max(0, -math.floor(math.log10(step) + 1e-9)) + (1 if _is_quarter(step) else 0)
        return f"{tick:.{min(digits, 12)}f}" if 1e-9 < step < 1e9 else f"{tick:.3g}"


def _is_quarter(step: float) -> bool:
    return abs(step / 10.0 ** math.floor(math.log10(step) + 1e-9) - 2.5) < 1e-6


def axis_of(low: float, high: float, most: int, *, degrees: bool = False, is_tight: bool = False) -> Axis:
    """Return an axis for values from `low` to `high`.

    Args:
        low: The least value.
        high: The greatest.
        most: The largest number of steps.
        degrees: Whether the values are angles [deg].
        is_tight: Whether the axis ends at `low` and `high`, not at the ticks around them.
    """
    if high - low < 1e-9 * max(1.0, abs(low), abs(high)):
        middle, half = (low + high) / 2, max(0.5, abs(low) * 1e-6)
        low, high = middle - half, middle + half
    step = _step((high - low) / most, degrees=degrees)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    ticks = [i * step + 0.0 for i in range(first, last + 1)]
    if is_tight:
        slack = 1e-9 * (high - low)
        return Axis(low, high, [tick for tick in ticks if low - slack <= tick <= high + slack])
    return Axis(ticks[0], ticks[-1], ticks)


def _step(least: float, *, degrees: bool) -> float:
    """Return the smallest round step that is not below `least`."""
    if degrees and ROUND_ANGLES[0] / 3 < least <= ROUND_ANGLES[-1]:
        return next(step for step in ROUND_ANGLES if step >= least)
    power = 10.0 ** math.floor(math.log10(least))
    return next(power * digit for digit in ROUND if power * digit >= least * (1 - 1e-9))
