"""Rows of the table: one for each publisher's edge, with its rate, age, delay and health."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Iterator
from enum import IntEnum
from typing import Any, NamedTuple

from tfloom.common.terminal import shown_name
from tfloom.tf2_tools.watch.model import Edge, Observation
from tfloom.tf2_tools.watch.tree import Tree

WINDOW_S = 1.0
"""Time over which a rate is counted [s]."""
STALE_S = 1.0
"""A moving transform is stale if none has come for this time [s] …"""
STALE_PERIODS = 5.0
"""… and for this many of its periods."""
LATE_S = 0.5
"""Delay above which a transform is late [s]."""
AHEAD_S = 0.01
"""A transform that is stamped further ahead of now than this is wrong [s]."""
MIN_NORM_ERROR = 1e-3
"""Difference of a quaternion's length from 1 that is wrong."""


OTHER_CLOCK_NS = 1_000_000_000
"""Stamps are of another clock than times of receipt if the two differ by more than this [ns]."""


class Clock(NamedTuple):
    """The time of an observation."""

    taken_ns: int
    """By the clock of receipts [ns since epoch]."""
    ahead_ns: int
    """By how much the clock of stamps, as that of a simulation, is ahead of it [ns]."""


class Health(IntEnum):
    """How well an edge is, the worst last; its name in lower case is shown."""

    ROOT = -1
    STATIC = 0
    OK = 1
    LATE = 2
    STALE = 3
    BAD = 4


class Row(NamedTuple):
    """One edge of one publisher, or a root."""

    child: str
    parent: str
    prefix: str
    """What the tree draws before the frame's name."""
    rate_hz: float
    """Over the last second; 0 for a static edge."""
    age_s: float | None
    """Time since the newest stamp; None for a static edge."""
    delay_s: float | None
    """Time from the last stamp to its receipt, by a simulation's clock their mean; None for a static edge."""
    publisher: str
    health: Health
    note: str
    """What is wrong; empty if nothing is."""

    def values(self) -> dict[str, Any]:
        """Return the row as values for JSON."""
        return {
            "parent": self.parent,
            "child": self.child,
            "rate_hz": None if self.health is Health.STATIC else self.rate_hz,
            "age_s": self.age_s,
            "delay_s": self.delay_s,
            "publisher": self.publisher,
            "health": self.health.name.lower(),
            "note": self.note,
        }


SORTS: dict[str, Callable[[Row], Any]] = {
    "tree": lambda _: 0,
    "name": lambda row: row.child,
    "rate": lambda row: -row.rate_hz,
    "age": lambda row: -(row.age_s or 0.0),
    "delay": lambda row: -(row.delay_s or 0.0),
    "publisher": lambda row: row.publisher,
    "health": lambda row: -row.health,
}
"""Orders of the rows; `tree` is that of `rows_of`."""


class Rates:
    """Rates of edges over the last second, by counts in the observations before."""

    def __init__(self) -> None:
        self._earlier: deque[tuple[float, dict[object, int]]] = deque()
        """Times of observations [s], the oldest first, each with the number of transforms of each edge until then."""
        self._counts: dict[object, int] = {}
        """Number of transforms of each edge in the last `_span_s` seconds."""
        self._span_s = 0.0

    def add(self, observation: Observation, now_s: float | None = None) -> None:
        """Count an observation, made at `now_s` on the monotonic clock [s]."""
        now_s = time.monotonic() if now_s is None else now_s
        counts = {_key(edge): edge.statistics.count for edge in observation.edges}
        # Keep one observation that is at least a second old, as the beginning of the window: an older one can go as
        # soon as its successor is old enough.
        while len(self._earlier) > 1 and self._earlier[1][0] <= now_s - WINDOW_S:
            self._earlier.popleft()
        if self._earlier:
            since_s, before = self._earlier[0]
            self._span_s = now_s - since_s
            self._counts = {key: count - before.get(key, 0) for key, count in counts.items()}
        self._earlier.append((now_s, counts))

    def of(self, edge: Edge) -> float:
        """Return an edge's rate [Hz]; until a second has been observed, that since the beginning."""
        if self._span_s < WINDOW_S / 2:
            return edge.rate_hz
        return self._counts.get(_key(edge), 0) / self._span_s

    def total(self) -> float:
        """Return the rate of all transforms [Hz]."""
        return sum(self._counts.values()) / self._span_s if self._span_s else 0.0


def _key(edge: Edge) -> object:
    return edge.child, edge.parent, edge.publisher.gid, edge.is_static


