"""The tree as data, and the explanation of a failed lookup."""

from __future__ import annotations

from typing import NamedTuple

from tfloom import _native
from tfloom._native import Edge
from tfloom.tf2.errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    TransformException,
)

__all__ = ["Edge", "Explanation", "Frames"]


class Explanation(NamedTuple):
    """The chain of a lookup, and the reason why it fails."""

    target_frame: str
    """The frame of the result."""
    source_frame: str
    """The frame that was looked up in it."""
    stamp_ns: int
    """The requested time [ns since epoch]; 0 is the latest."""
    chain: list[str]
    """The frames from the source to the target; where they are not connected, the path from each to its root."""
    edges: list[Edge]
    """The stored history of each link of the chain."""
    error: TransformException | None
    """The exception that `lookup` raises, or None."""
    failing_edge: Edge | None
    """The link that lacks the time, or None."""
    remedy: str
    """How to resolve the failure; empty if the lookup succeeds."""

    def __str__(self) -> str:
        lines = [self._answer()]
        for edge, frame_id in zip(self.edges, self._parents(), strict=True):
            line = f"  {frame_id} -> {edge.child_frame_id}: {_span(edge)}"
            if frame_id != edge.frame_id:
                line += f"; its present parent is {edge.frame_id}"
            lines.append(line + (" <-- here" if edge is self.failing_edge else ""))
        if self.remedy:
            lines.append(self.remedy)
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        """Return what a notebook shows: the chain as a table."""
        from tfloom.tf2.html import chain_html

        links = list(zip(self._parents(), self.edges, strict=True))
        return chain_html(self._answer(), links, self.failing_edge, self.remedy)

    def _answer(self) -> str:
        stamp = "the latest time" if self.stamp_ns == 0 else f"{self.stamp_ns / 1e9:.6f}"
        return (
            f"{self.target_frame} from {self.source_frame} at {stamp}: {str(self.error or 'known').rstrip()}"
        )

    def _parents(self) -> list[str]:
        """Return the parent in each edge at the requested time; the newest parent where the chain is incomplete."""
        if len(self.edges) != len(self.chain) - 1:
            return [edge.frame_id for edge in self.edges]
        pairs = zip(self.edges, self.chain, self.chain[1:], strict=False)
        return [after if edge.child_frame_id == before else before for edge, before, after in pairs]


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" + ("" if number == 1 else "s")


