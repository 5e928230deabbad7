"""Sentences on a lookup: what prevents it, and what to do."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable

from tfloom.tf2_tools.explanation.chain import Span
from tfloom.tf2_tools.explanation.durations import NS_PER_S, seconds_text
from tfloom.tf2_tools.explanation.lookup import Lookup, Outcome
from tfloom.tf2_tools.watch.model import Edge
from tfloom.tf2_tools.watch.tree import Tree

__all__ = ["advise", "remark"]

STALE_PERIODS = 5.0
"""A publisher that has sent nothing for this many of its longest periods is said to have stopped."""
LEAST_STALE_S = 0.5
"""And not before this time [s]."""
LARGE_DELAY_S = 1.0
"""A mean delay above this points to clocks or to old data, rather than to computing [s]."""
SIMULATED_NS = 86_400 * 365 * 1_000_000_000
"""Stamps below this, a year after the epoch, are those of a simulation [ns]."""


def advise(lookup: Lookup) -> list[str]:
    """Return what prevents a lookup and what to do, as sentences; empty if it succeeds."""
    return _ADVICE[lookup.outcome](lookup) if lookup.outcome in _ADVICE else []


def remark(lookup: Lookup) -> list[str]:
    """Return what is unsound in the chain, although it may not prevent the lookup."""
    remarks = []
    for span in lookup.chain.spans if lookup.chain is not None else ():
        edges = lookup.seen.edges_of(span.child)
        names = list(dict.fromkeys(edge.publisher.label for edge in edges))
        if len({edge.publisher.gid for edge in edges}) > 1:
            remarks.append(f"{span.child!r} has {len(edges)} sources: {'; '.join(map(_source, edges))}.")
        elif len({edge.parent for edge in edges}) > 1:
            parents = " and ".join(sorted({repr(edge.parent) for edge in edges}))
            remarks.append(f"{names[0]} sends {span.child!r} with the parents {parents}.")
        if len({edge.is_static for edge in edges}) > 1:
            remarks.append(f"{span.child!r} is both static and moving: a buffer keeps only what came last.")
    return remarks


def _source(edge: Edge) -> str:
    return f"{edge.publisher.label} on {edge.topic} (parent {edge.parent!r})"


def _bad_name(lookup: Lookup) -> list[str]:
    bad = [frame for frame in (lookup.target, lookup.source) if not frame or frame.startswith("/")]
    if not all(bad):
        return ["A frame has no name: give both."]
    names = " and ".join(repr(frame.lstrip("/")) for frame in bad)
    return [f"tf2 rejects names that start with a slash: use {names}."]


def _unknown_frame(lookup: Lookup) -> list[str]:
    tree = Tree(lookup.parents)
    if not tree.frames():
        return _nothing_came(lookup)
    sentences = []
    for frame in lookup.missing:
        sentences.append(f"No transform has the frame {frame!r}.{_near(frame, tree.frames())}")
        sentences += _unheard(lookup, lambda edge, frame=frame: frame in {edge.child, edge.parent})
    child = lookup.missing[0]
    sentences.append(
        f"Use a frame that is there, or start the node that publishes the transform of {child!r} "
        f"(child_frame_id: {child})."
    )
    return sentences


def _nothing_came(lookup: Lookup) -> list[str]:
    if not lookup.seen.is_live:
        return ["There is no transform in it."]
    waited = seconds_text((lookup.seen.taken_ns - lookup.seen.started_ns) / NS_PER_S)
    unheard = _unheard(lookup, lambda _: True)
    if unheard:
        return unheard
    if lookup.seen.publishers:
        names = ", ".join(f"{each.label} on {each.topic}" for each in lookup.seen.publishers)
        return [
            f"No transform came in {waited}, although there are publishers: {names}. Check what they wait for."
        ]
    return [
        f"No transform came in {waited}, and nobody publishes any: start the nodes that do, on this ROS_DOMAIN_ID."
    ]


def _unheard(lookup: Lookup, concerns: Callable[[Edge], bool]) -> list[str]:
    """Return a sentence for each publisher of such edges from which listeners receive nothing."""
    found = {
        edge.publisher.gid: edge.publisher
        for edge in lookup.seen.edges
        if edge.publisher.mismatches and concerns(edge)
    }
    return [
        f"{each.label} publishes it on {each.topic}, but transform listeners receive nothing from there, because its "
        f"{' and '.join(kind.name.lower() for kind in each.mismatches)} is less than they request: publish with "
        f"{'RELIABLE and TRANSIENT_LOCAL' if each.is_static else 'RELIABLE'}."
        for each in found.values()
    ]


def _near(frame: str, frames: Iterable[str]) -> str:
    """Return a sentence with the frames of similar names, or nothing; case and slashes don't matter."""
    plain = {each.strip("/").casefold(): each for each in frames}
    near = difflib.get_close_matches(frame.strip("/").casefold(), list(plain), 3, 0.6)
    return f" Similar: {', '.join(repr(plain[each]) for each in near)}." if near else ""


