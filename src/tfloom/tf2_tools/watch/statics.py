"""The static transforms of an observation."""

from __future__ import annotations

from tfloom.tf2_tools.static_transforms.transform import StaticTransform
from tfloom.tf2_tools.watch.model import Edge, Observation, stored_name

__all__ = ["last_statics", "quarrels"]


def last_statics(seen: Observation) -> list[StaticTransform]:
    """Return the static transform of each child that came last, in order of the children's names."""
    last: dict[str, Edge] = {}
    for edge in seen.by_receipt:
        if edge.is_static and not edge.statistics.non_finite:
            last[stored_name(edge.child)] = edge
    return [
        StaticTransform(
            stored_name(edge.parent), child, edge.statistics.translation, edge.statistics.rotation_xyzw
        )
        for child, edge in sorted(last.items())
    ]


def quarrels(seen: Observation) -> list[str]:
    """Return a sentence for each child whose static transforms differ, by publisher or by parent."""
    by_child: dict[str, list[Edge]] = {}
    for edge in seen.edges:
        if edge.is_static:
            by_child.setdefault(edge.child, []).append(edge)
    found = []
    for child, edges in sorted(by_child.items()):
        values = {(edge.parent, edge.statistics.translation, edge.statistics.rotation_xyzw) for edge in edges}
        if len(values) > 1:
            texts = [f"{edge.publisher.label} (parent {edge.parent!r})" for edge in edges]
            found.append(
                f"{child!r} has different static transforms, from {' and '.join(texts)}; the last one is used"
            )
    return found
