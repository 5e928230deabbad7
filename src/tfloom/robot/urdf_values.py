"""Values of attributes of URDF: names, numbers, vectors, and origins."""

from __future__ import annotations

import math
from collections.abc import Iterable

from tfloom._native import Transform
from tfloom.robot.urdf_faults import UrdfError
from tfloom.robot.xml_elements import Element

__all__ = ["number", "origin_of", "required", "vector"]


def origin_of(element: Element, what: str) -> Transform:
    """Return parent_from_child of an element with an <origin>; without one, they are the same frame.

    Raises:
        UrdfError: its numbers are not valid, or it has a rotation as `rpy` and as `quat_xyzw`.
    """
    origin = element.first("origin")
    if origin is None:
        return Transform()
    xyz = vector(origin, "xyz", "0 0 0", what)
    if "quat_xyzw" in origin.attributes:
        if "rpy" in origin.attributes:
            raise UrdfError(origin.line, f"<origin> of {what} has both rpy and quat_xyzw: give one of them")
        return Transform(xyz, _quaternion(origin, what))
    roll, pitch, yaw = vector(origin, "rpy", "0 0 0", what)
    return Transform.from_rpy(roll, pitch, yaw, xyz)


def required(element: Element, attribute: str, what: str) -> str:
    """Return an attribute that has to be there.

    Args:
        element: The element.
        attribute: The attribute's name.
        what: What the element is, for the error.

    Raises:
        UrdfError: it is absent or empty.
    """
    value = element.attributes.get(attribute, "")
    if not value:
        raise UrdfError(element.line, f"{what} has no {attribute}")
    return value


def number(element: Element, attribute: str, default: float | None, what: str) -> float:
    """Return a number; `default` where the attribute is absent, or an error without one.

    Raises:
        UrdfError: it is not a finite number, or it is absent and has no default.
    """
    text = element.attributes.get(attribute)
    if text is None:
        if default is None:
            raise UrdfError(element.line, f"{what} has no {attribute}")
        return default
    return _finite([text], element, attribute, what)[0]


def vector(element: Element, attribute: str, default: str, what: str) -> tuple[float, float, float]:
    """Return three numbers; those of `default` where the attribute is absent.

    Raises:
        UrdfError: they are not three finite numbers.
    """
    words = element.attributes.get(attribute, default).split()
    if len(words) != 3:
        reason = f"{attribute} of <{element.tag}> of {what} has {len(words)} numbers, not 3"
        raise UrdfError(element.line, reason)
    x, y, z = _finite(words, element, attribute, what)
    return x, y, z


def _quaternion(origin: Element, what: str) -> list[float]:
    """Return the unit quaternion (x, y, z, w) of an attribute `quat_xyzw`, which needs not be normalized."""
    words = origin.attributes["quat_xyzw"].split()
    if len(words) != 4:
        raise UrdfError(origin.line, f"quat_xyzw of <origin> of {what} has {len(words)} numbers, not 4")
    numbers = _finite(words, origin, "quat_xyzw", what)
    length = math.hypot(*numbers)
    if not 0.0 < length < math.inf:
        raise UrdfError(origin.line, f"quat_xyzw of <origin> of {what} has no direction: {' '.join(words)}")
    return [value / length for value in numbers]


def _finite(words: Iterable[str], element: Element, attribute: str, what: str) -> list[float]:
    """Return the numbers that words stand for."""
    numbers = []
    for word in words:
        try:
            value = math.nan if "_" in word else float(word)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            reason = f"{attribute} of <{element.tag}> of {what}: '{word}' is not a number"
            raise UrdfError(element.line, reason)
        numbers.append(value)
    return numbers
