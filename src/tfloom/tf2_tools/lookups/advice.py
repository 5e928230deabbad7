"""Sentences on a lookup: what prevents it, and what to do."""

from __future__ import annotations

from collections.abc import Callable

from tfloom.tf2_tools.lookups.frame_advice import bad_name, loop, not_connected, unknown_frame
from tfloom.tf2_tools.lookups.lookup import Lookup, Outcome
from tfloom.tf2_tools.lookups.time_advice import future, one_sample, past
from tfloom.tf2_tools.watch.model import Edge, stored_name

__all__ = ["advise", "remark"]


def advise(lookup: Lookup) -> list[str]:
    """Return what prevents a lookup and what to do, as sentences; empty if it succeeds."""
    return _ADVICE[lookup.outcome](lookup) if lookup.outcome in _ADVICE else []


def remark(lookup: Lookup) -> list[str]:
    """Return what is unsound in the chain, although it may not prevent the lookup."""
    remarks = []
    for span in lookup.chain.spans if lookup.chain is not None else ():
        edges = [edge for edge in lookup.seen.edges_of(span.child) if not edge.publisher.has_left]
        names = list(dict.fromkeys(edge.publisher.label for edge in edges))
        if len({edge.publisher.gid for edge in edges}) > 1:
            remarks.append(f"{span.child!r} has {len(edges)} sources: {'; '.join(map(_source, edges))}.")
        elif len({stored_name(edge.parent) for edge in edges}) > 1:
            parents = " and ".join(sorted({repr(stored_name(edge.parent)) for edge in edges}))
            remarks.append(f"{names[0]} sends {span.child!r} with the parents {parents}.")
        if len({edge.is_static for edge in edges}) > 1:
            remarks.append(f"{span.child!r} is both static and moving: a buffer keeps only what came last.")
    return remarks


def _source(edge: Edge) -> str:
    return f"{edge.publisher.label} on {edge.topic} (parent {edge.parent!r})"


_ADVICE: dict[Outcome, Callable[[Lookup], list[str]]] = {
    Outcome.BAD_NAME: bad_name,
    Outcome.UNKNOWN_FRAME: unknown_frame,
    Outcome.LOOP: loop,
    Outcome.NOT_CONNECTED: not_connected,
    Outcome.FUTURE: future,
    Outcome.PAST: past,
    Outcome.ONE_SAMPLE: one_sample,
}
