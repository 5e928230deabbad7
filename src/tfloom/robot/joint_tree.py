"""The tree that joints make of links."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from tfloom.robot.description import Description, Joint
from tfloom.robot.urdf_faults import UrdfError

__all__ = ["find_root", "from_root", "ring_text"]


def find_root(links: Mapping[str, int], joints: Mapping[str, Joint]) -> str:
    """Return the link that is not a joint's child.

    Args:
        links: The line of each link, by name.
        joints: The joints, whose links exist.

    Raises:
        UrdfError: the links are not one tree.
    """
    by_child: dict[str, Joint] = {}
    for joint in joints.values():
        other = by_child.setdefault(joint.child, joint)
        if other is not joint:
            reason = f"the link '{joint.child}' is the child of two joints, '{other.name}' and '{joint.name}'"
            raise UrdfError(joint.line, reason)
    roots = [link for link in links if link not in by_child]
    if len(roots) > 1:
        listed = ", ".join(f"'{root}' (line {links[root]})" for root in roots[:5])
        more = f" and {len(roots) - 5} more" if len(roots) > 5 else ""
        reason = f"the links are not a single tree, because several are not a joint's child: {listed}{more}"
        raise UrdfError(links[roots[1]], reason)
    _refuse_loops(links, by_child)
    return roots[0]


def _refuse_loops(links: Iterable[str], by_child: Mapping[str, Joint]) -> None:
    reaches_root: set[str] = set()
    for link in links:
        path: dict[str, Joint] = {}
        while link in by_child and link not in reaches_root:
            if link in path:
                names = list(path)
                ring = [*names[names.index(link) :], link]
                raise UrdfError(by_child[link].line, f"the joints make a loop of links: {ring_text(ring)}")
            path[link] = by_child[link]
            link = by_child[link].parent  # noqa: PLW2901  # the walk to the root
        reaches_root.update(path)


def ring_text(names: Iterable[str]) -> str:
    """Return the names of a loop, for an error."""
    return " -> ".join(f"'{name}'" for name in names)


def from_root(description: Description) -> list[Joint]:
    """Return the joints in an order in which parents come before children: depth first, each link's by the text."""
    below: dict[str, list[Joint]] = {}
    for joint in description.joints.values():
        below.setdefault(joint.parent, []).append(joint)
    ordered: list[Joint] = []
    waiting = below.get(description.root, [])[::-1]
    while waiting:
        joint = waiting.pop()
        ordered.append(joint)
        waiting += below.get(joint.child, [])[::-1]
    return ordered
