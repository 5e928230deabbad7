"""What a diagnosis is about: an observation, data that names frames, and texts for findings."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

from tfloom.tf2_tools.diagnosis.finding import Evidence, Finding, Source
from tfloom.tf2_tools.watch.model import STATIC_TOPIC, Edge, Observation, Publisher, stored_name
from tfloom.tf2_tools.watch.tree import Tree

SHOWN = 4
"""Number of names that a sentence lists."""
MAX_COMPARED_FRAMES = 2000
"""Number of frames up to which a misspelled one is looked for among them."""


@dataclass(frozen=True)
class FrameUse:
    """A frame that a publisher's data, or a client's lookups, name."""

    frame: str
    source: Source
    count: int
    """Number of messages, or requests."""


@dataclass(frozen=True)
class Subject:
    """All that the checks look at."""

    seen: Observation
    times_ns: tuple[int, int]
    """When it began and ended, by the clock of the receipts [ns since epoch]."""
    headers: Sequence[FrameUse] = ()
    """Frames in the headers of topics."""
    requests: Sequence[FrameUse] = ()
    """Frames in requests to buffer servers."""
    static_topic: str = STATIC_TOPIC
    """The topic of static transforms."""
    other_topics: Sequence[str] = ()
    """Other topics of transforms on the graph."""
    is_simulated: bool = False
    """Whether stamps were compared with /clock."""

    @cached_property
    def edges(self) -> list[Edge]:
        """The edges that a listener stores: without those of a frame to itself, and without empty frame ids."""
        return [edge for edge in self.seen.edges if edge.child and edge.parent and not is_own_parent(edge)]

    @cached_property
    def edges_of(self) -> dict[str, list[Edge]]:
        """The edges of each child, by its name as listeners store it."""
        edges_by_child: dict[str, list[Edge]] = {}
        for edge in self.edges:
            edges_by_child.setdefault(stored_name(edge.child), []).append(edge)
        return edges_by_child

    @cached_property
    def tree(self) -> Tree:
        """The frames by their parents, without leading slashes, as listeners store them."""
        ordered = sorted(self.edges, key=lambda edge: edge.statistics.last_received_ns)
        return Tree({stored_name(edge.child): stored_name(edge.parent) for edge in ordered})

    @cached_property
    def frames(self) -> set[str]:
        """The frames that a listener knows."""
        return set(self.tree.frames())

    @cached_property
    def moving(self) -> list[Edge]:
        """The edges on /tf."""
        return [edge for edge in self.edges if not edge.is_static]

    @property
    def duration_s(self) -> float:
        """How long was observed [s]."""
        return (self.times_ns[1] - self.times_ns[0]) / 1e9

    def near(self, frame: str) -> str:
        """Return a hint at a known frame that is spelled alike; empty if there is none."""
        return near_frame(stored_name(frame), self.frames)


def near_frame(frame: str, known: Collection[str]) -> str:
    """Return a hint at one of the known frames that is spelled alike; empty if there is none, or there are too many."""
    return _near_frame(frame, tuple(sorted(known))) if len(known) <= MAX_COMPARED_FRAMES else ""


@lru_cache(64)  # a display that can't be drawn asks again for each picture
def _near_frame(frame: str, known: tuple[str, ...]) -> str:
    names = difflib.get_close_matches(frame, known, 1, 0.6)
    return f"; did you mean {names[0]}?" if names else ""


def is_own_parent(edge: Edge) -> bool:
    """Return whether both of an edge's frames are the same."""
    return stored_name(edge.child) == stored_name(edge.parent)


def source_of(publisher: Publisher) -> Source:
    """Return a publisher as the source of a finding."""
    node = "" if publisher.node is None else publisher.node.full
    return Source(node, publisher.topic, "" if publisher.origin else publisher.gid.hex())


def sources_of(edges: Iterable[Edge]) -> list[Source]:
    """Return the publishers of edges as the sources of a finding, in order, each once."""
    return sorted({source_of(edge.publisher) for edge in edges})


def edge_text(edge: Edge) -> str:
    """Return an edge as `parent -> child`."""
    return f"{edge.parent or chr(39) * 2} -> {edge.child or chr(39) * 2}"


def listed(things: Iterable[object]) -> str:
    """Return the names of things, as of sources, with commas; the first few of many."""
    names = list(map(str, things))
    more = f" and {len(names) - SHOWN} more" if len(names) > SHOWN else ""
    return ", ".join(names[:SHOWN]) + more


def evidence_of(edge: Edge, text: str, **figures: str | float | None) -> Evidence:
    """Return evidence about an edge, with its frames and its publisher among the figures."""
    source = source_of(edge.publisher)
    about = {"parent": edge.parent, "child": edge.child, "node": source.node, "topic": source.topic}
    return Evidence(f"{edge_text(edge)}: {text}", {**about, **figures})


def by_publisher(edges: Iterable[Edge]) -> Iterator[tuple[Source, list[Edge]]]:
    """Yield the edges of each publisher."""
    groups: dict[Source, list[Edge]] = {}
    for edge in edges:
        groups.setdefault(source_of(edge.publisher), []).append(edge)
    yield from groups.items()


def for_each_publisher(code: str, what: str, edges: Iterable[tuple[Edge, Evidence]]) -> Iterator[Finding]:
    """Yield a finding for each publisher of these edges.

    Args:
        code: The findings' code.
        what: What its publisher does to them: `sends {} with the stamp zero`.
        edges: Each edge, and what was seen of it.
    """
    by_id = {id(edge): (edge, evidence) for edge, evidence in edges}
    for source, group in by_publisher(edge for edge, _ in by_id.values()):
        names = listed(dict.fromkeys(edge_text(edge) for edge in group))
        frames = sorted({stored_name(edge.child) for edge in group if edge.child})
        summary = f"{source} {what.format(names)}"
        yield Finding(code, summary, [source], frames, [by_id[id(edge)][1] for edge in group])


def begins_with_header(type_name: str) -> bool:
    """Return whether the messages of a type begin with a std_msgs/msg/Header; False if the type is unknown here."""
    from tfloom.rosidl.registry import get_message_class

    try:
        fields = get_message_class(type_name).get_fields_and_field_types()
    except (LookupError, ValueError):
        return False
    return next(iter(fields.values()), "") == "std_msgs/Header"
