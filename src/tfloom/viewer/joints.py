"""The joints of a robot that pages move by sliders."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple, Protocol

import numpy as np

from tfloom.robot.description import Description, JointRange, range_of
from tfloom.robot.mimicry import followers
from tfloom.robot.model import RobotModel
from tfloom.tf2.buffer import Buffer
from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.page_command import PageError, number, text

__all__ = ["AUTHORITY", "DescribedJoints", "JointRow", "Joints", "RobotJoints", "joint_command", "joint_rows"]

MAX_POSITION = 1e6
"""The end of a slider whose joint has a limit beyond it, or none [rad] or [m]."""
MAX_ROWS = 500
"""Number of joints that pages get."""
AUTHORITY = "tfloom view"
_RANDOM = np.random.default_rng()


class JointRow(NamedTuple):
    """A joint with one position."""

    name: str
    range: JointRange
    position: float
    """[rad] or [m]."""
    is_linear: bool
    """Whether it moves by meters."""
    follows: str
    """The joint that it follows; empty if it is moved by itself."""


class Joints(Protocol):
    """Joints with one position each. One thread may move them."""

    def rows(self) -> list[JointRow]:
        """Return the joints, in the order of the description."""

    def move(self, positions: Mapping[str, float]) -> None:
        """Move joints that follow no other, by name, each within its range [rad] or [m]."""

    def about(self, link: str) -> str:
        """Return a line about the joint that a link is on; empty if it is on none."""


class RobotJoints:
    """What a description says of joints.

    Args:
        description: The robot.
        follows: The joint that each dependent one follows, by name; None: as the description says.
        zeros: Where joints begin, by name; see `range_of`.
        use_soft_limits: Whether the safety controller's limits apply where they are tighter.
    """

    def __init__(
        self,
        description: Description,
        follows: Mapping[str, str] | None = None,
        zeros: Mapping[str, float] = MappingProxyType({}),
        *,
        use_soft_limits: bool = True,
    ) -> None:
        self._joints = description.joints
        self._by_child = {joint.child: joint for joint in description.joints.values()}
        if follows is None:
            follows = {name: dependence.parent for name, dependence in followers(self._joints).items()}
        self.follows = follows
        ranges = {
            name: range_of(joint, zeros, use_soft_limits=use_soft_limits)
            for name, joint in self._joints.items()
        }
        self.ranges = {name: _bounded(found) for name, found in ranges.items() if found is not None}

    def row(self, name: str, position: float) -> JointRow:
        """Return the row of a joint at a position."""
        is_linear = self._joints[name].type == "prismatic"
        return JointRow(name, self.ranges[name], position, is_linear, self.follows.get(name, ""))

    def about(self, link: str) -> str:
        """Return a line about the joint that a link is on; empty if it is on none."""
        joint = self._by_child.get(link)
        return "" if joint is None else f"{link} is on {joint.parent} by the {joint.type} joint {joint.name}"


def _bounded(found: JointRange) -> JointRange:
    """Return a range with ends that a slider can have: finite, and the lower one first."""
    least, greatest = (min(max(end, -MAX_POSITION), MAX_POSITION) for end in (found.least, found.greatest))
    least, greatest = min(least, greatest), max(least, greatest)
    return JointRange(least, greatest, min(max(found.zero, least), greatest))


class DescribedJoints:
    """The joints of a robot that nobody publishes: what they move is stored in a buffer.

    Args:
        model: The robot.
        buffer: Where its transforms are stored, without a history.
    """

    def __init__(self, model: RobotModel, buffer: Buffer) -> None:
        self._model = model
        self._buffer = buffer
        self._robot = RobotJoints(model.description)
        self.about = self._robot.about
        self._positions = {
            name: found.zero for name, found in self._robot.ranges.items() if name not in self._robot.follows
        }
        self._store()

    def rows(self) -> list[JointRow]:
        """Return the joints, in the order of the description."""
        return [self._robot.row(name, position) for name, position in self.positions().items()]

    def positions(self) -> dict[str, float]:
        """Return the position of each joint [rad] or [m], in the order of the description."""
        dependences = followers(self._model.description.joints)
        positions = {}
        for name in self._robot.ranges:
            source, factor, offset = dependences.get(name, (name, 1.0, 0.0))
            positions[name] = factor * self._positions[source] + offset
        return positions

    def move(self, positions: Mapping[str, float]) -> None:
        """Move joints that follow no other, by name, each within its range [rad] or [m]."""
        self._positions |= positions
        self._store()

    def _store(self) -> None:
        transforms = self._model.joint_transforms(self._positions)
        stamp_ns = time.time_ns()
        for joint, (x, y, z, *rotation) in zip(self._model.joints, transforms.tolist(), strict=True):
            # Static transforms have no history, which nobody would want of a pose that is tried out.
            self._buffer.set(joint.parent, joint.child, stamp_ns, (x, y, z), rotation, AUTHORITY, True)


def joint_rows(joints: Joints) -> list[dict[str, Any]]:
    """Return what pages get of joints, as values for JSON."""
    return [
        {
            "name": shown_text(row.name),
            "key": row.name,
            "least": row.range.least,
            "greatest": row.range.greatest,
            "position": row.position if math.isfinite(row.position) else 0.0,
            "unit": "m" if row.is_linear else "rad",
            "follows": shown_text(row.follows),
        }
        for row in joints.rows()[:MAX_ROWS]
    ]


def joint_command(joints: Joints, command: Mapping[str, Any]) -> None:
    """Do what a page asks for: `joint` moves one, `pose` all, to the position of rest or to a random one.

    Raises:
        PageError: it can't be done.
    """
    free = {row.name: row.range for row in joints.rows() if not row.follows}
    if text(command, "op") == "joint":
        name, position = text(command, "name"), number(command, "position")
        if name not in free:
            raise PageError(f"there is no joint {name!r} that can be moved")
        joints.move({name: min(max(position, free[name].least), free[name].greatest)})
        return
    to = text(command, "to")
    if to not in {"rest", "random"}:
        raise PageError("a pose is rest or random")
    joints.move({name: ends.zero if to == "rest" else _drawn_from(ends) for name, ends in free.items()})


def _drawn_from(ends: JointRange) -> float:
    return float(_RANDOM.uniform(ends.least, ends.greatest))