class Frames(_native.Buffer):
    """The part of a buffer that returns its tree."""

    def __str__(self) -> str:
        edges = self.edges()
        text = f"{_count(len(self.frame_names()), 'frame')}, "
        text += _count(sum(edge.sample_count for edge in edges), "transform")
        moving = [edge for edge in edges if not edge.is_static]
        if moving:
            begin_ns = min(edge.oldest_ns for edge in moving)
            end_ns = max(edge.newest_ns for edge in moving)
            text += f", from {begin_ns / 1e9:.3f} to {end_ns / 1e9:.3f} ({(end_ns - begin_ns) / 1e9:.3f} s)"
        return f"{type(self).__name__}: {text}"

    def __repr__(self) -> str:
        return f"<{self}>"

    def _repr_html_(self) -> str:
        """Return what a notebook shows: the tree."""
        from tfloom.tf2.html import tree_html

        return tree_html(self)

    def parents(self) -> dict[str, str | None]:
        """Return each frame's parent, by its newest sample; None for a root."""
        parents = {edge.child_frame_id: edge.frame_id for edge in self.edges()}
        return {name: parents.get(name) for name in self.frame_names()}

    def children(self) -> dict[str, list[str]]:
        """Return each frame's children, in the order in which they were first inserted."""
        edges = self.edges()  # before the names, because a listener's thread may add frames
        children: dict[str, list[str]] = {name: [] for name in self.frame_names()}
        for edge in edges:
            children[edge.frame_id].append(edge.child_frame_id)
        return children

    def chain(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> list[str]:
        """Return the frames of a lookup's chain, from the source to the target. Raises as `lookup` does."""
        return self.path(target_frame, source_frame, stamp_ns)

    def common_time(self, *frames: str) -> int:
        """Return the newest time at which all of these frames are known to each other [ns since epoch].

        0 if all transforms between them are static; for one frame, its newest stamp. Raises as `latest_common_time`
        does, and ValueError without a frame.
        """
        if not frames:
            raise ValueError("common_time needs the name of a frame, or of several")
        first, *others = frames
        stamps = [self.latest_common_time(first, other) for other in others or [first]]
        return min((stamp for stamp in stamps if stamp != 0), default=0)

    def explain(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> Explanation:
        """Return the chain of a lookup: each link's history, which link fails, and how to resolve it."""
        error = self._error(target_frame, source_frame, stamp_ns)
        by_child = {edge.child_frame_id: edge for edge in self.edges()}
        if error is None and target_frame != source_frame:
            down, up = self.branches(target_frame, source_frame, stamp_ns)
            while up and down and up[-1] == down[-1]:  # the part above the common ancestor
                up.pop()
                down.pop()
            chain = self.path(target_frame, source_frame, stamp_ns)
        else:
            up, down = _branches_by_newest(target_frame, source_frame, by_child)
            is_whole = bool(up and down and up[-1] == down[-1])
            chain = [*up, *reversed(down[:-1] if is_whole else down)]
            if is_whole:
                up, down = up[:-1], down[:-1]
        edges = [by_child[frame] for frame in [*up, *reversed(down)] if frame in by_child]
        failing = None
        if isinstance(error, ExtrapolationException):
            failing = next((edge for edge in edges if edge.child_frame_id == error.frame_id), None)
        remedy = "" if error is None else _remedy(error, failing, (up, down), edges, self)
        if failing is not None and len(edges) < len(chain) - 1:
            remedy += f" Also, {down[-1]}, the root above one end, is not connected with {up[-1]}."
        return Explanation(target_frame, source_frame, stamp_ns, chain, edges, error, failing, remedy)

    def _error(self, target_frame: str, source_frame: str, stamp_ns: int) -> TransformException | None:
        try:
            self.lookup(target_frame, source_frame, stamp_ns)
        except TransformException as error:
            return error
        return None


def _branches_by_newest(target: str, source: str, by_child: dict[str, Edge]) -> tuple[list[str], list[str]]:
    """Return the paths up from source and target: both to their common ancestor, or each to its root."""
    up, down = _way_up(source, by_child, target), _way_up(target, by_child, source)
    if up[-1] == target:
        return up, [target]
    if down[-1] == source:
        return [source], down
    top = next((frame for frame in up if frame in down), None)
    return (up, down) if top is None else (up[: up.index(top) + 1], down[: down.index(top) + 1])


def _way_up(frame: str, by_child: dict[str, Edge], end: str = "") -> list[str]:
    way = [frame]
    while way[-1] != end and way[-1] in by_child and by_child[way[-1]].frame_id not in way:
        way.append(by_child[way[-1]].frame_id)
    return way


def _span(edge: Edge) -> str:
    by = f" by {edge.authority}" if edge.authority else ""
    if edge.is_static:
        return f"static{by}"
    length_s = (edge.newest_ns - edge.oldest_ns) / 1e9
    rate = f", {edge.sample_count / length_s:.1f} Hz" if length_s > 0 else ""
    span = f"{edge.oldest_ns / 1e9:.6f} to {edge.newest_ns / 1e9:.6f}"
    samples = "1 sample" if edge.sample_count == 1 else f"{edge.sample_count} samples"
    return f"{span}, {samples}{rate}{by}"


def _remedy(
    error: TransformException,
    failing: Edge | None,
    branches: tuple[list[str], list[str]],
    edges: list[Edge],
    frames: Frames,
) -> str:
    up, down = branches
    if isinstance(error, ExtrapolationException):
        return _remedy_of_gap(error, failing, edges)
    names = [down[0], up[0]] if up and down else []
    if isinstance(error, InvalidArgumentException):
        stripped = next((name.lstrip("/") for name in names if name.startswith("/")), "")
        return (
            f"Request {stripped}, without the slash." if stripped else "Both frame names must be non-empty."
        )
    unknown = [name for name in names if not frames.has_frame(name)]
    if unknown:
        return f"No transform of {' or '.join(unknown)} has been received: check the name, and that its publisher runs."
    if isinstance(error, ConnectivityException):
        return f"Publish a transform that connects {down[-1]}, the root above one end, with {up[-1]}."
    circle = _circle(frames.parents(), names)
    if circle:
        return f"Find the publishers of this loop of parents: {', '.join(circle)}."
    return "A chain of more than 1000 links is treated as a loop: shorten it."


def _circle(parents: dict[str, str | None], starts: list[str]) -> list[str]:
    """Return the frames of the first loop of parents above any of these frames; empty without a loop."""
    for start in starts:
        way: list[str] = []
        frame: str | None = start
        while frame is not None and frame not in way:
            way.append(frame)
            frame = parents.get(frame)
        if frame is not None:
            return way[way.index(frame) :]
    return []


def _remedy_of_gap(error: ExtrapolationException, failing: Edge | None, edges: list[Edge]) -> str:
    if failing is None or error.requested_ns is None:
        return f"Nothing is stored of {error.frame_id} now: is its publisher running?"
    moving = [edge for edge in edges if not edge.is_static]
    first, last = max(edge.oldest_ns for edge in moving), min(edge.newest_ns for edge in moving)
    name, gap_s = failing.child_frame_id, (error.gap_ns or 0) / 1e9
    if first > last:
        return f"The frames have no common time: {name} alone misses the requested time by {gap_s:.6f} s."
    if error.requested_ns > failing.newest_ns:
        return (
            f"{name} ends {gap_s:.6f} s before the requested time: wait for it with a timeout, or request a time up "
            f"to {last / 1e9:.6f}."
        )
    return (
        f"{name} begins {gap_s:.6f} s after the requested time: request a time from {first / 1e9:.6f} on, or keep "
        "more history."
    )
