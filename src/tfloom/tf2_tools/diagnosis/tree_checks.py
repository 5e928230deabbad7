"""Checks of the tree: who publishes which edge, and whether the edges form one tree."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from tfloom.rmw.base import PREFIX_LENGTH
from tfloom.tf2_tools.diagnosis.catalogue import Limits
from tfloom.tf2_tools.diagnosis.finding import Evidence, Finding
from tfloom.tf2_tools.diagnosis.subject import (
    Subject,
    evidence_of,
    for_each_publisher,
    is_own_parent,
    listed,
    source_of,
    sources_of,
)
from tfloom.tf2_tools.text import counted
from tfloom.tf2_tools.watch.model import Edge, Publisher, stored_name


def check_tree(subject: Subject, limits: Limits) -> Iterator[Finding]:
    """Yield the findings on the tree."""
    if not (subject.seen.edges or subject.seen.unrecorded):
        yield _silence_finding(subject)
    for child, edges in subject.edges_of.items():
        yield from _shared_child(child, edges)
        yield from _mixed_child(child, edges)
        yield from _reparented_child(subject, child, edges)
    yield from _loops(subject)
    yield from _separate_trees(subject)
    yield from _rejected_edges(subject)


def _silence_finding(subject: Subject) -> Finding:
    sources = [source_of(publisher) for publisher in subject.seen.publishers]
    who = f"from {listed(sources)}" if sources else "and there is no publisher"
    evidence = [
        Evidence(f"transforms are on {topic}: try `--tf-topic {topic}`", {"topic": topic})
        for topic in subject.other_topics
    ]
    return Finding(
        "TF108", f"no transform came within {subject.duration_s:.1f} s {who}", sources, [], evidence
    )


def _owner(publisher: Publisher) -> tuple[str, bytes]:
    """Return what is the same for all publishers of one node: its name, and its participant's part of the gid."""
    return publisher.name, publisher.gid[:PREFIX_LENGTH]


def _are_at_once(edges: list[Edge]) -> bool:
    """Return whether edges of several publishers are sent at the same time.

    A node that was restarted sends after the former one, which the graph may list for a while if it was killed.
    """
    # Present publishers of different names are different nodes. Two of one name may be a node that was killed, which
    # the graph lists until its lease ends, and its successor: then the times of sending decide, below. A static
    # transform is sent once, so its times can't overlap; what is present counts.
    present = {_owner(edge.publisher) for edge in edges if not edge.publisher.has_left}
    if len(present) > 1 and (edges[0].is_static or len({name for name, _ in present}) > 1):
        return True
    # A node may have sent to several parents: its span is from the first of these edges to the last.
    spans: dict[tuple[str, bytes], tuple[int, int]] = {}
    for edge in edges:
        statistics, owner = edge.statistics, _owner(edge.publisher)
        begin, end = spans.get(owner, (statistics.first_received_ns, statistics.last_received_ns))
        spans[owner] = min(begin, statistics.first_received_ns), max(end, statistics.last_received_ns)
    return any(later[0] < former[1] for former, later in pairwise(sorted(spans.values())))


def _shared_child(child: str, edges: list[Edge]) -> Iterator[Finding]:
    for is_static in (False, True):
        same = [edge for edge in edges if edge.is_static is is_static]
        owners = {_owner(edge.publisher) for edge in same}
        if len(owners) < 2 or not _are_at_once(same):
            continue
        summary = f"{len(owners)} publishers send {child}: {listed(sources_of(same))}"
        yield _finding("TF101", summary, [child], same)


def _mixed_child(child: str, edges: list[Edge]) -> Iterator[Finding]:
    if len({edge.is_static for edge in edges}) < 2:
        return
    summary = f"{child} is static and dynamic: {listed(sources_of(edges))}"
    yield _finding("TF102", summary, [child], edges)


def _reparented_child(subject: Subject, child: str, edges: list[Edge]) -> Iterator[Finding]:
    parents = list(dict.fromkeys(stored_name(edge.parent) for edge in edges))
    spellings = {edge.child for edge in edges}
    changes = sum(
        subject.seen.children[name].reparented for name in spellings if name in subject.seen.children
    )
    # A frame that moves to a new parent for good changes once for each further parent. More changes than that are
    # returns to a parent that it had left.
    if len(parents) < 2 or changes < len(parents):
        return
    summary = f"{child} changed its parent {changes} times, between {listed(parents)}"
    yield _finding("TF103", summary, [child], edges)


def _finding(code: str, summary: str, frames: list[str], edges: list[Edge]) -> Finding:
    """Return a finding on edges, with their publishers and their rates."""
    return Finding(code, summary, sources_of(edges), frames, [_rate_evidence(edge) for edge in edges])


def _rate_evidence(edge: Edge) -> Evidence:
    source, count = source_of(edge.publisher), edge.statistics.count
    rate = f"{count} in all" if edge.is_static else f"{edge.rate_hz:.1f} Hz, {count} in all"
    return evidence_of(edge, f"{source}, {rate}", rate_hz=round(edge.rate_hz, 3), count=count)


def _loops(subject: Subject) -> Iterator[Finding]:
    for loop in subject.tree.loops():
        parents = zip(loop, [*loop[1:], loop[0]], strict=True)
        edges = [e for child, up in parents for e in subject.edges_of[child] if stored_name(e.parent) == up]
        way = " -> ".join([*reversed(loop), loop[-1]])
        yield _finding("TF104", f"the frames {way} form a loop", loop, edges)


def _separate_trees(subject: Subject) -> Iterator[Finding]:
    tree = subject.tree
    in_loops = {frame for loop in tree.loops() for frame in loop}
    roots = [root for root in tree.roots() if root not in in_loops]
    if len(roots) < 2:
        return
    members = {root: [frame for _, frame in tree.walk(root)] for root in roots}
    # The largest tree is taken for the right one; the publishers of the others are to be mended.
    roots.sort(key=lambda root: (-len(members[root]), root))
    outer = {frame for root in roots[1:] for frame in members[root]}
    sources = sources_of(edge for frame in outer for edge in subject.edges_of.get(frame, ()))
    evidence = [
        Evidence(f"the tree of {root}: {listed(members[root])}", {"root": root, "frames": len(members[root])})
        for root in roots
    ]
    yield Finding(
        "TF105",
        f"there are {len(roots)} trees, of {listed(roots)}; the smaller ones are from {listed(sources)}",
        sources,
        roots,
        evidence,
    )


def _rejected_edges(subject: Subject) -> Iterator[Finding]:
    """Yield the findings on edges that no listener stores."""
    all_edges = [
        (edge, evidence_of(edge, counted(edge.statistics.count, "time"), count=edge.statistics.count))
        for edge in subject.seen.edges
    ]
    empty = [(edge, evidence) for edge, evidence in all_edges if not (edge.child and edge.parent)]
    own = [(edge, evidence) for edge, evidence in all_edges if edge.child and is_own_parent(edge)]
    yield from for_each_publisher("TF106", "sends a frame as its own parent: {}", own)
    yield from for_each_publisher("TF107", "sends an empty frame id: {}", empty)
