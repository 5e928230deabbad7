"""Names of frames on the screen: which are shown so that none overlaps another, and how large."""

from __future__ import annotations

import unicodedata
from collections.abc import Collection, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["EM_PX", "Chosen", "chosen_labels", "width_em"]

EM_PX = 12.0
"""Height of the letters of a label of size 1 on the page [pixels]."""
HEIGHT_EM = 1.8
"""Height of a label with its background, by that of its letters."""
MARGIN_EM = 0.6
"""What a label is wider than its text."""
SIZES = np.array((1.4, 1.2, 1.0, 0.85, 0.7))
"""Sizes of labels, from the nearest to the farthest."""
SIZE_ENDS = np.array((0.35, 0.7, 1.5, 3.0))
"""By the distance of what the camera looks at, up to where each of the first sizes is used."""
MAX_SHOWN = 150
"""Number of labels that a page shows."""
KEPT = 0.85
"""A label that is shown counts as nearer by this factor, so that two at one distance don't take turns."""


class Chosen(NamedTuple):
    """A label that is shown."""

    number: int
    size: float
    """By that of `EM_PX`."""


@lru_cache(maxsize=8192)
def width_em(text: str) -> float:
    """Return the width of a text by the height of its letters; rather too much, because each page has its own font."""
    wide = sum(unicodedata.east_asian_width(letter) in "WF" for letter in text)
    return 0.56 * (len(text) - wide) + 1.05 * wide


def chosen_labels(
    seen: NDArray[np.float64],
    widths_em: NDArray[np.float64],
    screen_px: tuple[float, float],
    focus_m: float,
    *,
    first: Sequence[int] = (),
    before: Collection[int] = (),
) -> list[Chosen]:
    """Return the labels that are shown: those that come first, and of the others the nearest that still fit.

    A label stands right above its place. Those of `first` are shown in any case, where their places are seen, even if
    they overlap one another.

    Args:
        seen: Where the places are on the screen, as `camera.projected` returns them (N, 3).
        widths_em: Widths of the texts by the height of their letters (N,).
        screen_px: Width and height of the picture [pixels].
        focus_m: The distance of what the camera looks at, for which labels have size 1.
        first: Labels that come before all others.
        before: Labels that were shown before.
    """
    width_px, height_px = screen_px
    steps = np.searchsorted(SIZE_ENDS, seen[:, 2] / max(focus_m, 1e-9))
    sizes = SIZES[steps]
    left, bottom = seen[:, 0] * width_px, seen[:, 1] * height_px
    right = left + (widths_em + MARGIN_EM) * EM_PX * sizes
    top = bottom - HEIGHT_EM * EM_PX * sizes
    with np.errstate(invalid="ignore"):  # those behind the camera are nowhere
        is_free = (left >= 0.0) & (left <= width_px) & (bottom >= 0.0) & (bottom <= height_px)
    ranks = seen[:, 2].copy()
    ranks[list(before)] *= KEPT
    forced = [index for index in first if is_free[index]]
    chosen: dict[int, Chosen] = {}
    for index in (*forced, *np.argsort(ranks, kind="stable").tolist()):
        if len(chosen) == MAX_SHOWN:
            break
        if index in chosen or not (is_free[index] or index in forced):
            continue
        chosen[index] = Chosen(index, float(sizes[index]))
        # All that this one covers can't be shown any more, so each round costs the same, however many there are.
        is_free &= (
            (right <= left[index]) | (left >= right[index]) | (bottom <= top[index]) | (top >= bottom[index])
        )
    return list(chosen.values())
