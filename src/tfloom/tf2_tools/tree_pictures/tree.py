"""A tree of frames as pictures show it: each transform with its publishers and health, roots and loops."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from tfloom.tf2_tools.drawing.tree_layout import Layout, Size, arrange
from tfloom.tf2_tools.text import counted
from tfloom.tf2_tools.tree_pictures.records import FrameRecord

STALE_S = 1.0
"""A moving transform is stale if it is older than the newest of the tree by more than this [s] …"""
STALE_PERIODS = 5.0
"""… and by more than this many of its periods."""

SINGLE_RATE = 10_000.0
"""The rate that a buffer reports of one transform."""


class DrawnEdge(NamedTuple):
    """The transform from a parent to its child."""

    record: FrameRecord
    publishers: tuple[str, ...]
    """Names of the nodes that publish it; the buffer's authority if they are unknown."""
    is_stale: bool

    @property
    def state(self) -> str:
        """`static`, `stale` or `live`."""
        return "static" if self.record.is_static else "stale" if self.is_stale else "live"

    @property
    def rate_text(self) -> str:
        """The rate with its unit."""
        if self.record.is_static:
            return "static"
        if self.record.rate >= SINGLE_RATE:
            return "once"
        return f"{self.record.rate:.4g} Hz" if self.record.rate < 1000.0 else f"{self.record.rate:.0f} Hz"

    def description(self) -> str:
        """Return all that is known, a line each."""
        record = self.record
        lines = [f"{record.parent} → {record.child}", f"published by: {', '.join(self.publishers)}"]
        if record.is_static:
            return "\n".join([*lines, "static"])
        lines += [
            f"rate: {self.rate_text}",
            f"buffer length: {record.buffer_length:.3f} s",
            f"newest: {record.most_recent:.6f} s",
            f"oldest: {record.oldest:.6f} s",
        ]
        return "\n".join([*lines, "stale"] if self.is_stale else lines)


class FrameTree(NamedTuple):
    """Frames and their transforms, in the order of names."""

    edges: dict[str, DrawnEdge]
    """By child."""
    layout: Layout
    """Its order and roots; the places are those of frames without a size."""
    recorded_at_s: float
    """When the frames were gathered [s since epoch]."""
    newest_s: float
    """Newest stamp of all moving transforms [s]; 0 if there is none."""

    @property
    def frames(self) -> list[str]:
        """All frames, each after its parent unless a loop begins there."""
        return list(self.layout.places)

    @property
    def children(self) -> dict[str, list[str]]:
        """The children of each frame; a loop's first frame is nobody's child."""
        children: dict[str, list[str]] = {frame: [] for frame in self.layout.places}
        for child, edge in self.edges.items():
            if child not in self.layout.loop_starts:
                children[edge.record.parent].append(child)
        return children

    def state_of(self, frame: str) -> str:
        """Return `root`, `loop` or its transform's state."""
        if frame in self.layout.loop_starts:
            return "loop"
        return self.edges[frame].state if frame in self.edges else "root"

    def description_of(self, frame: str) -> str:
        """Return all that is known of a frame's transform, a line each, or that it is a root."""
        return self.edges[frame].description() if frame in self.edges else f"{frame}\nroot"

    def summary(self) -> str:
        """Return the numbers of frames, transforms and trees, and what is wrong, in one line."""
        states = [edge.state for edge in self.edges.values()]
        parts = [
            counted(len(self.layout.places), "frame"),
            f"{counted(len(self.edges), 'transform')} ({states.count('static')} static)",
            counted(len(self.layout.roots), "tree"),
        ]
        if loops := len(self.layout.loop_starts):
            parts.append(counted(loops, "loop"))
        if stale := states.count("stale"):
            parts.append(f"{stale} stale")
        return ", ".join(parts)


def build_tree(
    records: Iterable[FrameRecord],
    recorded_at_s: float,
    publishers: Mapping[str, Sequence[str]] | None = None,
) -> FrameTree:
    """Return the tree of a buffer's frames.

    Args:
        records: The frames with a parent.
        recorded_at_s: When they were gathered [s since epoch].
        publishers: Names of the nodes that publish a child's transform, by child, as far as they are known.
    """
    records = sorted(records, key=lambda record: natural_key(record.child))
    newest_s = max((record.most_recent for record in records if not record.is_static), default=0.0)
    edges = {}
    for record in records:
        nodes = tuple((publishers or {}).get(record.child, ()))
        edges[record.child] = DrawnEdge(record, nodes or (record.broadcaster,), _is_stale(record, newest_s))
    parents = {child: edge.record.parent for child, edge in edges.items()}
    names = sorted({*parents, *parents.values()}, key=natural_key)
    layout = arrange(parents, dict.fromkeys(names, Size(0.0, 0.0)))
    return FrameTree(edges, layout, recorded_at_s, newest_s)


def _is_stale(record: FrameRecord, newest_s: float) -> bool:
    if record.is_static:
        return False
    period_s = 1.0 / record.rate if record.rate > 0.0 else 0.0
    return newest_s - record.most_recent > max(STALE_S, STALE_PERIODS * period_s)


def natural_key(name: str) -> list[tuple[int, int, str]]:
    """Return a key that sorts `joint2` before `joint10`."""
    parts = re.split(r"([0-9]+)", name)
    for i in range(1, len(parts), 2):
        parts[i] = parts[i].lstrip("0")
    return [(i % 2, len(part) if i % 2 else 0, part) for i, part in enumerate(parts)]


def tree_json(tree: FrameTree) -> dict[str, Any]:
    """Return the tree as values for JSON: times in seconds, null where a number does not apply."""
    edges = []
    for edge in tree.edges.values():
        record, is_static = edge.record, edge.record.is_static
        edges.append(
            {
                "parent": record.parent,
                "child": record.child,
                "publishers": list(edge.publishers),
                "authority": record.broadcaster,
                "state": edge.state,
                "rate_hz": None if is_static or record.rate >= SINGLE_RATE else _finite(record.rate),
                "buffer_length_s": None if is_static else _finite(record.buffer_length),
                "newest_s": None if is_static else _finite(record.most_recent),
                "oldest_s": None if is_static else _finite(record.oldest),
            }
        )
    return {
        "recorded_at_s": tree.recorded_at_s,
        "newest_s": _finite(tree.newest_s) or None,
        "frames": tree.frames,
        "roots": tree.layout.roots,
        "loops": sorted(tree.layout.loop_starts, key=natural_key),
        "transforms": edges,
    }


def _finite(value: float) -> float | None:
    """Return a number; None instead of NaN and the infinities, which JSON lacks."""
    return value if math.isfinite(value) else None
