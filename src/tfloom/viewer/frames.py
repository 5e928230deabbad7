"""Where all frames are at one time, seen from a fixed one."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tfloom.tf2.buffer import LATEST
from tfloom.tf2.errors import TransformException
from tfloom.viewer.displays.display import MAX_COORDINATE_M, are_drawable

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.tf2.buffer import Buffer

__all__ = [
    "FramePoses",
    "Span",
    "connected_from",
    "default_fixed_frame",
    "frames_at",
    "frames_behind",
    "root_of",
    "span_of",
    "trail_of",
]

USUAL_FIXED_FRAMES = ("map", "odom", "world")
"""Frames that are fixed where nothing is chosen, the first one that exists; then the root of the largest tree."""
MAX_FRAMES = 2000
"""Number of frames that are drawn."""
MAX_TRAIL_POINTS = 2000
"""Number of points that a trail has at most."""
LATER_NS = 1_000_000_000
"""How much later than the first half the others of the frames may connect with which a recording begins [ns]."""


class FramePoses(NamedTuple):
    """The frames that are known at a time, each with its pose in the fixed frame."""

    names: list[str]
    positions: NDArray[np.float64]
    """(N, 3) [m]."""
    rotations_xyzw: NDArray[np.float64]
    """(N, 4) unit quaternions."""
    parents: NDArray[np.int64]
    """(N,) index of each frame's parent; -1 without one that is known."""
    far: frozenset[str] = frozenset()
    """The names of frames that are left out because a page can't compute with their positions."""

    def index_of(self, name: str) -> int:
        """Return the index of a frame; -1 if it is not known at this time."""
        return self.names.index(name) if name in self.names else -1

    def without(self, hidden: Collection[str]) -> FramePoses:
        """Return the others; a frame whose parent is left out has none."""
        if not hidden:
            return self
        kept = np.array([name not in hidden for name in self.names], bool)
        places = np.where(kept, np.cumsum(kept) - 1, -1)
        parents = np.append(places, -1)[self.parents]
        return FramePoses(
            [name for name in self.names if name not in hidden],
            self.positions[kept],
            self.rotations_xyzw[kept],
            parents[kept],
            self.far,
        )

    def links(self) -> NDArray[np.intp]:
        """Return the indices of the frames that have a parent (M,)."""
        return np.flatnonzero(self.parents >= 0)


class Span(NamedTuple):
    """The time for which a buffer has moving transforms."""

    start_ns: int
    end_ns: int

    def clamped(self, stamp_ns: int) -> int:
        """Return the time in the span that is nearest to a stamp."""
        return min(max(stamp_ns, self.start_ns), self.end_ns)


def span_of(buffer: Buffer) -> Span | None:
    """Return the time from the oldest to the newest moving transform; None where nothing moves."""
    moving = [edge for edge in buffer.edges() if not edge.is_static and edge.sample_count]
    if not moving:
        return None
    end_ns = max(edge.newest_ns for edge in moving)
    start_ns = min(edge.oldest_ns for edge in moving)
    # A frame whose publisher has ended keeps its history for ever: it must not stretch the slider to hours.
    if buffer.cache_time_ns is not None:
        start_ns = max(start_ns, end_ns - buffer.cache_time_ns)
    return Span(start_ns, end_ns)


