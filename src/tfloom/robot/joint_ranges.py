"""The ranges of joints, and the positions at which a joint_state_publisher begins."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from tfloom.robot.description import MOVING, Joint

__all__ = ["JointRange", "range_of"]


class JointRange(NamedTuple):
    """The range of a joint [rad] or [m]."""

    least: float
    greatest: float
    zero: float
    """Where the joint begins."""


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
