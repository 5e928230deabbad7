"""The chart of a motion: position above, angles below, with axes, title, legend, and bands where data is missing."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from tfloom.common.text import utc_text
from tfloom.tf2_tools.drawing.colors import FAINT, HAIRLINE, INK, SUBTITLE, TEXT, TITLE
from tfloom.tf2_tools.drawing.fonts import elided, printable
from tfloom.tf2_tools.drawing.shapes import Box, Group, Path, Pen, Picture, Point, Shape, Text
from tfloom.tf2_tools.motion import Motion
from tfloom.tf2_tools.text import counted

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


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


WIDTH, HEIGHT = 760.0, 470.0
LEFT, RIGHT, TOP, BOTTOM = 62.0, 92.0, 62.0, 44.0
"""Room around the panels; the legend is at the right."""
PANEL_GAP = 22.0
COLORS = ("#b8352a", "#2e8540", "#2461a8")
"""Of x, y, z, and of roll, pitch, yaw: red, green and blue, as axes are drawn."""
BAND = "#eceff2"
LINE_WIDTH = 1.3
DOT = 1.4
"""Half the side of the mark of a sample between two gaps."""
COLUMN = 0.5
"""More samples than four within this width are drawn by their least and their greatest value [points]."""
HALF_TURN_DEG = 180.0
"""An angle that changes by more from one sample to the next has passed the end of its range."""
MIN_EPOCH_S = 1e9
"""An earlier stamp is that of a simulation, and has no date [s]."""


class Curve(NamedTuple):
    """One value over time."""

    name: str
    values: NDArray[np.float64]
    color: str


class Panel(NamedTuple):
    """One part of the chart."""

    label: str
    curves: list[Curve]
    is_angle: bool
    top: float
    height: float


def chart(motion: Motion, source: str, *, all_angles: bool = False) -> Picture:
    """Return the chart of a motion.

    Args:
        motion: The motion, with a pose at least.
        source: Where the transforms come from, for the line below the title.
        all_angles: Whether to draw roll and pitch beside yaw.
    """
    start_ns = int(motion.times_ns[0])
    seconds = (motion.times_ns - start_ns) / 1e9
    time_axis = axis_of(0.0, motion.duration_s, 10, is_tight=True)
    if not motion.duration_s:
        time_axis = axis_of(0.0, 1.0, 10, is_tight=True)
    shapes = list(_header(motion, source))
    panels = _panels(motion, all_angles=all_angles)
    for panel in panels:
        shapes += _panel_shapes(panel, motion, seconds, time_axis)
    shapes += _time_labels(time_axis, panels[-1], start_ns)
    return Picture(WIDTH, HEIGHT, shapes, _heading(motion))


def _heading(motion: Motion) -> str:
    return f"{printable(motion.source_frame)} in {printable(motion.target_frame)}"


def _header(motion: Motion, source: str) -> Iterator[Shape]:
    yield Text(LEFT, 22.0, elided(_heading(motion), TITLE, WIDTH - LEFT - 20.0), TITLE, INK)
    parts = [source, f"{motion.duration_s:.3g} s", counted(len(motion.times_ns), "sample")]
    if motion.gaps_ns:
        longest = max(end - start for start, end in motion.gaps_ns) / 1e9
        parts.append(f"{counted(len(motion.gaps_ns), 'gap')}, the longest {longest:.3g} s")
    text = elided(printable(", ".join(parts)), SUBTITLE, WIDTH - LEFT - 20.0)
    yield Text(LEFT, 36.0, text, SUBTITLE, FAINT)


def _panels(motion: Motion, *, all_angles: bool) -> list[Panel]:
    height = (HEIGHT - TOP - BOTTOM - PANEL_GAP) / 2
    names = ("roll", "pitch", "yaw") if all_angles else ("yaw",)
    positions = [Curve(name, motion.positions[:, i], COLORS[i]) for i, name in enumerate("xyz")]
    angles = [
        Curve(name, motion.angles_deg[:, i], COLORS[i])
        for i, name in enumerate(("roll", "pitch", "yaw"))
        if name in names
    ]
    label = "rotation [deg]" if all_angles else "yaw [deg]"
    return [
        Panel("position [m]", positions, is_angle=False, top=TOP, height=height),
        Panel(label, angles, is_angle=True, top=TOP + height + PANEL_GAP, height=height),
    ]


def _panel_shapes(
    panel: Panel, motion: Motion, seconds: NDArray[np.float64], time_axis: Axis
) -> Iterator[Shape]:
    right, bottom = WIDTH - RIGHT, panel.top + panel.height
    low = min(float(curve.values.min()) for curve in panel.curves)
    high = max(float(curve.values.max()) for curve in panel.curves)
    axis = axis_of(low, high, 6, degrees=panel.is_angle)

    def x_of(second: float) -> float:
        return LEFT + (right - LEFT) * time_axis.share(second)

    yield from _bands(motion, panel, x_of(0.0), (right - LEFT) / (time_axis.high - time_axis.low))
    for tick in time_axis.ticks:
        yield Path([(x_of(tick), panel.top), (x_of(tick), bottom)], Pen(HAIRLINE, 0.5))
    for tick in axis.ticks:
        y = bottom - panel.height * axis.share(tick)
        yield Path([(LEFT, y), (right, y)], Pen(HAIRLINE, 0.5))
        text = axis.text(tick)
        yield Text(LEFT - 6.0 - TEXT.width(text), y + TEXT.size * 0.35, text, TEXT, FAINT)
    yield Text(LEFT, panel.top - 6.0, panel.label, SUBTITLE, INK)
    for curve in panel.curves:
        lines = [
            [(x_of(second), bottom - panel.height * axis.share(value)) for second, value in piece]
            for piece in _thinned(curve, motion, seconds, panel, (right - LEFT) / COLUMN)
        ]
        yield Group([_line(points, curve.color) for points in lines], f"{curve.name} {panel.label}")
    yield Box(LEFT, panel.top, right - LEFT, panel.height, None, Pen(FAINT, 0.7))
    yield from _legend(panel, right + 12.0, has_gaps=bool(motion.gaps_ns))


def _bands(motion: Motion, panel: Panel, origin: float, scale: float) -> Iterator[Shape]:
    """Yield a band for each gap."""
    start_ns = int(motion.times_ns[0])
    for start, end in motion.gaps_ns:
        left = origin + max(0.0, (start - start_ns) / 1e9 * scale)
        right = min(origin + (end - start_ns) / 1e9 * scale, WIDTH - RIGHT)
        if right > left:
            yield Box(left, panel.top, right - left, panel.height, BAND)


def _line(points: Sequence[Point], color: str) -> Shape:
    if len(points) > 1:
        return Path(points, Pen(color, LINE_WIDTH))
    (x, y) = points[0]
    return Box(x - DOT, y - DOT, 2 * DOT, 2 * DOT, color)


def _legend(panel: Panel, x: float, *, has_gaps: bool) -> Iterator[Shape]:
    y = panel.top + 8.0
    for curve in panel.curves:
        yield Path([(x, y), (x + 18.0, y)], Pen(curve.color, 2.0))
        yield Text(x + 24.0, y + SUBTITLE.size * 0.35, curve.name, SUBTITLE, INK)
        y += 14.0
    if has_gaps:
        yield Box(x, y - 4.0, 18.0, 8.0, BAND)
        yield Text(x + 24.0, y + SUBTITLE.size * 0.35, "no data", SUBTITLE, FAINT)


def _time_labels(axis: Axis, panel: Panel, start_ns: int) -> Iterator[Shape]:
    bottom = panel.top + panel.height
    for tick in axis.ticks:
        text = axis.text(tick)
        x = LEFT + (WIDTH - RIGHT - LEFT) * axis.share(tick)
        yield Text(x - TEXT.width(text) / 2, bottom + 11.0, text, TEXT, FAINT)
    start_s = start_ns / 1e9
    date = f" ({utc_text(start_s)})" if start_s > MIN_EPOCH_S else ""
    label = f"time [s] since {start_s:.3f}{date}"
    middle = (LEFT + WIDTH - RIGHT) / 2
    yield Text(middle - SUBTITLE.width(label) / 2, bottom + 27.0, label, SUBTITLE, INK)


def _thinned(
    curve: Curve, motion: Motion, seconds: NDArray[np.float64], panel: Panel, columns: float
) -> Iterator[list[Point]]:
    """Yield the lines of a curve as times and values: broken at gaps, and where an angle passes 180 degrees."""
    import numpy as np

    width_s = max(motion.duration_s, 1e-9) / columns
    for piece in motion.pieces():
        times, values = seconds[piece], curve.values[piece]
        jumps = np.flatnonzero(np.abs(np.diff(values)) > HALF_TURN_DEG) + 1
        borders = [0, *(jumps if panel.is_angle else []), len(values)]
        for start, end in pairwise(borders):
            yield _drawn(times[start:end], values[start:end], width_s)


def _drawn(times: NDArray[np.float64], values: NDArray[np.float64], width_s: float) -> list[Point]:
    """Return the points of a line; of many within one column, the least and the greatest."""
    import numpy as np

    if len(values) > 4 * (times[-1] - times[0]) / width_s + 4:
        starts = np.unique((times / width_s).astype(np.int64), return_index=True)[1]
        low, high = np.minimum.reduceat(values, starts), np.maximum.reduceat(values, starts)
        times, values = np.repeat(times[starts], 2), np.column_stack([low, high]).ravel()
    return [(float(time), float(value)) for time, value in zip(times, values, strict=True)]
