"""A robot as its URDF describes it: links, and the joints between them with their ranges."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from tfloom._native import Transform
from tfloom.robot.urdf_faults import Remark

__all__ = [
    "MOVING",
    "Description",
    "Joint",
    "JointRange",
    "JointType",
    "Limit",
    "Mimic",
    "range_of",
    "variables_of",
]

JointType = str
"""`fixed`, `revolute`, `continuous`, `prismatic`, `planar` or `floating`."""

VARIABLES = {
    "fixed": (),
    "revolute": ("",),
    "continuous": ("",),
    "prismatic": ("",),
    "planar": ("/x", "/y", "/theta"),
    "floating": ("/trans_x", "/trans_y", "/trans_z", "/rot_x", "/rot_y", "/rot_z", "/rot_w"),
}
"""The position variables of each type, as endings of their names: those that MoveIt uses."""

MOVING = frozenset(("revolute", "continuous", "prismatic"))
"""The types that have one position, which a JointState gives."""


class Limit(NamedTuple):
    """The range of a joint's position [rad] or [m]."""

    lower: float
    """The least position."""
    upper: float
    """The greatest position."""


class Mimic(NamedTuple):
    """A joint that follows another: it stands at multiplier * position of `joint` + offset."""

    joint: str
    """Name of the joint that it follows."""
    multiplier: float
    """Positions of this joint for one of `joint`."""
    offset: float
    """Position where `joint` is at 0 [rad] or [m]."""


class Joint(NamedTuple):
    """A joint between two links."""

    name: str
    """Its name, one of the robot's."""
    type: JointType
    """How it moves."""
    parent: str
    """The link that it is on."""
    child: str
    """The link that it carries."""
    origin: Transform
    """parent_from_joint, at position 0."""
    axis: tuple[float, float, float]
    """Unit vector in the joint's frame; for a planar joint the plane's normal."""
    line: int
    """Line of the description, from 1."""
    limit: Limit | None = None
    """Range of a joint with one position; None if none is given."""
    soft_limit: Limit | None = None
    """Range of the safety controller, without the ends that are not given, which are infinite."""
    mimic: Mimic | None = None
    """What it follows; None if it moves by itself."""
    effort_limit: float | None = None
    """Its greatest effort [N m] or [N]; None if none is given."""


class Description(NamedTuple):
    """A robot: one tree of links."""

    name: str
    """The robot's name."""
    root: str
    """The link that is not a joint's child."""
    links: tuple[str, ...]
    """In the order of the text."""
    joints: dict[str, Joint]
    """Its joints by name, in the order of the text."""
    remarks: tuple[Remark, ...] = ()
    """What is wrong with the text, though it can be read."""


def variables_of(joint: Joint) -> list[str]:
    """Return the names of a joint's position variables: its own name for one, else `name/x` and so on."""
    return [joint.name + ending for ending in VARIABLES[joint.type]]


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
