"""Joints that follow others, directly or by way of others that follow."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from tfloom.robot.description import MOVING, Joint
from tfloom.robot.joint_tree import ring_text
from tfloom.robot.urdf_faults import UrdfError

__all__ = ["Dependence", "LoopError", "dependence_of", "followers", "resolve", "unfit"]


class Dependence(NamedTuple):
    """A joint stands at factor * position of `parent` + offset."""

    parent: str
    factor: float = 1.0
    offset: float = 0.0


class LoopError(ValueError):
    """Joints depend on each other in a loop.

    Attributes:
        chain: Their names; the last one is also the first.
    """

    def __init__(self, chain: list[str]) -> None:
        super().__init__(f"Found an infinite recursive mimic chain: {chain}")
        self.chain = chain


def dependence_of(joint: Joint) -> Dependence | None:
    """Return what a mimic joint follows directly; None for another joint."""
    mimic = joint.mimic
    return None if mimic is None else Dependence(mimic.joint, mimic.multiplier, mimic.offset)


def resolve(dependences: Mapping[str, Dependence]) -> dict[str, Dependence]:
    """Return what each joint follows in the end, by way of others: those that are followed come first.

    Raises:
        LoopError: a joint follows itself.
    """
    resolved: dict[str, Dependence] = {}
    for name in dependences:
        # Go along the chain to a joint that follows none, or that is resolved. Then come back: the last follower's
        # source is known, and each before it multiplies its own factor and offset into that of the next.
        chain: dict[str, None] = {}  # in the order of the way
        joint_name = name
        while joint_name in dependences and joint_name not in resolved:
            if joint_name in chain:
                names = list(chain)
                raise LoopError([*names[names.index(joint_name) :], joint_name])
            chain[joint_name] = None
            joint_name = dependences[joint_name].parent
        for follower in reversed(chain):
            parent, factor, offset = dependences[follower]
            source, first_factor, first_offset = resolved.get(parent, Dependence(parent))
            resolved[follower] = Dependence(source, factor * first_factor, factor * first_offset + offset)
    return resolved


def unfit(name: str, joints: Mapping[str, Joint]) -> str | None:
    """Return why the joint of a name can't be followed, or None."""
    source = joints.get(name)
    if source is None:
        return f"'{name}', which does not exist"
    return None if source.type in MOVING else f"'{name}', which is of type '{source.type}'"


def followers(joints: Mapping[str, Joint]) -> dict[str, Dependence]:
    """Return which joint each mimic joint follows in the end, by name: those that are followed come first.

    Raises:
        UrdfError: a joint follows one that does not exist or has no single position, or itself by way of others.
    """
    mimics = {
        name: dependence for name, joint in joints.items() if (dependence := dependence_of(joint)) is not None
    }
    for name, dependence in mimics.items():
        if why := unfit(dependence.parent, joints):
            raise UrdfError(joints[name].line, f"the joint '{name}' mimics {why}")
    try:
        return resolve(mimics)
    except LoopError as error:
        reason = f"the joints mimic each other in a loop: {ring_text(error.chain)}"
        raise UrdfError(joints[error.chain[0]].line, reason) from None
