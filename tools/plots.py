"""Draw the output of `python -m benchmarks tf2` as bars: `python tools/plots.py OUTPUT.txt PICTURE.svg`.

Each bar is a time that the benchmark printed, on a logarithmic scale, with its ratio to tfloom's.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import NamedTuple

ROWS = {
    "lookup, latest, depth 10, 1000 Hz": "one lookup, the newest time",
    "lookup, middle, depth 10, 1000 Hz": "one lookup, between samples",
    "lookup_many, ascending, depth 10": "10⁵ stamps, in order: each edge and stamp",
    "lookup_many, shuffled, depth 10": "10⁵ stamps, shuffled: each edge and stamp",
    "set_many, into a new tree": "store an array: each transform",
}
"""The rows that are drawn, and what the picture calls them."""
NS = {"ns": 1.0, "µs": 1e3, "ms": 1e6}
PEER = r"(?P<peer>\S.*?) {2,}(?P<other>[\d.]+) +[\d.]+ x"
FIRST = re.compile(rf"(?P<what>\S.*?) {{2,}}(?P<value>[\d.]+) (?P<unit>\S+) +{PEER}")
OTHER = re.compile(rf" {{40,}}{PEER}")
COLORS = {"tfloom": "#24497a"}
OTHER_COLOR = "#9fb3c8"


class Row(NamedTuple):
    """A row of the output: a time of tfloom's, and those of others."""

    what: str
    unit: str
    times_ns: dict[str, float]


def read_rows(text: str) -> list[Row]:
    """Return the rows of a benchmark's output that have peers."""
    rows: list[Row] = []
    for line in text.splitlines():
        if match := FIRST.fullmatch(line):
            factor = NS.get(match["unit"].partition("/")[0])
            if factor is None:
                continue
            times = {"tfloom": float(match["value"]) * factor, match["peer"]: float(match["other"]) * factor}
            rows.append(Row(match["what"], match["unit"], times))
        elif rows and (match := OTHER.fullmatch(line)):
            factor = NS[rows[-1].unit.partition("/")[0]]
            rows[-1].times_ns[match["peer"]] = float(match["other"]) * factor
    return rows


def time_text(time_ns: float) -> str:
    """Return a time in the largest unit of which it is at least one."""
    for unit, factor in reversed(NS.items()):
        if time_ns >= factor:
            return f"{time_ns / factor:.3g} {unit}"
    return f"{time_ns:.3g} ns"


def draw(rows: list[Row], picture: Path) -> None:
    """Draw the rows that `ROWS` names.

    Raises:
        SystemExit: the output lacks one of them.
    """
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams |= {"svg.hashsalt": "tfloom", "svg.fonttype": "none"}
    from matplotlib import pyplot as plt

    by_name = {row.what: row for row in rows}
    if missing := [name for name in ROWS if name not in by_name]:
        raise SystemExit(f"the output has no row {missing[0]!r}: is it that of `python -m benchmarks tf2`?")
    chosen = [by_name[name] for name in ROWS]
    heights = [len(row.times_ns) for row in chosen]
    figure, axes = plt.subplots(
        len(chosen),
        figsize=(5.6, 0.34 * sum(heights) + 0.5 * len(chosen)),
        height_ratios=heights,
        sharex=True,
    )
    for axis, row in zip(axes, chosen, strict=True):
        names, times = list(row.times_ns), list(row.times_ns.values())
        axis.barh(names, times, color=[COLORS.get(name, OTHER_COLOR) for name in names], height=0.7)
        axis.set_xscale("log")
        axis.invert_yaxis()
        axis.set_title(ROWS[row.what], fontsize=9, loc="left")
        axis.spines[["top", "right"]].set_visible(False)
        axis.tick_params(axis="both", labelsize=8)
        for place, time in enumerate(times):
            ratio = f", {float(f'{time / times[0]:.3g}'):,.10g} x" if place else ""
            axis.text(1.2 * time, place, f"{time_text(time)}{ratio}", va="center", fontsize=8)
    axes[-1].set_xlim(1, 300 * max(max(row.times_ns.values()) for row in chosen))
    axes[-1].set_xlabel("time [ns], logarithmic; shorter is faster", fontsize=8)
    figure.tight_layout()
    figure.savefig(picture, metadata={"Date": None})


def main() -> None:
    """Draw the picture that the command line names."""
    if len(sys.argv) != 3:
        raise SystemExit("usage: python tools/plots.py OUTPUT.txt PICTURE.svg")
    draw(read_rows(Path(sys.argv[1]).read_text("utf-8")), Path(sys.argv[2]))


if __name__ == "__main__":
    main()
