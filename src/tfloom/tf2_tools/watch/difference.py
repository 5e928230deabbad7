"""Differences of two frame trees: edges that one lacks, other parents, other static transforms."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from tfloom.tf2.transform import Transform
from tfloom.tf2_tools.watch.model import Observation, stored_name

__all__ = ["Difference", "Link", "differences", "links_of"]


class Link(NamedTuple):
    """A child's transform from its parent, as one tree has it."""

    child: str
    parent: str
    is_static: bool
    translation: tuple[float, float, float]
    """[m]."""
    rotation_xyzw: tuple[float, float, float, float]


class Difference(NamedTuple):
    """A difference of one child between tree A and tree B."""

    kind: str
    """added, removed, re-parented, kind or moved."""
    child: str
    before: Link | None
    """In A; None if added."""
    after: Link | None
    """In B; None if removed."""
    distance: float = 0.0
    """Of the translations, if moved [m]."""
    angle_rad: float = 0.0
    """Of the rotations, if moved: 0 to pi."""


def links_of(seen: Observation, *, only_static: bool = False) -> dict[str, Link]:
    """Return the transform of each child that came last, by the child's name, without those that a buffer rejects.

    Args:
        seen: The observation.
        only_static: Whether moving transforms are left out.
    """
    return {
        stored_name(edge.child): Link(
            stored_name(edge.child),
            stored_name(edge.parent),
            edge.is_static,
            edge.statistics.translation,
            edge.statistics.rotation_xyzw,
        )
        for edge in seen.by_receipt
        if not edge.rejection and (edge.is_static or not only_static)
    }


def differences(
    before: Mapping[str, Link], after: Mapping[str, Link], *, translation: float, rotation_rad: float
) -> list[Difference]:
    """Return what differs, in order of the children's names. The values of moving transforms are not compared.

    Args:
        before: Tree A, by child.
        after: Tree B, by child.
        translation: The longest distance that does not count as a difference [m].
        rotation_rad: The widest angle that does not count as a difference [rad].
    """
    tree_differences = []
    for child in sorted(before.keys() | after.keys()):
        difference = _difference(child, before.get(child), after.get(child))
        if difference is None:
            continue
        is_near = difference.distance <= translation and difference.angle_rad <= rotation_rad
        if difference.kind != "moved" or not is_near:
            tree_differences.append(difference)
    return tree_differences


def _difference(child: str, before: Link | None, after: Link | None) -> Difference | None:
    if before is None or after is None:
        return Difference("added" if before is None else "removed", child, before, after)
    if before.parent != after.parent:
        return Difference("re-parented", child, before, after)
    if before.is_static != after.is_static:
        return Difference("kind", child, before, after)
    if not before.is_static:
        return None
    distance = math.dist(before.translation, after.translation)
    return Difference("moved", child, before, after, distance, _angle_rad(before, after))


def _angle_rad(before: Link, after: Link) -> float:
    turn = Transform(rotation_xyzw=before.rotation_xyzw).inverse() @ Transform(
        rotation_xyzw=after.rotation_xyzw
    )
    x, y, z, w = turn.rotation_xyzw
    return 2.0 * math.atan2(math.hypot(x, y, z), abs(w))
