"""Joints that follow others, directly or by way of other mimic joints."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from tfloom.robot.description import MOVING, Joint
from tfloom.robot.joint_tree import ring_text
from tfloom.robot.urdf_error import UrdfError

__all__ = ["Following", "followers"]


class Following(NamedTuple):
    """What a mimic joint follows in the end: it stands at multiplier * position of `source` + offset."""

    source: Joint
    """A joint that is no mimic joint."""
    multiplier: float
    offset: float


def followers(joints: Mapping[str, Joint]) -> dict[str, Following]:
    """Return what each mimic joint follows, by name: joints that are followed come before those that follow them.

    Raises:
        UrdfError: a joint follows one that does not exist or has no single position, or itself by way of others.
    """
    waiting: dict[str, list[Joint]] = {}
    for joint in joints.values():
        if joint.mimic is not None:
            _check_source(joint, joints)
            waiting.setdefault(joint.mimic.joint, []).append(joint)
    found: dict[str, Following] = {}
    known = [joint for joint in joints.values() if joint.mimic is None]
    for joint in known:
        for follower in waiting.pop(joint.name, ()):
            found[follower.name] = _follow(follower, joint, found)
            known.append(follower)
    if waiting:
        _refuse_loop(next(iter(waiting.values()))[0], joints)
    return found


def _check_source(joint: Joint, joints: Mapping[str, Joint]) -> None:
    assert joint.mimic is not None  # noqa: S101  # for the type checker
    source = joints.get(joint.mimic.joint)
    if source is None or source.type not in MOVING:
        why = "does not exist" if source is None else f"is of type '{source.type}'"
        reason = f"the joint '{joint.name}' mimics '{joint.mimic.joint}', which {why}"
        raise UrdfError(joint.line, reason)


def _follow(joint: Joint, directly: Joint, found: Mapping[str, Following]) -> Following:
    assert joint.mimic is not None  # noqa: S101  # for the type checker
    source, multiplier, offset = found.get(directly.name, Following(directly, 1.0, 0.0))
    factor = joint.mimic.multiplier
    return Following(source, factor * multiplier, factor * offset + joint.mimic.offset)


def _refuse_loop(joint: Joint, joints: Mapping[str, Joint]) -> None:
    path: dict[str, Joint] = {}
    while joint.name not in path and joint.mimic is not None:
        path[joint.name] = joint
        joint = joints[joint.mimic.joint]
    names = list(path)
    ring = [*names[names.index(joint.name) :], joint.name]
    raise UrdfError(joint.line, f"the joints mimic each other in a loop: {ring_text(ring)}")