def connected_from(buffer: Buffer, fixed_frame: str, span: Span) -> int:
    """Return the first time at which the frames connect with the fixed one [ns since epoch].

    It is the time from which half of those that connect at all do, or up to `LATER_NS` later, if more do then: a frame
    that is seen only now and then, as a thing that a robot finds, doesn't delay all the others.

    Args:
        buffer: The buffer.
        fixed_frame: The fixed frame.
        span: The time for which it has moving transforms.

    Returns:
        A time in the span, before its end; the start of the span where no frame ever connects.
    """
    firsts = sorted(
        first_ns for first_ns in _connections(buffer, fixed_frame, span) if first_ns < span.end_ns
    )
    if not firsts:
        return span.start_ns
    last_ns = firsts[(len(firsts) - 1) // 2] + LATER_NS
    return max(first_ns for first_ns in firsts if first_ns <= last_ns)


def _connections(buffer: Buffer, fixed_frame: str, span: Span) -> Iterator[int]:
    """Yield for each other frame from when on it connects with the fixed one, if it does [ns since epoch]."""
    neighbours: dict[str, list[tuple[str, Span]]] = {}
    for edge in buffer.edges():
        known = span if edge.is_static else Span(edge.oldest_ns, edge.newest_ns)
        neighbours.setdefault(edge.frame_id, []).append((edge.child_frame_id, known))
        neighbours.setdefault(edge.child_frame_id, []).append((edge.frame_id, known))
    # From the fixed frame on, so that each transform is looked at once, however long the chains are.
    seen = {fixed_frame}
    waiting = [(fixed_frame, span)]
    while waiting:
        name, (start_ns, end_ns) = waiting.pop()
        for other, known in neighbours.get(name, ()):
            both = Span(max(start_ns, known.start_ns), min(end_ns, known.end_ns))
            if other not in seen and both.start_ns <= both.end_ns:
                seen.add(other)
                waiting.append((other, both))
                yield both.start_ns


def default_fixed_frame(parents: Mapping[str, str | None]) -> str:
    """Return the frame that is fixed where none is chosen; empty where there are no frames.

    Args:
        parents: The parent of each frame; None for a root.
    """
    for name in USUAL_FIXED_FRAMES:
        if name in parents:
            return name
    sizes: dict[str, int] = {}
    for name in parents:
        root = root_of(parents, name)
        sizes[root] = sizes.get(root, 0) + 1
    return max(sorted(sizes), key=lambda root: sizes[root], default="")


def root_of(parents: Mapping[str, str | None], name: str) -> str:
    """Return the root of a frame's tree; of one in a loop, the last frame before it closes."""
    seen = {name}
    while (parent := parents.get(name)) is not None and parent not in seen:
        name = parent
        seen.add(name)
    return name


def frames_at(buffer: Buffer, fixed_frame: str, stamp_ns: int = LATEST) -> FramePoses:
    """Return where the frames are.

    Args:
        buffer: The buffer.
        fixed_frame: The frame in which the poses are.
        stamp_ns: The time [ns since epoch]; LATEST: for each frame the newest time at which its chain is known.

    Returns:
        The frames that are connected with the fixed frame at this time, at most `MAX_FRAMES`, and nearer than
        `MAX_COORDINATE_M`.
    """
    names: list[str] = []
    far: list[str] = []
    rows: list[tuple[float, ...]] = []
    # The edges before the names: a listener's thread may add frames between the two calls.
    parent_names = {edge.child_frame_id: edge.frame_id for edge in buffer.edges()}
    for name in buffer.frame_names():
        if len(names) == MAX_FRAMES:
            break
        try:
            pose = buffer.lookup(fixed_frame, name, stamp_ns)
        except TransformException:
            continue
        if not all(abs(part) < MAX_COORDINATE_M for part in pose.translation):
            far.append(name)
            continue
        names.append(name)
        rows.append((*pose.translation, *pose.rotation_xyzw))
    table = np.array(rows, np.float64).reshape(-1, 7)
    index = {name: number for number, name in enumerate(names)}
    parents = [index.get(parent_names.get(name, ""), -1) for name in names]
    return FramePoses(names, table[:, :3], table[:, 3:], np.array(parents, np.int64), frozenset(far))


def frames_behind(
    parents: Mapping[str, str | None], stale: Collection[str], fixed_frame: str, names: Iterable[str]
) -> set[str]:
    """Return the frames whose pose in the fixed frame depends on a stale transform.

    Args:
        parents: The parent of each frame; None for a root.
        stale: The children of stale transforms.
        fixed_frame: The fixed frame.
        names: The frames to look at.
    """
    if not stale:
        return set()
    fixed_branch = _branch(parents, fixed_frame)
    behind = set()
    for name in names:
        branch = _branch(parents, name)
        # The chain has the transforms of both branches up to where they meet: those that are in one alone.
        if any(frame in stale for frame in {*branch} ^ {*fixed_branch}):
            behind.add(name)
    return behind


def _branch(parents: Mapping[str, str | None], name: str) -> list[str]:
    branch = [name]
    seen = {name}
    while (parent := parents.get(branch[-1])) is not None and parent not in seen:
        branch.append(parent)
        seen.add(parent)
    return branch


def trail_of(buffer: Buffer, fixed_frame: str, frame: str, end_ns: int | None = None) -> NDArray[np.float64]:
    """Return the way of a frame through the fixed one (N, 3) [m], oldest first, at most `MAX_TRAIL_POINTS`.

    It is empty where the frames are not connected, or nothing between them moves.

    Args:
        buffer: The buffer.
        fixed_frame: The frame in which the points are.
        frame: The frame that moves.
        end_ns: The newest stamp [ns since epoch]; None: no bound.
    """
    try:
        positions = buffer.trajectory(fixed_frame, frame, end_ns=end_ns, strict=False).positions
    except TransformException:
        return np.empty((0, 3))
    positions = positions[are_drawable(positions)]
    step = -(-len(positions) // MAX_TRAIL_POINTS) or 1
    return positions[::-1][::step][::-1]  # the newest point is always there
