"""Sentences on a lookup of frames that are unknown, in a loop, or not connected."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

from tfloom.tf2_tools.lookups.lookup import Lookup
from tfloom.tf2_tools.text import NS_PER_S, counted, seconds_text
from tfloom.tf2_tools.watch.model import Edge
from tfloom.tf2_tools.watch.tree import Tree

__all__ = ["bad_name", "loop", "not_connected", "unknown_frame"]


def bad_name(lookup: Lookup) -> list[str]:
    """Return what is wrong with a name."""
    bad = [frame for frame in (lookup.target, lookup.source) if not frame or frame.startswith("/")]
    if not all(bad):
        return ["A frame has no name: give both."]
    names = " and ".join(repr(frame.lstrip("/")) for frame in bad)
    return [f"tf2 rejects names that start with a slash: use {names}."]


def unknown_frame(lookup: Lookup) -> list[str]:
    """Return which frames nobody publishes, those of similar names, and publishers that listeners do not hear."""
    tree = Tree(lookup.parents)
    if not tree.frames():
        return _nothing_came(lookup)
    sentences = []
    nowhere = []
    for frame in lookup.missing:
        # The frame was a parent until its child came with another one: a quarrel of publishers, not a wrong name.
        if several := _replaced_children(
            lookup, [edge for edge in _stored_edges(lookup) if edge.frames[1] == frame]
        ):
            sentences += several
            continue
        nowhere.append(frame)
        sentences.append(f"No transform has the frame {frame!r}.{_similar_names(frame, tree.frames())}")
        sentences += _unheard_publishers(lookup, frozenset({frame})) + _rejected_edges(
            lookup, frozenset({frame})
        )
    if not nowhere or _rejected_edges(lookup, frozenset({child := nowhere[0]})):
        return sentences
    sentences.append(
        f"Use a frame that is there, or start the node that publishes the transform of {child!r} "
        f"(child_frame_id: {child})."
    )
    return sentences


def _nothing_came(lookup: Lookup) -> list[str]:
    if reasons := _unheard_publishers(lookup) + _rejected_edges(lookup):
        return reasons
    if not lookup.seen.is_live:
        return ["There is no transform in it."]
    waited = seconds_text((lookup.seen.taken_ns - lookup.seen.started_ns) / NS_PER_S)
    if lookup.seen.publishers:
        names = ", ".join(f"{publisher.label} on {publisher.topic}" for publisher in lookup.seen.publishers)
        return [
            f"No transform came in {waited}, although there are publishers: {names}. Check what they wait for."
        ]
    return [
        f"No transform came in {waited}, and nobody publishes any: start the nodes that do, on this ROS_DOMAIN_ID."
    ]


def _unheard_publishers(lookup: Lookup, frames: frozenset[str] | None = None) -> list[str]:
    """Return a sentence for each publisher of these frames, or of any, from which listeners receive nothing."""
    publishers = {
        edge.publisher.gid: edge.publisher
        for edge in lookup.seen.edges
        if edge.publisher.mismatches and (frames is None or frames.intersection(edge.frames))
    }
    return [
        f"{publisher.label} publishes it on {publisher.topic}, but transform listeners receive nothing from "
        f"there, because its {' and '.join(kind.name.lower() for kind in publisher.mismatches)} is less than they "
        f"request: publish with {'RELIABLE and TRANSIENT_LOCAL' if publisher.is_static else 'RELIABLE'}."
        for publisher in publishers.values()
    ]


def _rejected_edges(lookup: Lookup, frames: frozenset[str] | None = None) -> list[str]:
    """Return a sentence for each edge of these frames, or of any, that buffers reject."""
    return [
        f"{edge.publisher.label} sends {edge.parent!r} -> {edge.child!r} on {edge.topic}, but buffers reject it, "
        f"because {reason}: mend that node."
        for edge in lookup.seen.edges
        if (reason := edge.rejection) and (frames is None or frames.intersection(edge.frames))
    ]


def _stored_edges(lookup: Lookup) -> list[Edge]:
    """Return what a buffer has stored, although a later transform may have replaced it."""
    return [edge for edge in lookup.seen.edges if not (edge.publisher.mismatches or edge.rejection)]


def _replaced_children(lookup: Lookup, edges: Iterable[Edge]) -> list[str]:
    """Return a sentence for each child of these edges that has another parent in the buffer, with all its sources."""
    replaced = dict.fromkeys(
        edge.frames[0] for edge in edges if edge.frames[1] != lookup.parents.get(edge.frames[0])
    )
    return [
        f"{child!r} is sent with several parents, of which a buffer keeps the last, now "
        f"{lookup.parents.get(child)!r}: {_sources(lookup, child)}. Let only one of these send {child!r}."
        for child in replaced
    ]


def _sources(lookup: Lookup, child: str) -> str:
    """Return who sends a child on which topic and with which parent, in order of the parents."""
    edges = sorted(
        (edge for edge in _stored_edges(lookup) if edge.frames[0] == child), key=lambda edge: edge.frames[1]
    )
    return " and ".join(
        dict.fromkeys(
            f"{edge.publisher.label} on {edge.topic} (parent {edge.frames[1]!r}"
            f"{', has left' if edge.publisher.has_left else ''})"
            for edge in edges
        )
    )


def _similar_names(frame: str, frames: Iterable[str]) -> str:
    """Return a sentence with the frames of similar names, or nothing; case and slashes don't matter."""
    plain = {name.strip("/").casefold(): name for name in frames}
    near = difflib.get_close_matches(frame.strip("/").casefold(), list(plain), 3, 0.6)
    return f" Similar: {', '.join(repr(plain[name]) for name in near)}." if near else ""


def not_connected(lookup: Lookup) -> list[str]:
    """Return the trees of both frames, and what would connect them."""
    tree = Tree(lookup.parents)
    target_root, source_root = tree.root(lookup.target), tree.root(lookup.source)
    sentences = [
        (
            f"{lookup.source!r} is in the tree of {source_root!r} ({_size(tree, source_root)}), and {lookup.target!r} "
            f"in that of {target_root!r} ({_size(tree, target_root)}); no transform connects the two."
        )
    ]
    branches = {*tree.branch(lookup.target), *tree.branch(lookup.source)}
    if several := _replaced_children(
        lookup, [edge for edge in _stored_edges(lookup) if edge.frames[0] in branches]
    ):
        return sentences + several
    roots = frozenset({source_root, target_root})
    sentences += _unheard_publishers(lookup, roots)
    left = [edge for edge in lookup.seen.edges if edge.publisher.has_left and edge.frames[0] in roots]
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
    return counted(sum(1 for _ in tree.walk(root)), "frame")


def loop(lookup: Lookup) -> list[str]:
    """Return each loop and who publishes it."""
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
