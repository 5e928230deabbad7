"""The tree as data, and why a lookup fails."""

from __future__ import annotations

from typing import NamedTuple

from tfloom import _native
from tfloom._native import Edge
from tfloom.tf2.errors import ExtrapolationException, TransformException

__all__ = ["Edge", "Explanation", "Frames"]


class Explanation(NamedTuple):
    """What a lookup would go through, and what stands in its way."""

    target_frame: str
    source_frame: str
    stamp_ns: int
    """The time asked for; 0: the latest."""
    chain: list[str]
    """The frames from the source to the target; where they are not connected, each one's way up to its root."""
    edges: list[Edge]
    """What is known of each link of the chain."""
    error: TransformException | None
    """What `lookup` raises, or None."""
    failing_edge: Edge | None
    """The link that lacks the time, or None."""
    remedy: str
    """What would mend it; empty if there is an answer."""

    def __str__(self) -> str:
        asked = "the latest time" if self.stamp_ns == 0 else f"{self.stamp_ns / 1e9:.6f}"
        lines = [f"{self.target_frame} from {self.source_frame} at {asked}: {self.error or 'known'}"]
        for edge in self.edges:
            mark = " <-- here" if edge is self.failing_edge else ""
            lines.append(f"  {edge.frame_id} -> {edge.child_frame_id}: {_span(edge)}{mark}")
        if self.remedy:
            lines.append(self.remedy)
        return "\n".join(lines)


class Frames(_native.Buffer):
    """The part of a buffer that shows its tree."""

    def parents(self) -> dict[str, str | None]:
        """Return each frame's parent, by its newest sample; None for a root."""
        known = {edge.child_frame_id: edge.frame_id for edge in self.edges()}
        return {name: known.get(name) for name in self.frame_names()}

    def children(self) -> dict[str, list[str]]:
        """Return each frame's children, in order of first mention."""
        children: dict[str, list[str]] = {name: [] for name in self.frame_names()}
        for edge in self.edges():
            children[edge.frame_id].append(edge.child_frame_id)
        return children

    def chain(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> list[str]:
        """Return the frames that a lookup goes through, from the source to the target. Raises as `lookup` does."""
        if target_frame == source_frame and self.has_frame(source_frame):
            return [source_frame]
        down, up = self.branches(target_frame, source_frame, stamp_ns)
        top = self.parents()[(up or down)[-1]]
        while up and down and up[-1] == down[-1]:  # what is above where they meet
            top = up.pop()
            down.pop()
        return [*up, *([] if top is None else [top]), *reversed(down)]

    def common_time(self, *frames: str) -> int:
        """Return the newest time at which all of these frames are known to each other [ns since epoch].

        0 if all that is between them is static. Raises as `latest_common_time` does.
        """
        first, *others = frames
        stamps = [self.latest_common_time(first, other) for other in others]
        return min((stamp for stamp in stamps if stamp != 0), default=0)

    def explain(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> Explanation:
        """Tell what a lookup goes through: each link's history, which of them fails, and what would mend it."""
        error = self._error(target_frame, source_frame, stamp_ns)
        by_child = {edge.child_frame_id: edge for edge in self.edges()}
        up = _way_up(source_frame, by_child)
        down = _way_up(target_frame, by_child)
        top = next((frame for frame in up if frame in down), None)
        if top is not None:
            up, down = up[: up.index(top)], down[: down.index(top)]
        chain = [*up, *([] if top is None else [top]), *reversed(down)]
        edges = [by_child[frame] for frame in [*up, *reversed(down)] if frame in by_child]
        failing = None
        if isinstance(error, ExtrapolationException):
            failing = next((edge for edge in edges if edge.child_frame_id == error.frame_id), None)
        remedy = _remedy(error, failing, up, down, self)
        return Explanation(target_frame, source_frame, stamp_ns, chain, edges, error, failing, remedy)

    def _error(self, target_frame: str, source_frame: str, stamp_ns: int) -> TransformException | None:
        try:
            self.lookup(target_frame, source_frame, stamp_ns)
        except TransformException as error:
            return error
        return None


def _way_up(frame: str, by_child: dict[str, Edge]) -> list[str]:
    way = [frame]
    while way[-1] in by_child and by_child[way[-1]].frame_id not in way:
        way.append(by_child[way[-1]].frame_id)
    return way


def _span(edge: Edge) -> str:
    by = f" by {edge.authority}" if edge.authority else ""
    if edge.is_static:
        return f"static{by}"
    length_s = (edge.newest_ns - edge.oldest_ns) / 1e9
    rate = f", {edge.sample_count / length_s:.1f} Hz" if length_s > 0 else ""
    span = f"{edge.oldest_ns / 1e9:.6f} to {edge.newest_ns / 1e9:.6f}"
    return f"{span}, {edge.sample_count} samples{rate}{by}"


def _remedy(
    error: TransformException | None, failing: Edge | None, up: list[str], down: list[str], frames: Frames
) -> str:
    if error is None:
        return ""
    if isinstance(error, ExtrapolationException):
        return _remedy_of_gap(error, failing)
    unknown = [name for name in (down[0], up[0]) if not frames.has_frame(name)] if up and down else []
    if unknown:
        return (
            f"Nobody has published {' or '.join(unknown)} yet: check the name, and that its publisher runs."
        )
    if up and down and up[-1] != down[-1]:
        return f"Publish a transform that connects {down[-1]}, the root above one end, with {up[-1]}."
    return "See that no two publishers make a circle of parents."


def _remedy_of_gap(error: ExtrapolationException, failing: Edge | None) -> str:
    if failing is None or error.requested_ns is None:
        return f"Nothing is stored of {error.frame_id} now: is its publisher running?"
    gap_s = (error.gap_ns or 0) / 1e9
    if error.requested_ns > failing.newest_ns:
        return (
            f"{failing.child_frame_id} ends {gap_s:.6f} s before the time asked for: wait for it with a timeout, or "
            f"ask for a time up to {failing.newest_ns / 1e9:.6f}."
        )
    return (
        f"{failing.child_frame_id} begins {gap_s:.6f} s after the time asked for: ask for a time from "
        f"{failing.oldest_ns / 1e9:.6f} on, or keep more history."
    )
