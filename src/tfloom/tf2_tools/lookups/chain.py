"""The chain between two frames: each edge's history in a buffer, and who publishes it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.model import Edge, Observation, stored_name
from tfloom.tf2_tools.watch.tree import Tree

__all__ = ["Chain", "Span", "find_chain", "tree_of"]


@dataclass(frozen=True)
class Span:
    """An edge of the chain, and the history of it that the buffer holds."""

    child: str
    parent: str
    is_static: bool
    oldest_ns: int
    """The oldest stamp [ns since epoch]; 0 if static."""
    newest_ns: int
    """The newest one."""
    sample_count: int
    sources: Sequence[Edge]
    """What each publisher has sent for this edge, in order of last receipt."""
    is_up: bool
    """Whether the way from source to target leads from the child to the parent."""

    @property
    def name(self) -> str:
        """The edge as text, from the parent to the child."""
        return f"{self.parent} -> {self.child}"

    @property
    def publishers(self) -> str:
        """The labels of its publishers, the last one first."""
        labels = dict.fromkeys(edge.publisher.label for edge in reversed(self.sources))
        return " and ".join(labels) or "unknown"

    @property
    def last(self) -> Edge | None:
        """What the publisher of the last receipt has sent."""
        return self.sources[-1] if self.sources else None


@dataclass(frozen=True)
class Chain:
    """The edges from the source to the target."""

    spans: Sequence[Span]
    top: str
    """The frame in which the two branches meet."""

    @property
    def moving(self) -> list[Span]:
        """The edges that aren't static."""
        return [span for span in self.spans if not span.is_static]

    @property
    def first_to_end(self) -> Span | None:
        """The edge whose newest stamp is the oldest: it limits the newest time; None if all are static."""
        return min(self.moving, key=lambda span: span.newest_ns, default=None)

    @property
    def last_to_begin(self) -> Span | None:
        """The edge whose oldest stamp is the newest: it limits the oldest time; None if all are static."""
        return max(self.moving, key=lambda span: span.oldest_ns, default=None)


def tree_of(buffer: Buffer) -> Tree:
    """Return the frames of a buffer by their newest parents."""
    return Tree({edge.child_frame_id: edge.frame_id for edge in buffer.edges()})


def find_chain(buffer: Buffer, seen: Observation, target: str, source: str) -> Chain | None:
    """Return the chain between two frames; None if they are not connected, or one is unknown."""
    tree = tree_of(buffer)
    if target not in tree or source not in tree or (ways := tree.chain(target, source)) is None:
        return None
    # Up from the source to the frame where both branches meet, then down to the target, in the order of the lookup.
    up, down = ways
    links = [(child, True) for child in up[:-1]] + [(child, False) for child in reversed(down[:-1])]
    stored = {edge.child_frame_id: edge for edge in buffer.edges()}
    sources: dict[str, list[Edge]] = {}
    for edge in seen.by_receipt:
        sources.setdefault(stored_name(edge.child), []).append(edge)
    spans = [
        Span(
            child,
            stored[child].frame_id,
            stored[child].is_static,
            stored[child].oldest_ns,
            stored[child].newest_ns,
            stored[child].sample_count,
            [edge for edge in sources.get(child, ()) if stored_name(edge.parent) == stored[child].frame_id],
            is_up,
        )
        for child, is_up in links
    ]
    return Chain(spans, up[-1])
