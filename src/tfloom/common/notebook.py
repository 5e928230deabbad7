"""Parts of what objects show in a notebook: tables, folded parts and drawings, with their styles inline.

Outside Jupyter (in VS Code, on GitHub, in an exported page) no style sheet gives tables a layout, so each tag has one.
Text keeps the colour of the page, and lines are half-transparent grey, because the page may be light or dark.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["code", "drawing", "faint", "folded", "shortened", "table"]

SIZE = 240
"""Of a drawing [pixels]."""
MARGIN = 10
MAX_CHARACTERS = 500
"""How many characters of a text are shown."""
MAX_POINTS = 500
"""How many points of a drawing are shown."""
LINE = "1px solid rgba(128,128,128,.4)"
CELL = f"text-align:left;vertical-align:top;padding:2px 8px;border:0;border-bottom:{LINE}"
TABLE = "border-collapse:collapse;border:0;margin:2px 0;color:inherit;background:transparent"


def table(rows: Iterable[Sequence[str]], heads: Sequence[str] = ()) -> str:
    """Return a table.

    Args:
        rows: The cells of each row, as HTML; the first one names the row.
        heads: Names of the columns, as HTML.
    """
    top = "".join(f'<th style="{CELL}">{head}</th>' for head in heads)
    lines = [f"<tr>{top}</tr>"] if heads else []
    for name, *values in rows:
        cells = "".join(f'<td style="{CELL}">{value}</td>' for value in values)
        lines.append(f'<tr style="background:transparent"><th style="{CELL}">{name}</th>{cells}</tr>')
    return f'<table style="{TABLE}">{"".join(lines)}</table>'


def folded(title: str, content: str, *, is_open: bool) -> str:
    """Return HTML that a click on the title, a text, shows or hides."""
    return f"<details{' open' if is_open else ''}><summary>{escape(title)}</summary>{content}</details>"


def shortened(text: str) -> str:
    """Return a text, of a long one its beginning."""
    return text if len(text) <= MAX_CHARACTERS else f"{text[:MAX_CHARACTERS]}…"


def code(text: str) -> str:
    """Return a name, as HTML."""
    return f'<code style="color:inherit;background:transparent">{escape(text)}</code>'


def faint(html: str) -> str:
    """Return HTML that is less conspicuous."""
    return f'<span style="opacity:.7">{html}</span>'


def drawing(points: NDArray[np.float64], title: str, *, as_line: bool) -> str:
    """Return points as SVG: x to the right, y up, both in one scale; empty if fewer than two are finite.

    Args:
        points: (N, 2) [m]; of more than `MAX_POINTS`, so many are shown, evenly chosen.
        title: What a pointer that rests on it is told; the width is added.
        as_line: Whether they are a way, with a mark at its end; else they are dots, with a cross at the origin.
    """
    import numpy as np

    points = np.asarray(points, np.float64)
    points = points[np.isfinite(points).all(axis=1)]
    if len(points) < 2:
        return ""
    if len(points) > MAX_POINTS:
        points = points[np.unique(np.linspace(0, len(points) - 1, MAX_POINTS).astype(int))]
    extents = points if as_line else np.vstack((points, (0.0, 0.0)))
    least, greatest = extents.min(axis=0), extents.max(axis=0)
    # Halves, because the difference of the largest doubles is infinite.
    half = float((greatest / 2 - least / 2).max()) or 0.5
    middle = least / 2 + greatest / 2

    def place(points: NDArray[np.float64]) -> NDArray[np.float64]:
        placed: NDArray[np.float64] = (points / 2 - middle / 2) / half * (SIZE - 2 * MARGIN) * (1, -1)
        return placed + SIZE / 2

    shown = place(points)
    if as_line:
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in shown)
        marks = (
            f'<polyline points="{line}" fill="none" stroke="#3b8fd0" stroke-width="1.5"/>'
            f'<circle cx="{shown[-1, 0]:.1f}" cy="{shown[-1, 1]:.1f}" r="4" fill="#e0484a"/>'
        )
    else:
        dots = "".join(f"M{x:.1f} {y:.1f}h0" for x, y in shown)
        x, y = place(np.zeros((1, 2)))[0]
        marks = (
            f'<path d="{dots}" stroke="#3b8fd0" stroke-width="3" stroke-linecap="round"/>'
            f'<path d="M{x - 5:.1f} {y:.1f}h10M{x:.1f} {y - 5:.1f}v10" stroke="#e0484a" stroke-width="2"/>'
        )
    return (
        f'<svg width="{SIZE}" height="{SIZE}" style="border:{LINE};background:transparent">'
        f"<title>{escape(title)}; from the middle to an edge {half:.3g} m</title>{marks}</svg>"
    )
