"""The turtles' world: positions, velocities and pens, in steps of 16 ms, without ROS and without a picture.

Lengths are metres, x to the right and y up, (0, 0) in the lower left corner; angles are radians, from x
towards y. Values that the reference rounds to float32 (the world's size, the rest of a rotation) are rounded here, too.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from ctypes import c_float
from itertools import count
from typing import Literal, NamedTuple

STEP_S = 0.016
"""Simulated time of one step [s], independent of real time: 62.5 steps a second."""
WINDOW_PX = 500
"""Width and height of the world's picture [px]."""
PX_PER_M = 45
"""Scale of the picture [px/m]: one turtle is as tall as one metre."""
COMMAND_TIMEOUT_NS = 1_000_000_000
"""A velocity command older than this [ns] no longer moves its turtle."""
ROTATION_SPEED = 1.0
"""Turning rate towards a rotation goal [rad/s]."""
ROTATION_TOLERANCE_RAD = 0.02

Color = tuple[int, int, int]
"""Red, green, blue: 0 to 255."""

# The reference's π, which determines where a heading wraps around.
PI = 3.14159265
TWO_PI = 2 * PI


def to_float32(value: float) -> float:
    """Return the float32 next to `value`; infinity where its range ends."""
    return c_float(value).value


WORLD_SIZE_M = to_float32((WINDOW_PX - 1) / PX_PER_M)
"""Width and height of the world [m]."""


def normalize_angle(angle_rad: float) -> float:
    """Return the heading in [-π, π) that points the way of a finite `angle_rad`."""
    if abs(angle_rad) > 1e6:  # where the subtraction below would cancel the digits
        angle_rad = math.remainder(angle_rad, TWO_PI)
    return angle_rad - TWO_PI * math.floor((angle_rad + PI) / TWO_PI)


def is_usable(*numbers: float) -> bool:
    """Return whether all of these are finite numbers within float32's range, which a turtle can use."""
    return all(math.isfinite(to_float32(number)) for number in numbers)


class Pen(NamedTuple):
    """The pen of a turtle."""

    color: Color = (179, 184, 255)
    width_px: int = 3
    is_on: bool = True


class Stroke(NamedTuple):
    """A straight line that a turtle drew in one step."""

    start: tuple[float, float]
    end: tuple[float, float]
    color: Color
    width_px: int


class WallHit(NamedTuple):
    """A turtle left the world and was moved back to its edge."""

    turtle: str
    x: float
    y_down: float
    """Distance from the world's upper edge [m], as the reference logs it."""

    def __str__(self) -> str:
        return f"Oh no! I hit the wall! (Clamping from [x={self.x:f}, y={self.y_down:f}])"


class RotationStep(NamedTuple):
    """The state of a turtle's turn towards a goal after one step."""

    turtle: str
    rotation: Rotation


class Moved(NamedTuple):
    """A turtle has moved in this step: its pose and sensor can be published; its stroke is the next event."""

    turtle: Turtle


Event = Stroke | WallHit | RotationStep | Moved


class Rotation:
    """A rotation to an absolute heading, active or ended."""

    __slots__ = ("cancel_requested", "delta", "goal", "remaining", "start", "state")

    def __init__(self, goal: float, start: float) -> None:
        self.goal = to_float32(goal)
        self.start = start
        self.remaining = 0.0
        """Remaining angle before this step [rad]; negative is clockwise."""
        self.delta = 0.0
        """Start minus heading [rad]: the angle turned, with the opposite sign, as in the reference."""
        self.cancel_requested = False
        self.state: Literal["active", "succeeded", "canceled", "aborted"] = "active"


class _Teleport(NamedTuple):
    x: float
    y_down: float
    theta: float


class _RelativeTeleport(NamedTuple):
    distance: float
    angle: float


