"""Wrenches, twists and efforts: an arrow for each, and a ring around that of what turns, which shows the way."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.robot.description import MOVING
from tfloom.robot.urdf import parse_urdf
from tfloom.robot.urdf_faults import UrdfError
from tfloom.viewer.displays.display import MAX_COORDINATE_M, Latest, stamp_of
from tfloom.viewer.displays.solids import merged, tube
from tfloom.viewer.shapes import Color, DisplayError, Placed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.displays.settings import Values

__all__ = ["EffortDisplay", "shapes_of_twist", "shapes_of_wrench"]

SHAFT = 0.05
HEAD = 0.1
RING = 0.025
"""Radii of a shaft, a head and a ring, for a width of 1 [m]."""
HEAD_LENGTH = 0.3
"""Length of a head, for a shaft of 1 m [m]."""
RING_HEAD_LENGTH = 0.1
"""Length of the head of a ring, for a width of 1 [m]."""
RING_ANGLES_RAD = np.linspace(0.25 * math.pi, 2.0 * math.pi, 29)
"""Where the ring's parts begin: an eighth of it is open, so that its head is seen [rad]."""


MAX_JOINTS = 2000
"""Number of joints whose efforts are drawn."""
WIDTH_PER_SHAFT = 0.5 / SHAFT
"""Width for a shaft that is 1 m thick [m]."""


class TwinArrows(NamedTuple):
    """Names of the settings for two vectors, of which the second is what turns."""

    names: tuple[str, str]
    colors: tuple[str, str]
    scales: tuple[str, str]


WRENCH = TwinArrows(("force", "torque"), ("force_color", "torque_color"), ("force_scale", "torque_scale"))
TWIST = TwinArrows(
    ("linear", "angular"), ("linear_color", "angular_color"), ("linear_scale", "angular_scale")
)


def shapes_of_wrench(message: Any, settings: Values) -> list[Placed]:
    """Return the arrows of a `geometry_msgs/msg/WrenchStamped`, as RViz does.

    Raises:
        DisplayError: it has a number that can't be drawn, or nothing that is long enough.
    """
    return _shapes(message.header, (message.wrench.force, message.wrench.torque), WRENCH, settings)


def shapes_of_twist(message: Any, settings: Values) -> list[Placed]:
    """Return the arrows of a `geometry_msgs/msg/TwistStamped`, as RViz does.

    Raises:
        DisplayError: it has a number that can't be drawn, or nothing that is long enough.
    """
    return _shapes(message.header, (message.twist.linear, message.twist.angular), TWIST, settings)


def _shapes(header: Any, vectors: tuple[Any, Any], twins: TwinArrows, settings: Values) -> list[Placed]:
    width, opacity = settings["width"], settings["opacity"]
    straight, turning = (
        _vector(vector, settings[scale], name)
        for vector, scale, name in zip(vectors, twins.scales, twins.names, strict=True)
    )
    meshes = []
    if straight.length > width:
        meshes.append(merged([_arrow(straight, width)], settings[twins.colors[0]], opacity))
    if turning.length > width:
        tubes = [_arrow(turning, width), _ring(turning, width)]
        meshes.append(merged(tubes, settings[twins.colors[1]], opacity))
    if not meshes:
        raise DisplayError(f"its arrows would be shorter than their width of {width:g}")
    return [Placed(mesh, header.frame_id, stamp_of(header)) for mesh in meshes]


class _Vector(NamedTuple):
    """A vector as it is drawn."""

    length: float
    """[m]."""
    axes: NDArray[np.float64]
    """Its direction, last, and two directions across it, right-handed (3, 3)."""


def _vector(vector: Any, scale: float, name: str) -> _Vector:
    """Return a force or a torque as it is drawn.

    Raises:
        DisplayError: it is not finite, or too long.
    """
    parts = np.array((vector.x, vector.y, vector.z), np.float64)
    greatest = float(np.abs(parts).max())
    # The greatest part first, because the square of a large one is beyond what a number holds, and that of a small one
    # is zero.
    parts = parts / greatest if 0.0 < greatest < math.inf else parts
    size = greatest * float(np.linalg.norm(parts))
    length = size * scale
    if not (1.0 + HEAD_LENGTH) * length < MAX_COORDINATE_M:
        raise DisplayError(f"its {name} is not finite, or its arrow is longer than {MAX_COORDINATE_M:g} m")
    if not length > 0.0:
        return _Vector(0.0, np.eye(3))
    return _Vector(length, _axes_along(parts / np.linalg.norm(parts)))


