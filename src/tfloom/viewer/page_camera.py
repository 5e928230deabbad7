"""Where a page's camera stands that follows a frame, looks down from above, or looks out of a frame."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tfloom.tf2.transform import Transform
from tfloom.viewer.layout.layout import TOP_FOV_RAD, ViewPoint

if TYPE_CHECKING:
    from viser import ClientHandle

    from tfloom.viewer.camera import Camera
    from tfloom.viewer.frames import FramePoses

__all__ = ["Following", "above", "eye", "place_of", "relative", "rescaled", "set_lens", "view_in"]

USUAL_FOV_RAD = math.radians(75.0)
MIN_FOV_RAD = 2.0 * TOP_FOV_RAD
"""A camera with a smaller angle looks from above."""
USUAL_RANGE_M = (0.01, 1000.0)
"""From where to where a camera sees."""
ASIDE = 1e-3
"""How far beside what it looks at a camera from above is, by its height: straight from above has no upper side."""
EYE_M = 0.1
"""How far before a camera in a frame the point is to which it looks [m]: so a drag turns it nearly in place."""

BEFORE_M = 3.0
"""How far before a camera that was in a frame the point is about which it then turns [m]."""


class Following(NamedTuple):
    """How a page's camera moves."""

    kind: str = "orbit"
    """As in `layout.CAMERA_KINDS`."""
    frame: str = ""
    """The frame that it follows; empty: none."""
    turns: bool = False
    """Whether it turns with the frame about the vertical, too."""

    @property
    def is_free(self) -> bool:
        """Whether its user alone moves it."""
        return self.kind == "orbit" and not self.frame


def place_of(following: Following, poses: FramePoses) -> Transform | None:
    """Return fixed_from_place, in which the camera stands still; None where the frame is not known."""
    if not following.frame:
        return Transform()
    index = poses.index_of(following.frame)
    if index < 0:
        return None
    x, y, z = poses.positions[index].tolist()
    rotation = poses.rotations_xyzw[index].tolist()
    pose = Transform((x, y, z), rotation)
    if following.kind == "first_person":
        return pose
    yaw_rad = pose.rpy_rad[2] if following.turns else 0.0
    return Transform.from_rpy(0.0, 0.0, yaw_rad, (x, y, z))


def view_in(place: Transform, view_point: ViewPoint) -> ViewPoint:
    """Return a view point of a place in the fixed frame."""
    return ViewPoint(place.apply(view_point.position), place.apply(view_point.look_at))


def relative(following: Following, place: Transform, view_point: ViewPoint, camera: Camera) -> ViewPoint:
    """Return a view point of the fixed frame in a place, as this kind of camera can have it."""
    if following.kind == "top":
        return view_in(place.inverse(), above(view_point, camera))
    inner = view_in(place.inverse(), view_point)
    if following.kind != "first_person":
        return inner
    way = np.subtract(inner.look_at, inner.position)
    x, y, z = (EYE_M * way / max(float(np.linalg.norm(way)), 1e-9)).tolist()
    return ViewPoint((0.0, 0.0, 0.0), (x, y, z))


def above(view_point: ViewPoint, camera: Camera) -> ViewPoint:
    """Return the view point straight above what a camera looks at, whose upper side is that of the camera."""
    # The upper side of the picture is where the camera's own y axis doesn't go; if that is upwards, where it looks.
    turned = Transform(rotation_xyzw=camera.rotation_xyzw)
    up, ahead = np.negative(turned.apply((0.0, 1.0, 0.0))), np.array(turned.apply((0.0, 0.0, 1.0)))
    heading = up[:2] if np.linalg.norm(up[:2]) > np.linalg.norm(ahead[:2]) else ahead[:2]
    heading = heading / max(float(np.linalg.norm(heading)), 1e-9)
    distance_m = math.dist(view_point.position, view_point.look_at)
    x, y, z = view_point.look_at
    across, along = (ASIDE * distance_m * heading).tolist()
    return ViewPoint((x - across, y - along, z + distance_m), (x, y, z))


def eye() -> ViewPoint:
    """Return the view point of a camera in a frame that looks along its x axis."""
    return ViewPoint((0.0, 0.0, 0.0), (EYE_M, 0.0, 0.0))


def set_lens(client: ClientHandle, kind: str, distance_m: float) -> None:
    """Give a page's camera the angle of its kind, and let it see far enough.

    Args:
        client: Viser's client of the page.
        kind: The camera's kind.
        distance_m: From the camera to what it looks at.
    """
    camera = client.camera
    if kind == "top":
        # In steps, because each change is a message.
        step_m = 4.0 ** math.ceil(math.log(max(distance_m, 1.0), 4.0))
        camera.max_orbit_distance = 1e7
        camera.fov, camera.near, camera.far = TOP_FOV_RAD, step_m / 100.0, 10.0 * step_m
    elif camera.fov < MIN_FOV_RAD:
        camera.fov = USUAL_FOV_RAD
        camera.near, camera.far = USUAL_RANGE_M


def rescaled(view_point: ViewPoint, fov_rad: float, kind: str) -> ViewPoint:
    """Return the view point from which a camera of a kind sees as much as one with another angle does."""
    now_rad = TOP_FOV_RAD if kind == "top" else fov_rad if fov_rad >= MIN_FOV_RAD else USUAL_FOV_RAD
    factor = math.tan(fov_rad / 2.0) / math.tan(now_rad / 2.0)
    look_at = np.array(view_point.look_at)
    x, y, z = (look_at + factor * (np.array(view_point.position) - look_at)).tolist()
    return ViewPoint((x, y, z), view_point.look_at)


def stepped_back(view_point: ViewPoint) -> ViewPoint:
    """Return the view point of a camera that was in a frame, so that a drag turns it about what is before it."""
    position, way = np.array(view_point.position), np.subtract(view_point.look_at, view_point.position)
    x, y, z = (position + way / max(float(np.linalg.norm(way)), 1e-9) * BEFORE_M).tolist()
    return ViewPoint(view_point.position, (x, y, z))
