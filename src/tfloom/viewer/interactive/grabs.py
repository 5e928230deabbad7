"""Where a marker goes when a page drags one of its own shapes, in place of a gizmo."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerControl
from tfloom.tf2.transform import Transform
from tfloom.viewer.displays.display import MAX_COORDINATE_M

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.interactive.gizmos import Key

__all__ = ["MODES", "Grab", "Sight", "sight_of"]

MIN_SLOPE = 0.02
"""Sine of the smallest angle between what is looked along and a plane, or an axis, on which the pointer has a place."""
MIN_ARM_M = 1e-6
"""What is grabbed nearer to an axis doesn't turn about it."""

_Control = InteractiveMarkerControl
_IN_PLANE = {_Control.MOVE_PLANE, _Control.MOVE_ROTATE}
_IN_SPACE = {_Control.MOVE_3D, _Control.MOVE_ROTATE_3D}
MODES = {_Control.MOVE_AXIS, *_IN_PLANE, *_IN_SPACE, _Control.ROTATE_AXIS, _Control.ROTATE_3D}
"""The modes of controls whose shapes are dragged."""


class Sight(NamedTuple):
    """What a page's pointer is on, in the fixed frame."""

    eye: NDArray[np.float64]
    """Where its camera is [m]."""
    ahead: NDArray[np.float64]
    """Where that looks, of length one."""
    ray: NDArray[np.float64]
    """From there to the pointer, of length one."""

    def on_plane(self, point: NDArray[np.float64], normal: NDArray[np.float64]) -> NDArray[np.float64] | None:
        """Return where the pointer is on a plane; None where that is not seen, or seen nearly from its side."""
        slope = float(self.ray @ normal)
        if abs(slope) < MIN_SLOPE:
            return None
        far_m = float((point - self.eye) @ normal) / slope
        return self.eye + far_m * self.ray if 0.0 < far_m < MAX_COORDINATE_M else None

    def along_line(self, point: NDArray[np.float64], axis: NDArray[np.float64]) -> float | None:
        """Return how far from a point of a line the pointer is nearest to it [m]; None if it looks along the line."""
        across = float(self.ray @ axis)
        if 1.0 - across**2 < MIN_SLOPE**2:
            return None
        # Of the points of both lines, those that are nearest to each other: their difference is perpendicular to both.
        offset = point - self.eye
        along_m = (across * float(self.ray @ offset) - float(axis @ offset)) / (1.0 - across**2)
        is_ahead = float(self.ray @ offset) + across * along_m > 0.0
        return along_m if is_ahead and abs(along_m) < MAX_COORDINATE_M else None


def sight_of(eye: Any, wxyz: Any, pointer: Any) -> Sight | None:
    """Return what a pointer is on, by what a page says of it; None if a number is too large, or it is no direction.

    Args:
        eye: The position of its camera [m], (3,).
        wxyz: The rotation of its camera, which looks along its z axis, (4,).
        pointer: A point that is under the pointer [m], (3,).
    """
    here, turn, there = (np.asarray(values, np.float64) for values in (eye, wxyz, pointer))
    if not all((np.abs(values) < MAX_COORDINATE_M).all() for values in (here, turn, there)):
        return None
    far_m, length = float(np.linalg.norm(there - here)), float(np.linalg.norm(turn))
    if min(far_m, length) < MIN_ARM_M:
        return None
    w, x, y, z = (turn / length).tolist()
    return Sight(here, _axis_of(Transform(rotation_xyzw=(x, y, z, w)), 2), (there - here) / far_m)


class Grab:
    """A shape of a control that a page holds.

    Args:
        key: The marker, and the control.
        mode: Of the control, one of MODES.
        place: The pose of the marker at the start, in the fixed frame.
        turn: The rotation of the control, whose axis is its x axis, in the fixed frame.
        sight: What the pointer was on.
        point: The point of the shape that was grabbed [m], (3,).
        faces_view: Whether the axis is where the camera looks.
    """

    def __init__(
        self,
        key: Key,
        mode: int,
        place: Transform,
        turn: Transform,
        sight: Sight,
        point: NDArray[np.float64],
        *,
        faces_view: bool,
    ) -> None:
        self.key = key
        self.place = place
        """Where the marker is to be."""
        self._mode = mode
        self._start = place
        self._origin = np.array(place.translation)
        self._point = point
        is_across_view = faces_view or mode in _IN_SPACE or mode == _Control.ROTATE_3D
        self._axis = sight.ahead if is_across_view else _axis_of(turn, 0)

    def move(self, sight: Sight) -> None:
        """Take the next place of the pointer. One that says nothing of the marker leaves it where it is."""
        if self._mode == _Control.MOVE_AXIS:
            along_m = sight.along_line(self._point, self._axis)
            if along_m is not None:
                self._shift(along_m * self._axis)
            return
        found = sight.on_plane(self._point, self._axis)
        if found is None:
            return
        if self._mode in _IN_PLANE or self._mode in _IN_SPACE:
            self._shift(found - self._point)
        elif self._mode == _Control.ROTATE_AXIS:
            self._turn_about_axis(found)
        else:
            self._roll(found - self._point)

    def _shift(self, by_m: NDArray[np.float64]) -> None:
        x, y, z = (self._origin + by_m).tolist()
        self.place = Transform((x, y, z), self._start.rotation_xyzw)

    def _turn_about_axis(self, found: NDArray[np.float64]) -> None:
        """Turn as far about the axis as the pointer has gone round the marker."""
        before, now = (
            arm - float(arm @ self._axis) * self._axis
            for arm in (self._point - self._origin, found - self._origin)
        )
        if min(float(np.linalg.norm(before)), float(np.linalg.norm(now))) > MIN_ARM_M:
            self._turn(self._axis, math.atan2(float(self._axis @ np.cross(before, now)), float(before @ now)))

    def _roll(self, by_m: NDArray[np.float64]) -> None:
        """Turn like a ball about the marker's origin, of which the front goes with the pointer."""
        radius_m = float(np.linalg.norm(self._point - self._origin))
        moved_m = float(np.linalg.norm(by_m))
        if radius_m > MIN_ARM_M and moved_m > MIN_ARM_M:
            self._turn(np.cross(-self._axis, by_m), moved_m / radius_m)

    def _turn(self, axis: NDArray[np.float64], angle_rad: float) -> None:
        turned = Transform.from_axis_angle(axis.tolist(), angle_rad) @ Transform(
            rotation_xyzw=self._start.rotation_xyzw
        )
        self.place = Transform(self._start.translation, turned.rotation_xyzw)


def _axis_of(turn: Transform, number: int) -> NDArray[np.float64]:
    """Return an axis of a rotation, of length one."""
    unit = [0.0, 0.0, 0.0]
    unit[number] = 1.0
    return np.array((Transform(rotation_xyzw=turn.rotation_xyzw) @ Transform(unit)).translation)