class Turtle:
    """One turtle. Commands take effect at the next step; attributes can be read at any time."""

    def __init__(
        self, name: str, x: float, y: float, theta: float, commanded_ns: int = 0, kind: int = 0
    ) -> None:
        self.name = name
        self.kind = kind
        """Index of its look, from 0."""
        self.pen = Pen()
        self.x = x
        self.y_down = WORLD_SIZE_M - y
        self.theta = theta
        self.velocity_x = 0.0
        """Commanded velocity ahead [m/s]."""
        self.velocity_y = 0.0
        """Commanded velocity to the left [m/s]: for holonomic turtles."""
        self.angular_velocity = 0.0
        """Commanded turning rate [rad/s]."""
        self.rotation: Rotation | None = None
        self._commanded_ns = commanded_ns
        self._teleports: list[_Teleport | _RelativeTeleport] = []

    @property
    def y(self) -> float:
        """Height above the world's lower edge [m]."""
        return WORLD_SIZE_M - self.y_down

    @property
    def linear_velocity(self) -> float:
        """Commanded speed [m/s], never negative."""
        return math.hypot(self.velocity_x, self.velocity_y)

    def command(
        self, linear_x: float, linear_y: float | None, angular_z: float, stamp_ns: int
    ) -> Rotation | None:
        """Move with these velocities [m/s, m/s, rad/s] until the next command or for one second.

        Args:
            linear_x: Velocity ahead.
            linear_y: Velocity to the left; None leaves it unchanged, as for a turtle that isn't holonomic.
            angular_z: Turning rate.
            stamp_ns: Now, by the world's clock.

        Returns:
            The rotation that this command aborted, if there was one.
        """
        self.velocity_x = linear_x
        if linear_y is not None:
            self.velocity_y = linear_y
        self.angular_velocity = angular_z
        self._commanded_ns = stamp_ns
        return self._abort_rotation()

    def rotate_to(self, theta: float) -> tuple[Rotation, Rotation | None]:
        """Turn to the heading `theta`; return the new rotation, and the one that it aborted or None."""
        aborted = self._abort_rotation()
        self.rotation = Rotation(theta, self.theta)
        return self.rotation, aborted

    def teleport(self, x: float, y: float, theta: float) -> None:
        """Jump to a pose at the next step; a position above the world's upper edge is moved onto it."""
        self._teleports.append(_Teleport(x, max(0.0, WORLD_SIZE_M - y), theta))

    def teleport_relative(self, distance: float, angle: float) -> None:
        """At the next step, turn by `angle`, then jump by `distance` along the new heading."""
        self._teleports.append(_RelativeTeleport(distance, angle))

    def set_pen(self, color: Color, width_px: int, *, off: bool) -> None:
        """Change the pen. Off keeps colour and width; a width of 0 draws as 1."""
        self.pen = self.pen._replace(is_on=False) if off else Pen(color, width_px or 1)

    def step(self, dt_s: float, now_ns: int) -> Iterator[Event]:
        """Advance by one step, in the reference's order; yield the events."""
        yield from self._jump()
        if self.rotation is not None:
            yield self._steer(self.rotation, now_ns)
        if now_ns - self._commanded_ns > COMMAND_TIMEOUT_NS:
            self._stop()
        before = self.x, self.y
        yield from self._move(dt_s)
        yield Moved(self)
        yield from self._draw(before)

    def _jump(self) -> Iterator[Stroke]:
        for jump in self._teleports:
            before = self.x, self.y
            if isinstance(jump, _Teleport):
                self.x, self.y_down, self.theta = jump
            else:
                self.theta = normalize_angle(self.theta + jump.angle)
                self.x += math.cos(self.theta) * jump.distance
                self.y_down -= math.sin(self.theta) * jump.distance
            yield from self._draw(before)
        self._teleports.clear()

    def _steer(self, rotation: Rotation, now_ns: int) -> RotationStep:
        """Set the velocities that turn towards the goal, or end the rotation."""
        if rotation.cancel_requested:
            return self._end_rotation(rotation, "canceled")
        rotation.remaining = to_float32(
            normalize_angle(normalize_angle(rotation.goal) - to_float32(self.theta))
        )
        rotation.delta = to_float32(normalize_angle(rotation.start - self.theta))
        if abs(rotation.remaining) < ROTATION_TOLERANCE_RAD:
            return self._end_rotation(rotation, "succeeded")
        self.velocity_x = self.velocity_y = 0.0
        self.angular_velocity = math.copysign(ROTATION_SPEED, rotation.remaining)
        self._commanded_ns = now_ns
        return RotationStep(self.name, rotation)

    def _end_rotation(self, rotation: Rotation, state: Literal["succeeded", "canceled"]) -> RotationStep:
        rotation.state = state
        self.rotation = None
        self._stop()
        return RotationStep(self.name, rotation)

    def _abort_rotation(self) -> Rotation | None:
        rotation, self.rotation = self.rotation, None
        if rotation is not None:
            rotation.state = "aborted"
        return rotation

    def _stop(self) -> None:
        self.velocity_x = self.velocity_y = self.angular_velocity = 0.0

    def _move(self, dt_s: float) -> Iterator[WallHit]:
        """Turn, then move along the new heading, within the world."""
        self.theta = normalize_angle(self.theta + self.angular_velocity * dt_s)
        cos, sin = math.cos(self.theta), math.sin(self.theta)
        self.x += (cos * self.velocity_x - sin * self.velocity_y) * dt_s
        self.y_down -= (cos * self.velocity_y + sin * self.velocity_x) * dt_s
        if not (0.0 <= self.x <= WORLD_SIZE_M and 0.0 <= self.y_down <= WORLD_SIZE_M):
            yield WallHit(self.name, self.x, self.y_down)
            self.x = min(max(self.x, 0.0), WORLD_SIZE_M)
            self.y_down = min(max(self.y_down, 0.0), WORLD_SIZE_M)

    def _draw(self, before: tuple[float, float]) -> Iterator[Stroke]:
        now = self.x, self.y
        if self.pen.is_on and now != before:
            yield Stroke(before, now, self.pen.color, self.pen.width_px)