def _axes_along(direction: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return x, y and z after the least turn that brings z to a direction; half a turn is around y."""
    x, y, z = direction
    if z < -1.0 + 1e-9:
        return np.diag((-1.0, 1.0, -1.0))
    part = 1.0 / (1.0 + z)
    return np.array(
        [(1.0 - x * x * part, -x * y * part, -x), (-x * y * part, 1.0 - y * y * part, -y), (x, y, z)]
    )


def _arrow(vector: _Vector, width: float) -> NDArray[np.float64]:
    """Return the tube of an arrow: RViz's shaft is as long as the vector, and its head comes after it."""
    heights = vector.length * np.array((0.0, 0.0, 1.0, 1.0, 1.0 + HEAD_LENGTH))
    radii = width * np.array((0.0, SHAFT, SHAFT, HEAD, 0.0))
    across, beside, along = vector.axes
    return tube(heights[:, np.newaxis] * along, np.tile(across, (5, 1)), np.tile(beside, (5, 1)), radii)


def _ring(vector: _Vector, width: float) -> NDArray[np.float64]:
    """Return the tube of the ring at half an arrow, around it by the right-hand rule, and its head."""
    angles = RING_ANGLES_RAD[:, np.newaxis]
    across, beside, along = vector.axes
    outwards = np.cos(angles) * across + np.sin(angles) * beside
    centres = vector.length / 2.0 * along + vector.length / 4.0 * outwards
    tip = centres[-1] + RING_HEAD_LENGTH * width * beside
    centres = np.vstack([centres[0], centres, centres[-1], tip])
    outwards = np.vstack([outwards[0], outwards, outwards[-1], outwards[-1]])
    radii = width * np.array((0.0, *([RING] * len(RING_ANGLES_RAD)), HEAD, 0.0))
    return tube(centres, outwards, np.tile(along, (len(centres), 1)), radii)


class _Motor(NamedTuple):
    """A joint whose effort is drawn."""

    name: str
    link: str
    """The link that it carries, whose frame is the joint's."""
    axis: tuple[float, float, float]
    limit: float
    """[N m] or [N]."""
    turns: bool


class EffortDisplay(Latest):
    """Shows the efforts of a `sensor_msgs/msg/JointState` along the axes of a robot's joints.

    A joint without a limit of its effort, and an effort that is not a number, are left out.

    Attributes:
        partner: The joints of the robot; None: they are not known.
        absence: Why not.
    """

    partner_type = "std_msgs/msg/String"
    partner_name = "robot description"

    def __init__(self, settings: Values) -> None:
        super().__init__(settings)
        self.partner: list[_Motor] | None = None
        self.absence = "its robot description is not known"

    def partner_topic(self, topic: str) -> str:
        """Return the topic of the robot's description, as it is set."""
        name = str(self.settings["description"])
        return name if name.startswith("/") else f"/{name}"

    def partner_of(self, message: Any) -> list[_Motor]:
        """Return the joints of a robot that have a limit of their effort.

        Raises:
            DisplayError: it is not a URDF, or no joint has one.
        """
        try:
            joints = parse_urdf(message.data).joints.values()
        except UrdfError as error:
            raise DisplayError(f"it is not a URDF: {error}") from None
        motors = [
            _Motor(joint.name, joint.child, joint.axis, joint.effort_limit, joint.type != "prismatic")
            for joint in joints
            if joint.type in MOVING and joint.effort_limit is not None and joint.effort_limit > 0.0
        ]
        if not motors:
            raise DisplayError("none of its joints has a limit of its effort")
        return motors[:MAX_JOINTS]

    def shapes_of(self, message: Any) -> list[Placed]:
        """Return an arrow for each effort, and a ring around those of joints that turn.

        Raises:
            DisplayError: it has no efforts of the robot's joints, one can't be drawn, or the robot is not known.
        """
        if self.partner is None:
            raise DisplayError(self.absence)
        if not len(message.effort) or len(message.effort) != len(message.name):
            raise DisplayError(f"it has {len(message.effort)} efforts for {len(message.name)} joints")
        efforts = dict(zip(message.name, message.effort, strict=True))
        driven = [motor for motor in self.partner if motor.name in efforts]
        if not driven:
            raise DisplayError("none of its joints is one of the robot with a limit of its effort")
        placed = []
        for motor in driven:
            placed += self._drawn(motor, float(efforts[motor.name]), stamp_of(message.header))
        return placed

    def _drawn(self, motor: _Motor, effort: float, stamp_ns: int) -> list[Placed]:
        share = effort / motor.limit
        length, width = abs(share) * self.settings["scale"], self.settings["width"]
        if (1.0 + HEAD_LENGTH) * length >= MAX_COORDINATE_M:
            raise DisplayError(f"the arrow of {motor.name[:80]} is longer than {MAX_COORDINATE_M:g} m")
        if not length > width:  # nor is what is not a number
            return []
        vector = _Vector(length, _axes_along(math.copysign(1.0, share) * np.array(motor.axis)))
        wide = width * WIDTH_PER_SHAFT
        tubes = [_arrow(vector, wide), *([_ring(vector, wide)] if motor.turns else [])]
        return [Placed(merged(tubes, _warning(abs(share)), self.settings["opacity"]), motor.link, stamp_ns)]


def _warning(share: float) -> Color:
    """Return the colour of a share of a limit: from green by yellow to red."""
    part = min(share, 1.0)
    return round(255 * min(2.0 * part, 1.0)), round(255 * min(2.0 - 2.0 * part, 1.0)), 0