def rows_of(observation: Observation, now_ns: int, rates: Rates) -> list[Row]:
    """Return the rows of an observation in the order of the tree, children by their names.

    Args:
        observation: The observation.
        now_ns: The time with which stamps are compared [ns since epoch]: this machine's, or a simulation's.
        rates: The rates, to which the observation has been added.
    """
    # A small difference between the clocks is the time since the observation; a large one is a simulation's clock.
    ahead_ns = now_ns - observation.taken_ns
    clock = Clock(observation.taken_ns, ahead_ns if abs(ahead_ns) > OTHER_CLOCK_NS else 0)
    edges: dict[str, list[Edge]] = {}
    for edge in observation.edges:
        edges.setdefault(edge.child, []).append(edge)
    parents = observation.parents()
    tree = Tree(parents)
    loops = {frame for loop in tree.loops() for frame in loop}
    rows = []
    for frame, prefix in _walk(tree):
        if frame not in edges:
            rows.append(_root_row(frame, prefix))
        # A publisher that has left keeps its row, but isn't one of several: its node may just have been restarted.
        reparented = observation.children[frame].reparented if frame in observation.children else 0
        living = [edge for edge in edges.get(frame, []) if not edge.publisher.has_left]
        names = {(edge.publisher.gid, edge.is_static) for edge in living}
        for edge in edges.get(frame, []):
            faults = []
            if frame in loops:
                faults.append("in a loop")
            if len(names) > 1 and not edge.publisher.has_left:
                faults.append(f"{len(names)} publishers")
            if edge.parent != parents.get(frame):
                faults.append(f"parent {shown_name(edge.parent)}")
            if reparented:
                faults.append(f"re-parented {reparented} times")
            rows.append(_row(edge, prefix, faults, clock, rates))
    return rows


def _walk(tree: Tree) -> Iterator[tuple[str, str]]:
    """Yield each frame, and what the tree draws before its name."""
    for root in tree.roots():
        ends: list[bool] = []
        for depth, frame in tree.walk(root):
            del ends[depth:]
            if not depth:
                yield frame, ""
                ends.append(True)
                continue
            # `ends` has, for each depth above, whether that frame is the last child of its parent: below a last child
            # no vertical line is drawn. In a loop, the root is also a child; it has been drawn at the top already.
            last = next(child for child in reversed(tree.children[tree.parents[frame]]) if child != root)
            branches = "".join("  " if end else "│ " for end in ends[1:])
            ends.append(frame == last)
            yield frame, branches + ("└ " if ends[-1] else "├ ")


def _root_row(frame: str, prefix: str) -> Row:
    return Row(
        child=frame,
        parent="",
        prefix=prefix,
        rate_hz=0.0,
        age_s=None,
        delay_s=None,
        publisher="",
        health=Health.ROOT,
        note="",
    )


def _row(edge: Edge, prefix: str, faults: list[str], clock: Clock, rates: Rates) -> Row:
    statistics = edge.statistics
    if statistics.non_finite:
        faults.append(f"{statistics.non_finite} with NaN")
    if statistics.worst_norm_error > MIN_NORM_ERROR:
        faults.append("quaternion not of length 1")
    if edge.child == edge.parent:
        faults.append("its own parent")
    health, age_s, delay_s = Health.STATIC, None, None
    states: list[str] = []
    if not edge.is_static:
        if statistics.zero_stamps:
            faults.append("stamp 0")
        age_s = (clock.taken_ns + clock.ahead_ns - statistics.newest_stamp_ns) / 1e9
        delay_s = (statistics.last_received_ns - statistics.last_stamp_ns) / 1e9
        if clock.ahead_ns:  # a simulation's time when the last one came is not known
            delay_s = statistics.delay.mean
        if delay_s < -AHEAD_S:
            faults.append("stamped ahead of now")
        health = _health(edge, age_s, delay_s, clock)
        states = [health.name.lower()] if health is not Health.OK else []
    if edge.publisher.has_left:
        states.append("its publisher has left")
        health = Health.STALE
    return Row(
        child=edge.child,
        parent=edge.parent,
        prefix=prefix,
        rate_hz=0.0 if edge.is_static else rates.of(edge),
        age_s=age_s,
        delay_s=delay_s,
        publisher=edge.publisher.label,
        health=Health.BAD if faults else health,
        note=", ".join([*faults, *states]),
    )


def _health(edge: Edge, age_s: float, delay_s: float, clock: Clock) -> Health:
    """Return the health of a moving edge by its times."""
    period_s = 1.0 / edge.rate_hz if edge.rate_hz > 0.0 else 0.0
    silent_s = (clock.taken_ns - edge.statistics.last_received_ns) / 1e9
    if min(silent_s, age_s) > max(STALE_S, STALE_PERIODS * period_s):
        return Health.STALE
    return Health.LATE if delay_s > LATE_S else Health.OK
