"""A static transform, its rotation from three angles, and the arguments of a command line that state one."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

__all__ = [
    "EULER",
    "FLAGS",
    "FRAMES",
    "OLD_FORMS",
    "QUATERNION",
    "TRANSLATION",
    "USAGE",
    "Arguments",
    "ArgumentsError",
    "StaticTransform",
    "parse",
    "quaternion_from_rpy",
]


class StaticTransform(NamedTuple):
    """A transform that never changes: frame_from_child."""

    frame_id: str
    child_frame_id: str
    translation: tuple[float, float, float]
    """[m]."""
    rotation_xyzw: tuple[float, float, float, float]


def quaternion_from_rpy(
    roll_rad: float, pitch_rad: float, yaw_rad: float
) -> tuple[float, float, float, float]:
    """Return the quaternion (x, y, z, w) of turns about the fixed axes x, y and z, in this order."""
    cr, sr = math.cos(roll_rad / 2), math.sin(roll_rad / 2)
    cp, sp = math.cos(pitch_rad / 2), math.sin(pitch_rad / 2)
    cy, sy = math.cos(yaw_rad / 2), math.sin(yaw_rad / 2)
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


USAGE = """\
usage: static_transform_publisher [--x X] [--y Y] [--z Z] \\
           [--qx QX --qy QY --qz QZ --qw QW | --roll ROLL --pitch PITCH --yaw YAW] \\
           --frame-id FRAME --child-frame-id CHILD_FRAME [--ros-args ...]

Publish one static transform on /tf_static: the pose of CHILD_FRAME in FRAME.

  --x --y --z              position of CHILD_FRAME's origin in FRAME [m]; 0 where left out
  --qx --qy --qz --qw      rotation as a quaternion; no rotation where left out
  --roll --pitch --yaw     rotation about FRAME's x, then y, then z axis [rad]
  --frame-id               the parent frame
  --child-frame-id         the child frame

The older form still works: X Y Z YAW PITCH ROLL FRAME CHILD_FRAME, or X Y Z QX QY QZ QW FRAME CHILD_FRAME."""

TRANSLATION = ("--x", "--y", "--z")
QUATERNION = ("--qx", "--qy", "--qz", "--qw")
EULER = ("--roll", "--pitch", "--yaw")
FRAMES = ("--frame-id", "--child-frame-id")
FLAGS = {*TRANSLATION, *QUATERNION, *EULER, *FRAMES}
OLD_FORMS = {
    8: (*TRANSLATION, "--yaw", "--pitch", "--roll", *FRAMES),
    9: (*TRANSLATION, *QUATERNION, *FRAMES),
}
"""The meanings of the words in the older form, by the number of words."""


class ArgumentsError(ValueError):
    """The command line is invalid; the text has the reason."""


class Arguments(NamedTuple):
    """What a command line asks for."""

    transform: StaticTransform
    is_old_form: bool
    """Whether the command line was of the older form."""


def parse(words: Sequence[str]) -> Arguments:
    """Read a command line without its ROS arguments.

    Raises:
        ArgumentsError: words are missing, too many or not numbers, two forms are mixed, or a frame has no name.
    """
    if not words:
        raise ArgumentsError("Not enough arguments to parse")
    flags, rest = _split(words)
    if rest and flags:
        text = "Extra unparsed arguments on command-line"
        if len(rest) in OLD_FORMS:
            text = "Cannot specify both new-style (flags) and old-style (arguments)"
        raise ArgumentsError(text)
    if rest:
        if len(rest) < min(OLD_FORMS):
            raise ArgumentsError("Not enough arguments to parse")
        if len(rest) not in OLD_FORMS:
            raise ArgumentsError("Extra unparsed arguments on command-line")
        flags = dict(zip(OLD_FORMS[len(rest)], rest, strict=True))
    return Arguments(_build(flags), is_old_form=bool(rest))


def _split(words: Sequence[str]) -> tuple[dict[str, str], list[str]]:
    """Separate flags with their values from the other words."""
    flags: dict[str, str] = {}
    rest: list[str] = []
    coming = iter(words)
    for word in coming:
        if word not in FLAGS:
            rest.append(word)
            continue
        value = next(coming, None)
        if value is None:
            raise ArgumentsError(f"Not enough arguments for {word}")
        flags[word] = value
    return flags, rest


def _build(flags: dict[str, str]) -> StaticTransform:
    numbers = {name: _number(name, value) for name, value in flags.items() if name not in FRAMES}
    if numbers.keys() & set(QUATERNION) and numbers.keys() & set(EULER):
        raise ArgumentsError("Cannot specify both quaternion and Euler rotations")
    for name, what in zip(FRAMES, ("Frame id", "Child frame id"), strict=True):
        if not flags.get(name):
            raise ArgumentsError(f"{what} must not be empty")
    x, y, z = (numbers.get(name, 0.0) for name in TRANSLATION)
    if numbers.keys() & set(EULER):
        rotation = quaternion_from_rpy(*(numbers.get(name, 0.0) for name in EULER))
    else:
        defaults = (0.0, 0.0, 0.0, 1.0)
        qx, qy, qz, qw = (
            numbers.get(name, default) for name, default in zip(QUATERNION, defaults, strict=True)
        )
        rotation = qx, qy, qz, qw
    if not any(rotation):
        raise ArgumentsError("A quaternion of zeros is not a rotation")
    return StaticTransform(flags["--frame-id"], flags["--child-frame-id"], (x, y, z), rotation)


def _number(flag: str, text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise ArgumentsError(f"Failed to parse {flag} argument as float")
    return number