def _not_connected(lookup: Lookup) -> list[str]:
    tree = Tree(lookup.parents)
    target_root, source_root = tree.root(lookup.target), tree.root(lookup.source)
    sentences = [
        f"{lookup.source!r} is in the tree of {source_root!r} ({_size(tree, source_root)}), and {lookup.target!r} in "
        f"that of {target_root!r} ({_size(tree, target_root)}); no transform connects the two."
    ]
    roots = {source_root, target_root}
    sentences += _unheard(lookup, lambda edge: edge.child in roots)
    left = [edge for edge in lookup.seen.edges if edge.publisher.has_left and edge.child in roots]
    sentences += [
        f"{edge.publisher.label}, which sent {edge.parent} -> {edge.child}, has left." for edge in left
    ]
    sentences.append(
        f"Start the node that publishes the transform of {source_root!r} (child_frame_id: {source_root}) from a frame "
        f"of the other tree, or if it is fixed: tfloom run tf2_ros static_transform_publisher --frame-id {target_root} "
        f"--child-frame-id {source_root}, with its position and angles."
    )
    return sentences


def _size(tree: Tree, root: str) -> str:
    count = sum(1 for _ in tree.walk(root))
    return f"{count} frame{'' if count == 1 else 's'}"


def _loop(lookup: Lookup) -> list[str]:
    tree = Tree(lookup.parents)
    sentences = []
    for loop in tree.loops():
        way = " -> ".join(reversed([*loop, loop[0]]))
        edges = [edge for frame in loop for edge in lookup.seen.edges_of(frame)[-1:]]
        sources = dict.fromkeys(f"{edge.publisher.label} ({edge.parent} -> {edge.child})" for edge in edges)
        sentences.append(
            f"The frames form a loop: {way}. It is published by {', '.join(sources)}: end one of these."
        )
    return sentences


def _future(lookup: Lookup) -> list[str]:
    span = lookup.chain.first_to_end if lookup.chain is not None else None
    if span is None:
        return []
    gap_s = (lookup.stamp_ns - span.newest_ns) / NS_PER_S
    sentences = [
        f"The newest transform of {span.name}, from {span.publishers}, is {seconds_text(gap_s)} older than that."
    ]
    ahead_s = (lookup.stamp_ns - lookup.now_ns) / NS_PER_S
    if _is_simulated(span) and lookup.now_ns > SIMULATED_NS:
        return [*sentences, "Its stamps are those of a simulation: give -s (--use-sim-time)."]
    if ahead_s > 0.0 and lookup.seen.is_live:
        sentences.append(
            f"The requested time is {seconds_text(ahead_s)} ahead of now: no transform can be there yet. "
            "Check the clock that stamps the request."
        )
        return sentences
    return sentences + _late(lookup, span)


def _is_simulated(span: Span) -> bool:
    return 0 < span.newest_ns < SIMULATED_NS


