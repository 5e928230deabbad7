"""Layout of a forest: parents centred over children, without overlaps.

It has two axes, which the drawing maps to x and y: siblings lie along the breadth, generations along the depth.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import accumulate
from typing import NamedTuple


class Size(NamedTuple):
    """The size of a node, in any unit of length."""

    breadth: float
    depth: float


class Place(NamedTuple):
    """The position of a node."""

    breadth: float
    """The node's middle."""
    depth: float
    """The edge that faces the roots, the same for a whole generation."""


class Layout(NamedTuple):
    """A laid-out forest, starting at (0, 0)."""

    places: dict[str, Place]
    roots: list[str]
    loop_starts: frozenset[str]
    """Roots whose parent is one of their descendants, because a cycle was cut there."""
    size: Size


class _Contour(NamedTuple):
    """The outline of a subtree, relative to its root: one entry a generation, the root's own entry last."""

    low: list[float]
    high: list[float]


def arrange(
    parents: Mapping[str, str],
    sizes: Mapping[str, Size],
    *,
    sibling_gap: float = 0.0,
    generation_gap: float = 0.0,
) -> Layout:
    """Lay out a forest.

    Args:
        parents: Parent of each node that has one. A cycle is cut at its first node in this order.
        sizes: Size of each node, parents included.
        sibling_gap: Least distance between two nodes of a generation.
        generation_gap: Distance between two generations.

    Returns:
        A place for each node of `sizes`, children in the order of `parents`.
    """
    roots, loop_starts = _find_roots(parents, sizes)
    children: dict[str, list[str]] = {node: [] for node in sizes}
    for child, parent in parents.items():
        if child not in loop_starts:
            children[parent].append(child)
    order = list(_walk(roots, children))
    # Place the subtrees relative to their parents from the leaves upward, then sum the offsets from the roots downward.
    offsets = _offsets(order, roots, children, sizes, sibling_gap)
    starts, depth = _generation_starts(order, sizes, generation_gap)
    breadths: dict[str, float] = {}
    places = {}
    for node, generation in order:
        base = breadths[parents[node]] if generation else 0.0
        breadths[node] = base + offsets[node]
        places[node] = Place(breadths[node], starts[generation])
    breadth = max((place.breadth + sizes[node].breadth / 2 for node, place in places.items()), default=0.0)
    return Layout(places, roots, loop_starts, Size(breadth, depth))


def _find_roots(parents: Mapping[str, str], nodes: Iterable[str]) -> tuple[list[str], frozenset[str]]:
    """Return all roots in order, and those of them that begin a cycle."""
    roots = [node for node in nodes if node not in parents]
    settled = set(roots)
    loop_starts = set()
    for node in parents:
        path: dict[str, None] = {}
        here = node
        # Go upward to a node whose root is known, or to one on this path again: then a cycle closes there.
        while here not in settled and here not in path:
            path[here] = None
            here = parents[here]
        if here in path:  # a new cycle, and `here` on it: begin at the cycle's first node in order
            cycle = list(path)[list(path).index(here) :]
            start = next(one for one in parents if one in cycle)
            loop_starts.add(start)
            roots.append(start)
        settled.update(path)
    return roots, frozenset(loop_starts)


def _walk(roots: Iterable[str], children: Mapping[str, list[str]]) -> Iterator[tuple[str, int]]:
    """Yield each node after its parent, with its generation; not recursive, because chains may be long."""
    stack = [(root, 0) for root in reversed(list(roots))]
    while stack:
        node, generation = stack.pop()
        yield node, generation
        stack.extend((child, generation + 1) for child in reversed(children[node]))


def _generation_starts(
    order: Iterable[tuple[str, int]], sizes: Mapping[str, Size], gap: float
) -> tuple[list[float], float]:
    """Return where each generation starts, and where the last one ends."""
    extents: list[float] = []
    for node, generation in order:
        if generation == len(extents):
            extents.append(0.0)
        extents[generation] = max(extents[generation], sizes[node].depth)
    starts = [0.0, *accumulate(extent + gap for extent in extents)]
    end = starts.pop()
    return starts, end - gap if starts else 0.0


def _offsets(
    order: list[tuple[str, int]],
    roots: list[str],
    children: Mapping[str, list[str]],
    sizes: Mapping[str, Size],
    gap: float,
) -> dict[str, float]:
    """Return each node's breadth from its parent's; a root's from the forest's low edge."""
    offsets: dict[str, float] = {}
    contours: dict[str, _Contour] = {}
    for node, _ in reversed(order):
        # In reversed order, all children of a node come before it. Their outlines are used up here, so that a long
        # chain doesn't keep one for each of its nodes.
        below = [contours.pop(child) for child in children[node]]
        shifts, contour = _side_by_side(below, gap)
        middle = (shifts[0] + shifts[-1]) / 2 if shifts else 0.0
        for child, shift in zip(children[node], shifts, strict=True):
            offsets[child] = shift - middle
        half = sizes[node].breadth / 2
        contours[node] = _shifted(contour, -middle)
        contours[node].low.append(-half)
        contours[node].high.append(half)
    shifts, forest = _side_by_side([contours[root] for root in roots], gap)
    low = min(forest.low, default=0.0)
    offsets.update((root, shift - low) for root, shift in zip(roots, shifts, strict=True))
    return offsets


def _side_by_side(trees: list[_Contour], gap: float) -> tuple[list[float], _Contour]:
    """Move trees together to the least distance; return the shift of each, and the outline of all."""
    if not trees:
        return [], _Contour([], [])
    low, high = trees[0]
    shifts = [0.0]
    for tree in trees[1:]:
        # Compare the upper edge of what is placed with the lower edge of the next tree, for each generation that both
        # have. The lists end with the roots, so generations are counted from the end.
        common = min(len(high), len(tree.low))
        shift = max(high[-k] - tree.low[-k] for k in range(1, common + 1)) + gap
        shifts.append(shift)
        placed = _shifted(tree, shift)
        low = placed.low[: max(0, len(placed.low) - len(low))] + low
        high = high[: len(high) - common] + placed.high
    return shifts, _Contour(low, high)


def _shifted(contour: _Contour, by: float) -> _Contour:
    if not by:  # an only child: long chains stay linear
        return contour
    return _Contour([value + by for value in contour.low], [value + by for value in contour.high])
