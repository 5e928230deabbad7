"""Checks of frames' names: leading slashes, and the names and order of REP 105."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise

from tfloom.tf2_tools.diagnosis.catalogue import Limits
from tfloom.tf2_tools.diagnosis.finding import Finding
from tfloom.tf2_tools.diagnosis.subject import (
    Subject,
    evidence_of,
    for_each_publisher,
    listed,
    source_of,
    sources_of,
)
from tfloom.tf2_tools.text import counted

CONVENTIONAL = ("earth", "map", "odom", "base_link", "base_footprint")
"""The frames of REP 105 from the outermost inward, and that of REP 120."""
_ORDERS = (CONVENTIONAL[:4], (*CONVENTIONAL[:3], "base_footprint"))
"""base_footprint may be above base_link or below it."""
_BY_LETTERS = {name.replace("_", ""): name for name in CONVENTIONAL}


def check_names(subject: Subject, limits: Limits) -> Iterator[Finding]:
    """Yield the findings on names."""
    slashed = [
        (edge, evidence_of(edge, counted(edge.statistics.count, "time"), count=edge.statistics.count))
        for edge in subject.seen.edges
        if edge.child.startswith("/") or edge.parent.startswith("/")
    ]
    yield from for_each_publisher("TF201", "sends frame ids with a leading slash: {}", slashed)
    yield from _unchecked_transforms(subject)
    for prefix in sorted({frame.rpartition("/")[0] for frame in subject.frames}):
        yield from _misordered_frames(subject, f"{prefix}/" if prefix else "")
    for frame in sorted(subject.frames):
        yield from _misspelled_frame(subject, frame)


def _unchecked_transforms(subject: Subject) -> Iterator[Finding]:
    """Yield a finding for the transforms beyond the observer's limits, with the publishers that send them."""
    if not subject.seen.unrecorded:
        return
    recorded: Counter[tuple[bytes, str]] = Counter()
    for edge in subject.seen.edges:
        recorded[edge.publisher.gid, edge.topic] += edge.statistics.count
    sources = [
        source_of(publisher)
        for publisher in subject.seen.publishers
        if publisher.traffic is not None
        and publisher.traffic.transforms > recorded[publisher.gid, publisher.topic]
    ]
    who = f" of {listed(sources)}" if sources else ""
    unchecked = counted(subject.seen.unrecorded, "transform")
    yield Finding(
        "TF204",
        f"{unchecked}{who} can't be checked: a name of more than 1,024 bytes, or too many edges or publishers",
        sources,
    )


def _misordered_frames(subject: Subject, prefix: str) -> Iterator[Finding]:
    """Yield a finding for each frame of a robot that doesn't hang below the one that REP 105 puts above it."""
    told = set()
    for order in _ORDERS:
        present = [prefix + name for name in order if prefix + name in subject.frames]
        for outer, inner in pairwise(present):
            if (outer, inner) not in told and not _is_below(subject, inner, outer):
                told.add((outer, inner))
                yield _order_finding(subject, outer, inner)


def _is_below(subject: Subject, inner: str, outer: str) -> bool:
    """Return whether a frame hangs below another one, or in another tree."""
    tree = subject.tree
    return outer in tree.branch(inner)[1:] or tree.root(inner) != tree.root(outer)


def _order_finding(subject: Subject, outer: str, inner: str) -> Finding:
    tree = subject.tree
    outer_branch = tree.branch(outer)
    is_reversed = inner in outer_branch
    # In a reversed order, every edge from the outer frame up to the inner one is wrong; otherwise only the inner's own.
    chain = outer_branch[: outer_branch.index(inner)] if is_reversed else [inner]
    edges = [edge for frame in chain for edge in subject.edges_of[frame]]
    sources = sources_of(edges)
    summary = (
        f"{outer} hangs below {inner}, but REP 105 puts {inner} below {outer}"
        if is_reversed
        else f"{inner} does not hang below {outer}, as REP 105 has it, but below {tree.parents.get(inner, 'no frame')}"
    )
    evidence = [evidence_of(edge, f"from {source_of(edge.publisher)}") for edge in edges]
    return Finding("TF202", summary, sources, [outer, inner], evidence)


def _misspelled_frame(subject: Subject, frame: str) -> Iterator[Finding]:
    prefix, slash, name = frame.rpartition("/")
    meant = _BY_LETTERS.get("".join(letter for letter in name.lower() if letter.isalnum()))
    if meant is None or name == meant:
        return
    near = [frame, *subject.tree.children.get(frame, ())]
    edges = [e for child in near for e in subject.edges_of.get(child, ()) if frame in e.frames]
    sources = sources_of(edges)
    yield Finding(
        "TF203",
        f"{frame} is {prefix}{slash}{meant} in REP 105; it is from {listed(sources)}",
        sources,
        [frame],
        [evidence_of(edge, f"from {source_of(edge.publisher)}") for edge in edges],
    )
