"""Draw the output of `python -m benchmarks.rmw.discovery`: `python tools/discovery_plot.py OUTPUT.txt PICTURE.svg`."""

from __future__ import annotations

import sys
from pathlib import Path

COLORS = {"cyclonedds": "#24497a", "zenoh": "#c0632b"}


def read_curves(text: str) -> dict[str, list[tuple[int, float, float]]]:
    """Return, by wire, the rows of complete graphs: nodes, time [s], CPU time [s]."""
    curves: dict[str, list[tuple[int, float, float]]] = {}
    for line in text.splitlines():
        words = line.split()
        if len(words) == 6 and words[3] == "True":
            curves.setdefault(words[0], []).append((int(words[1]), float(words[4]), float(words[5])))
    return curves


def draw(curves: dict[str, list[tuple[int, float, float]]], path: Path) -> None:
    """Draw time and CPU time over the number of nodes."""
    import matplotlib as mpl

    mpl.use("Agg")
    mpl.rcParams["svg.fonttype"] = "none"
    mpl.rcParams["svg.hashsalt"] = "discovery"
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(8, 3), layout="constrained")
    for column, (axis, title) in enumerate(
        zip(axes, ("until all is known [s]", "CPU of all processes [s]"), strict=True), 1
    ):
        for wire, rows in curves.items():
            axis.plot(
                [row[0] for row in rows], [row[column] for row in rows], "o-", color=COLORS[wire], label=wire
            )
        axis.set(xlabel="nodes", title=title, ylim=(0, None))
        axis.legend()
    figure.savefig(path, metadata={"Date": None})


if __name__ == "__main__":
    draw(read_curves(Path(sys.argv[1]).read_text("utf-8")), Path(sys.argv[2]))
