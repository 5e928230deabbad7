"""The static transforms of an observation."""

from __future__ import annotations

from collections.abc import Iterator

from tfloom.tf2_tools.static_transform import StaticTransform
from tfloom.tf2_tools.watch.model import Edge, Observation, stored_name

__all__ = ["last_statics", "quarrels", "unusable"]


def last_statics(seen: Observation) -> list[StaticTransform]:
    """Return the static transform of each child that came last, in order of the children's names.

    Those that `unusable` names are left out.
    """
    faults = _faults(seen)
    last = {edge.frames[0]: edge for edge in seen.by_receipt if edge.is_static and id(edge) not in faults}
    return [_transform(edge) for _, edge in sorted(last.items())]


def _transform(edge: Edge) -> StaticTransform:
    child, parent = edge.frames
    return StaticTransform(parent, child, edge.statistics.translation, edge.statistics.rotation_xyzw)


def unusable(seen: Observation) -> list[str]:
    """Return a sentence for each static edge that no lookup can use."""
    faults = _faults(seen)
    return [
        f"{edge.parent!r} -> {edge.child!r} of {edge.publisher.label} is left out, because {faults[id(edge)]}"
        for edge in seen.edges
        if id(edge) in faults
    ]


def _faults(seen: Observation) -> dict[int, str]:
    """Return what is wrong with static edges, by their identity."""
    faults = {id(edge): fault for edge in seen.edges if edge.is_static and (fault := _fault(edge))}
    last = {edge.frames[0]: edge for edge in seen.by_receipt if edge.is_static and id(edge) not in faults}
    parents: dict[str, str] = {}
    for child, edge in sorted(last.items()):
        parents[child] = edge.frames[1]
        if child in _ancestors(parents, child):
            del parents[child]
            faults[id(edge)] = "it closes a loop"
    return faults


def _fault(edge: Edge) -> str:
    slashed = [frame for frame in edge.frames if frame.startswith("/")]
    return edge.rejection or (f"tf2 rejects lookups of {slashed[0]!r}" if slashed else "")


def _ancestors(parents: dict[str, str], child: str) -> Iterator[str]:
    """Yield the ancestors of a frame up to the root, or up to the frame itself."""
    above = parents.get(child)
    while above is not None:
        yield above
        above = None if above == child else parents.get(above)


def quarrels(seen: Observation) -> list[str]:
    """Return a sentence for each child whose static transforms differ, by publisher or by parent."""
    by_child: dict[str, list[Edge]] = {}
    for edge in seen.edges:
        if edge.is_static and not edge.rejection:
            by_child.setdefault(stored_name(edge.child), []).append(edge)
    sentences = []
    for child, edges in sorted(by_child.items()):
        if len(set(map(_transform, edges))) > 1:
            texts = [f"{edge.publisher.label} (parent {edge.parent!r})" for edge in edges]
            sentences.append(
                f"{child!r} has different static transforms, from {' and '.join(texts)}; the last one is used"
            )
    return sentences
