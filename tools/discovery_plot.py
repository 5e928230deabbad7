"""Draw the output of `python -m benchmarks.rmw.discovery`: `python tools/discovery_plot.py OUTPUT.txt PICTURE.svg`."""

from __future__ import annotations

import re
import sys
from pathlib import Path

COLORS = {"cyclonedds": "#24497a", "zenoh": "#c0632b"}
PANELS = {
    "time [s]": "all start: until all is known [s]",
    "CPU [s]": "all start: CPU of all processes [s]",
    "join [s]": "one joins: until it knows all [s]",
    "bytes [kB]": "one joins: bytes on loopback [kB]",
    "memory [MB]": "memory of a process [MB]",
}
"""The columns that are drawn, and the titles of their panels."""

Curves = dict[str, list[dict[str, float]]]


def read_curves(text: str) -> Curves:
    """Return, by wire, the rows of complete graphs: the number of nodes, and the columns of `PANELS` that are there."""
    header, *lines = text.splitlines()
    names = re.split(r"\s{2,}", header.strip())
    rows = [dict(zip(names, line.split(), strict=True)) for line in lines]
    curves: Curves = {}
    for row in rows:
        if row["complete"] == "True":
            curves.setdefault(row["wire"], []).append(
                {name: float(row[name]) for name in ("nodes", *PANELS) if name in row}
            )
    return curves


def draw(curves: Curves, path: Path) -> None:
    """Draw each column over the number of nodes."""
    import matplotlib as mpl

    mpl.use("Agg")
    mpl.rcParams["svg.fonttype"] = "none"
    mpl.rcParams["svg.hashsalt"] = "discovery"
    import matplotlib.pyplot as plt

    columns = [name for name in PANELS if any(name in row for rows in curves.values() for row in rows)]
    lines = -(-len(columns) // 3)
    figure, axes = plt.subplots(lines, 3, figsize=(10, 2.75 * lines), layout="constrained", squeeze=False)
    for axis, column in zip(axes.flat, columns, strict=False):
        for wire, rows in curves.items():
            nodes = [row["nodes"] for row in rows]
            axis.plot(nodes, [row[column] for row in rows], "o-", color=COLORS[wire], label=wire)
        axis.set(xlabel="nodes", ylim=(0, None), xticks=nodes)
        axis.set_title(PANELS[column], fontsize=10)
    for axis in axes.flat[len(columns) :]:
        axis.axis("off")
    axes.flat[-1].legend(*axes.flat[0].get_legend_handles_labels(), loc="center")
    figure.savefig(path, metadata={"Date": None})


if __name__ == "__main__":
    draw(read_curves(Path(sys.argv[1]).read_text("utf-8")), Path(sys.argv[2]))
