"""Colours for numbers: a rainbow, or from one colour to another; for points also by an axis."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tfloom.tf2_tools.text import matrix_from_quaternion

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["AxisColors", "ColorScale", "rainbow"]

GREY = 128
"""Red, green and blue of what is not finite."""
COLORS = 2048
"""Number of colours from red to violet, more than a page tells apart."""
MAX_SORTED = 10_000
"""Number of values, about, of which the extremes are found."""


class ColorScale(NamedTuple):
    """Which colour a number has."""

    ends: tuple[float, float] | None = None
    """The values of the first and of the last colour; None: those of most values."""
    colors: tuple[tuple[int, int, int], tuple[int, int, int]] | None = None
    """The first and the last colour; None: a rainbow from red to violet."""
    is_inverted: bool = False
    """Whether the rainbow begins with violet."""

    def of(self, values: ArrayLike) -> NDArray[np.uint8]:
        """Return a colour for each value (N, 3); what is not finite is grey."""
        numbers = np.asarray(values, np.float64)
        is_finite = np.isfinite(numbers)
        if is_finite.all():
            return self._of_finite(numbers)
        table = np.full((len(numbers), 3), GREY, np.uint8)
        table[is_finite] = self._of_finite(numbers[is_finite])
        return table

    def _of_finite(self, numbers: NDArray[np.float64]) -> NDArray[np.uint8]:
        if not len(numbers):
            return np.empty((0, 3), np.uint8)
        shares = _shares(numbers, self.ends)
        if self.colors is not None:
            first, last = (np.array(color, np.float64) for color in self.colors)
            return (first + shares[:, np.newaxis] * (last - first)).astype(np.uint8)
        if self.is_inverted:
            shares = 1.0 - shares
        table: NDArray[np.uint8] = np.take(_RAINBOW, (shares * (COLORS - 1)).astype(np.intp), axis=0)
        return table


class AxisColors(NamedTuple):
    """Which colour a point has, by its place along an axis."""

    scale: ColorScale
    axis: int
    """0 is x."""
    is_of_fixed_frame: bool
    """Whether the axis is that of the fixed frame; if not, that of the points' own."""

    def of(
        self,
        positions: NDArray[np.float32],
        pose: tuple[tuple[float, float, float], tuple[float, float, float, float]] | None,
    ) -> NDArray[np.uint8]:
        """Return a colour for each point (N, 3), for their pose in the fixed frame where that is known."""
        if not self.is_of_fixed_frame or pose is None:
            return self.scale.of(positions[:, self.axis])
        place, rotation_xyzw = pose
        row = matrix_from_quaternion(rotation_xyzw)[self.axis]
        return self.scale.of(positions.astype(np.float64) @ np.array(row) + place[self.axis])


def rainbow(values: ArrayLike) -> NDArray[np.uint8]:
    """Return a colour for each value (N, 3): red is the least, violet the greatest; what is not finite is grey."""
    return ColorScale().of(values)


def _shares(numbers: NDArray[np.float64], ends: tuple[float, float] | None) -> NDArray[np.float64]:
    """Return where numbers are between two ends (N,), from 0 to 1."""
    if ends is None:
        # The extremes are those of most points, because a few stray ones would otherwise leave all others one colour.
        # Of many, some are enough to know them.
        some = numbers[:: max(1, len(numbers) // MAX_SORTED)]
        low, high = np.percentile(some, (1.0, 99.0)) if len(numbers) > 200 else (numbers.min(), numbers.max())
    else:
        low, high = ends
    # Halves, because the difference of two numbers may be beyond what a number holds.
    low, high = low / 2.0, high / 2.0
    if not high > low:
        return np.where(numbers / 2.0 > low, 1.0, 0.0) if ends is not None else np.zeros(len(numbers))
    shares: NDArray[np.float64] = np.clip((numbers / 2.0 - low) / (high - low), 0.0, 1.0)
    return shares


def _rainbow_table() -> NDArray[np.uint8]:
    """Return the colours in their order: looked up, a colour takes a fraction of the time that computing it does."""
    hue = np.linspace(0.0, 0.8 * 6.0, COLORS)
    # The three channels of a hue are one trapezoid, shifted by two sixths of the circle.
    channels = np.stack([np.abs(hue - 3.0) - 1.0, 2.0 - np.abs(hue - 2.0), 2.0 - np.abs(hue - 4.0)], axis=1)
    return (255.0 * np.clip(channels, 0.0, 1.0)).astype(np.uint8)


_RAINBOW = _rainbow_table()