class World:
    """All turtles, by name. Initially, turtle1 is at the centre.

    Args:
        clock_ns: Returns the time by which commands age [ns]; None: time advances by the steps alone.
    """

    def __init__(self, clock_ns: Callable[[], int] | None = None) -> None:
        self.turtles: dict[str, Turtle] = {}
        self._simulated_ns = 0
        self._count = 0
        self._kinds = count()
        self.now_ns: Callable[[], int] = clock_ns or (lambda: self._simulated_ns)
        self.reset()

    def reset(self) -> Turtle:
        """Remove all turtles and add a new turtle1 at the centre, heading to the right."""
        self.turtles.clear()
        self._count = 0
        turtle = self.spawn(WORLD_SIZE_M / 2, WORLD_SIZE_M / 2, 0.0)
        if turtle is None:
            raise AssertionError  # in an empty world every name is free
        return turtle

    def spawn(self, x: float, y: float, theta: float, name: str = "") -> Turtle | None:
        """Add a turtle; outside of the world it is moved to the edge at the next step.

        Args:
            x: Metres from the left edge.
            y: Metres from the lower edge.
            theta: Heading [rad].
            name: Its name; "": the first free one of turtle1, turtle2, …

        Returns:
            The turtle; None if the name is taken.
        """
        if not name:
            name = self._next_name()
        elif name in self.turtles:
            return None
        turtle = Turtle(name, x, y, theta, self.now_ns(), next(self._kinds))
        self.turtles[name] = turtle
        return turtle

    def _next_name(self) -> str:
        while True:
            self._count += 1
            name = f"turtle{self._count}"
            if name not in self.turtles:
                return name

    def kill(self, name: str) -> Turtle | None:
        """Remove a turtle from the world and return it; None if there is none of this name."""
        return self.turtles.pop(name, None)

    def command(
        self, turtle: Turtle, linear_x: float, linear_y: float | None, angular_z: float
    ) -> Rotation | None:
        """Command a velocity to `turtle`, stamped now; see `Turtle.command`."""
        return turtle.command(linear_x, linear_y, angular_z, self.now_ns())

    def step(self, dt_s: float = STEP_S) -> list[Event]:
        """Advance all turtles by `dt_s`, in order of name; return the events in order."""
        now_ns = self.now_ns()
        events = [event for name in sorted(self.turtles) for event in self.turtles[name].step(dt_s, now_ns)]
        self._simulated_ns += round(dt_s * 1e9)
        return events