def _late(lookup: Lookup, span: Span) -> list[str]:
    """Return why the newest transform of an edge isn't newer, and how long to wait."""
    edge = span.last
    if edge is None:
        return []
    if not lookup.seen.is_live:
        return ["The recording has no later one: ask for a time before, or for the latest."]
    statistics = edge.statistics
    silent_s = (lookup.now_ns - statistics.last_received_ns) / NS_PER_S
    longest_s = max(statistics.receipt_period.greatest, statistics.stamp_period.greatest)
    if edge.publisher.has_left:
        return [
            f"{edge.publisher.label} has left {seconds_text(silent_s)} after its last one: start it again."
        ]
    if silent_s > max(LEAST_STALE_S, STALE_PERIODS * longest_s):
        before = (
            f", after one each {seconds_text(statistics.receipt_period.mean)}" if statistics.count > 1 else ""
        )
        return [
            f"{edge.publisher.label} has sent none for {seconds_text(silent_s)}{before}: check that it works."
        ]
    mean_s, worst_s = statistics.delay.mean, statistics.delay.greatest
    if mean_s > LARGE_DELAY_S:
        return [
            f"Its stamps are {seconds_text(mean_s)} behind their receipt: compare the clocks of both machines, or find "
            f"out why {edge.publisher.label} sends old data. Until then, ask for the latest time."
        ]
    timeout_s = 1.2 * (max(0.0, worst_s) + longest_s)
    return [
        f"{edge.publisher.label} sends one each {seconds_text(statistics.stamp_period.mean)}, which arrives "
        f"{seconds_text(mean_s)} after its stamp (at most {seconds_text(worst_s)}). So a transform for now is there "
        f"after up to {seconds_text(max(0.0, worst_s) + longest_s)}.",
        f"Give the lookup a timeout of {timeout_s:.2f} s or more, or ask for the latest time (Time()), or let a "
        "tf2_ros.MessageFilter wait.",
    ]


def _past(lookup: Lookup) -> list[str]:
    span = lookup.chain.last_to_begin if lookup.chain is not None else None
    if span is None:
        return []
    gap_s = (span.oldest_ns - lookup.stamp_ns) / NS_PER_S
    sentences = [
        f"The oldest transform of {span.name}, from {span.publishers}, is {seconds_text(gap_s)} newer than that."
    ]
    history_s = (span.newest_ns - span.oldest_ns) / NS_PER_S
    if lookup.asked_ns == 0:
        other = lookup.chain.first_to_end if lookup.chain is not None else None
        name = other.name if other is not None else "the others"
        return [
            *sentences,
            f"The edges have no common time, because {name} ended before: {' '.join(_late_of(lookup))}",
        ]
    if not lookup.seen.is_live:
        return [*sentences, "The recording has no earlier one: ask for a later time."]
    cache_s = None if lookup.cache_time_ns is None else lookup.cache_time_ns / NS_PER_S
    if cache_s is not None and history_s >= 0.95 * cache_s:
        needed_s = (span.newest_ns - lookup.stamp_ns) / NS_PER_S
        return [
            *sentences,
            f"A buffer keeps {seconds_text(cache_s)}: create it with a longer history, for example "
            f"Buffer(cache_time=Duration(seconds={max(1, round(1.5 * needed_s))})), or look up sooner.",
        ]
    listened_s = (lookup.now_ns - lookup.seen.started_ns) / NS_PER_S
    return [
        *sentences,
        f"This command has listened for {seconds_text(listened_s)} only. A node that has listened for longer may have "
        "it; one that has just started must wait, or ask for the latest time.",
    ]


def _late_of(lookup: Lookup) -> list[str]:
    span = lookup.chain.first_to_end if lookup.chain is not None else None
    return [] if span is None else _late(lookup, span)


def _one_sample(lookup: Lookup) -> list[str]:
    spans = [
        span for span in (lookup.chain.moving if lookup.chain is not None else ()) if span.sample_count < 2
    ]
    return [
        f"There is one transform of {span.name}, from {span.publishers}, and it is valid at its own stamp only: publish "
        "it regularly, or if it never changes, on /tf_static."
        for span in spans
    ]


_ADVICE: dict[Outcome, Callable[[Lookup], list[str]]] = {
    Outcome.BAD_NAME: _bad_name,
    Outcome.UNKNOWN_FRAME: _unknown_frame,
    Outcome.LOOP: _loop,
    Outcome.NOT_CONNECTED: _not_connected,
    Outcome.FUTURE: _future,
    Outcome.PAST: _past,
    Outcome.ONE_SAMPLE: _one_sample,
}
