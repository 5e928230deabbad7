"""What a joint_state_publisher knows of joints: their ranges, the positions they begin at, and what they follow."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from tfloom.robot.description import MOVING, Joint

__all__ = ["Dependence", "JointRange", "LoopError", "dependence_of", "range_of", "resolve"]


class JointRange(NamedTuple):
    """The range of a joint [rad] or [m]."""

    least: float
    greatest: float
    zero: float
    """Where the joint begins."""


class Dependence(NamedTuple):
    """A joint stands at factor * position of `parent` + offset."""

    parent: str
    factor: float = 1.0
    offset: float = 0.0


class LoopError(ValueError):
    """Joints depend on each other in a loop.

    Attributes:
        chain: Their names; the last one is also an earlier one.
    """

    def __init__(self, chain: list[str]) -> None:
        super().__init__(f"Found an infinite recursive mimic chain: {chain}")
        self.chain = chain


def range_of(joint: Joint, zeros: Mapping[str, float], *, use_soft_limits: bool) -> JointRange | None:
    """Return the range of a joint; None if it has no single position.

    Args:
        joint: The joint.
        zeros: Positions at which joints begin, by name; the others begin at 0, or in the middle if 0 is out of range.
        use_soft_limits: Whether the safety controller's limits apply where they are tighter.
    """
    if joint.type not in MOVING:
        return None
    least, greatest = -math.pi, math.pi
    if joint.type != "continuous" and joint.limit is not None:
        least, greatest = joint.limit.lower, joint.limit.upper
    if use_soft_limits and joint.soft_limit is not None:
        least = max(least, joint.soft_limit.lower)
        greatest = min(greatest, joint.soft_limit.upper)
    middle = (greatest + least) / 2 if least > 0 or greatest < 0 else 0.0
    return JointRange(least, greatest, float(zeros.get(joint.name, middle)))


def dependence_of(joint: Joint) -> Dependence | None:
    """Return what a mimic joint follows directly; None for another joint."""
    mimic = joint.mimic
    return None if mimic is None else Dependence(mimic.joint, mimic.multiplier, mimic.offset)


def resolve(dependences: Mapping[str, Dependence]) -> dict[str, Dependence]:
    """Return what each joint follows in the end, by way of others.

    Raises:
        LoopError: a joint follows itself.
    """
    found: dict[str, Dependence] = {}
    for name in dependences:
        chain: dict[str, None] = {}  # ordered
        each = name
        while each in dependences and each not in found:
            if each in chain:
                names = list(chain)
                raise LoopError([*names[names.index(each) :], each])
            chain[each] = None
            each = dependences[each].parent
        for follower in reversed(chain):
            parent, factor, offset = dependences[follower]
            source, first_factor, first_offset = found.get(parent, Dependence(parent))
            found[follower] = Dependence(source, factor * first_factor, factor * first_offset + offset)
    return found
