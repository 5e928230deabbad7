"""What a buffer, an edge, an explanation and a trajectory show in a notebook, as HTML."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

from tfloom.common.notebook import code, drawing, faint, shortened, table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tfloom._native import Buffer, Edge

__all__ = ["chain_html", "edge_html", "trajectory_html", "tree_html"]

MAX_FRAMES = 1000
"""How many frames of a tree are shown."""
MAX_LINKS = 100
"""How many links of a chain are shown."""
MAX_TITLE_CHARACTERS = 2000
"""How much of an error is shown; that of a loop names all its frames."""
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
        about = f" {faint(_history(edges[name]))}" if name in edges else ""
        lines.append(f"<li>{_frame(name)}{about}")
        if children[name]:
            lines.append(f'<ul style="{STYLE}">')
            waiting += [("</ul></li>", True), *((child, False) for child in reversed(children[name]))]
        else:
            lines[-1] += "</li>"
    if len(shown) < len(names):
        lines.append(f"{len(names) - len(shown)} more frames")
    return "\n".join(lines)


def _history(edge: Edge) -> str:
    if edge.is_static:
        return "static"
    if edge.sample_count == 1:
        return f"1 sample, at {_stamp(edge.newest_ns)}"
    seconds = (edge.newest_ns - edge.oldest_ns) / 1e9
    rate = f", {(edge.sample_count - 1) / seconds:.1f} Hz" if seconds > 0 else ""
    return f"{edge.sample_count} samples{rate}, {_stamp(edge.oldest_ns)} to {_stamp(edge.newest_ns)}"


def _stamp(stamp_ns: int) -> str:
    sec, nanosec = divmod(stamp_ns, 1_000_000_000)
    return f"{sec}.{nanosec:09d}"[:-6]


def _frame(name: str) -> str:
    return code(shortened(name))


def edge_html(edge: Edge) -> str:
    """Return an edge as a table."""
    return table(
        [
            ("frame", _frame(edge.child_frame_id)),
            ("in", _frame(edge.frame_id)),
            ("history", _history(edge)),
            ("published by", escape(shortened(edge.authority))),
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
        ("frame", _frame(frames[1])),
        ("in", _frame(frames[0])),
        ("poses", str(len(stamps_ns))),
    ]
    if len(stamps_ns):
        first, last = int(stamps_ns[0]), int(stamps_ns[-1])
        rows += [
            ("time", f"{_stamp(first)} to {_stamp(last)}: {(last - first) / 1e9:.3f} s"),
            ("length", f"{length_m:.3f} m"),
        ]
    title = "x and y of the positions; the mark is the last one"
    return table(rows) + drawing(positions[:, :2], title, as_line=True)


def chain_html(title: str, links: Sequence[tuple[str, Edge]], failing_edge: Edge | None, remedy: str) -> str:
    """Return the chain of a lookup as a table.

    Args:
        title: What was looked up, and the answer, as text.
        links: The parent at the requested time and the edge, from the source to the target.
        failing_edge: The link that lacks the time, which is marked.
        remedy: How to resolve the failure, as text; may be empty.
    """
    rows = [
        (
            f"{_frame(parent)} → {_frame(edge.child_frame_id)}",
            _history(edge),
            escape(shortened(edge.authority)),
            "◀ here" if edge is failing_edge else "",
        )
        for parent, edge in links
    ]
    shown = rows[:MAX_LINKS]
    shown += [row for row in rows[MAX_LINKS:] if row[-1]]
    rest = faint(f"{len(rows) - len(shown)} more links") if len(shown) < len(rows) else ""
    heads = ("link", "history", "published by", "")
    title = escape(title[:MAX_TITLE_CHARACTERS])
    return f"<b>{title}</b>{table(shown, heads) if shown else ''}{rest}<div>{escape(remedy)}</div>"
