"""What a buffer, an edge and a trajectory show in a notebook, as HTML."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tfloom._native import Buffer, Edge

__all__ = ["edge_html", "trajectory_html", "tree_html"]

MAX_FRAMES = 1000
"""How many frames of a tree are shown."""
MAX_POINTS = 500
"""How many points of a trajectory are drawn."""
SIZE = 240
"""Of the drawing of a trajectory [pixels]."""
STYLE = "line-height:1.4;margin:0;padding-left:1.2em;list-style:disc"


def tree_html(buffer: Buffer) -> str:
    """Return the frames as nested lists, each with its history."""
    edges = {edge.child_frame_id: edge for edge in buffer.edges()}
    names = buffer.frame_names()
    children: dict[str, list[str]] = {name: [] for name in names}
    for edge in edges.values():
        children[edge.frame_id].append(edge.child_frame_id)
    roots = [name for name in names if name not in edges] or names[:1]
    lines = [f"<b>{len(names)} frames</b>, {sum(edge.sample_count for edge in edges.values())} transforms"]
    shown: set[str] = set()
    # A frame, or a text to add as it is; a loop rather than recursion, because chains may be long.
    waiting: list[tuple[str, bool]] = [("</ul>", True), *((root, False) for root in reversed(roots))]
    lines.append(f'<ul style="{STYLE}">')
    while waiting:
        name, is_text = waiting.pop()
        if is_text:
            lines.append(name)
            continue
        if name in shown or len(shown) >= MAX_FRAMES:
            continue
        shown.add(name)
        about = f' <span style="opacity:.7">{_history(edges[name])}</span>' if name in edges else ""
        lines.append(f"<li><code>{escape(name)}</code>{about}")
        if children[name]:
            lines.append(f'<ul style="{STYLE}">')
            waiting += [("</ul>", True), *((child, False) for child in reversed(children[name]))]
    if len(shown) < len(names):
        lines.append(f"{len(names) - len(shown)} more frames")
    return "\n".join(lines)


def _history(edge: Edge) -> str:
    if edge.is_static:
        return "static"
    seconds = (edge.newest_ns - edge.oldest_ns) / 1e9
    rate = f", {(edge.sample_count - 1) / seconds:.1f} Hz" if seconds > 0 and edge.sample_count > 1 else ""
    return f"{edge.sample_count} samples{rate}, {_stamp(edge.oldest_ns)} to {_stamp(edge.newest_ns)}"


def _stamp(stamp_ns: int) -> str:
    sec, nanosec = divmod(stamp_ns, 1_000_000_000)
    return f"{sec}.{nanosec:09d}"[:-6]


def _table(rows: list[tuple[str, str]]) -> str:
    cells = "".join(
        f"<tr><th style='text-align:left'>{name}</th><td>{value}</td></tr>" for name, value in rows
    )
    return f"<table>{cells}</table>"


def edge_html(edge: Edge) -> str:
    """Return an edge as a table."""
    return _table(
        [
            ("frame", f"<code>{escape(edge.child_frame_id)}</code>"),
            ("in", f"<code>{escape(edge.frame_id)}</code>"),
            ("history", _history(edge)),
            ("published by", escape(edge.authority)),
        ]
    )


def trajectory_html(
    frames: tuple[str, str], stamps_ns: NDArray[np.int64], positions: NDArray[np.float64], length_m: float
) -> str:
    """Return a trajectory as a table, and a drawing of it from above.

    Args:
        frames: The frame in which it is expressed, and the one that moves.
        stamps_ns: (N,) [ns since epoch]
        positions: (N, 3) [m]
        length_m: Its length [m].
    """
    rows = [
        ("frame", f"<code>{escape(frames[1])}</code>"),
        ("in", f"<code>{escape(frames[0])}</code>"),
        ("poses", str(len(stamps_ns))),
    ]
    if len(stamps_ns):
        first, last = int(stamps_ns[0]), int(stamps_ns[-1])
        rows += [
            ("time", f"{_stamp(first)} to {_stamp(last)}: {(last - first) / 1e9:.3f} s"),
            ("length", f"{length_m:.3f} m"),
        ]
    return _table(rows) + _drawing(positions[:, :2])


def _drawing(points: NDArray[np.float64]) -> str:
    """Return points (N, 2) as SVG: x to the right, y up, both in one scale."""
    import numpy as np

    points = points[np.isfinite(points).all(axis=1)]
    if len(points) < 2:
        return ""
    points = points[np.unique(np.linspace(0, len(points) - 1, MAX_POINTS).astype(int))]
    least, greatest = points.min(axis=0), points.max(axis=0)
    extent = float((greatest - least).max()) or 1.0
    shown = (points - (least + greatest) / 2) / extent * (SIZE - 20) * (1, -1) + SIZE / 2
    line = " ".join(f"{x:.1f},{y:.1f}" for x, y in shown)
    end = f'<circle cx="{shown[-1, 0]:.1f}" cy="{shown[-1, 1]:.1f}" r="4" fill="#d62728"/>'
    return (
        f'<svg width="{SIZE}" height="{SIZE}" style="border:1px solid #999">'
        f"<title>x and y of the positions; the mark is the last one; {extent:.3g} m wide</title>"
        f'<polyline points="{line}" fill="none" stroke="#1f77b4" stroke-width="1.5"/>{end}</svg>'
    )
