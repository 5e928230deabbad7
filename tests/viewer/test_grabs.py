"""Where a marker goes when one of its own shapes is dragged, as seen from 5 m above; and from elsewhere."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerControl as Control
from tfloom.tf2.transform import Transform
from tfloom.viewer.interactive.grabs import MODES, Grab, sight_of

ABOVE = ((0.0, 0.0, 5.0), (0.0, 1.0, 0.0, 0.0))
"""A camera that looks down."""
HALF = 0.5**0.5
ALONG = {
    "x": Transform(),
    "y": Transform(rotation_xyzw=(0.0, 0.0, HALF, HALF)),
    "z": Transform.from_rpy(0.0, -math.pi / 2, 0.0),
}
"""Rotations of a control whose axis is this one."""
MARKER = Transform((0.0, 0.0, 0.0), (HALF, 0.0, 0.0, HALF))


def dragged(
    mode: int,
    axis: str,
    points: tuple[tuple[float, float, float], ...],
    camera: tuple[tuple[float, ...], tuple[float, ...]] = ABOVE,
    *,
    faces_view: bool = False,
) -> Transform:
    """Return where a marker at the origin is after a drag from the first point over the others."""
    first, *others = (sight_of(*camera, point) for point in points)
    assert first is not None
    grab = Grab(("thing", 0), mode, MARKER, ALONG[axis], first, np.array(points[0]), faces_view=faces_view)
    for sight in others:
        assert sight is not None
        grab.move(sight)
    return grab.place


def turn_since(place: Transform) -> Transform:
    assert place.translation == pytest.approx(MARKER.translation, abs=1e-12)
    return place @ MARKER.inverse()


def test_along_an_axis() -> None:
    place = dragged(Control.MOVE_AXIS, "x", ((0.0, 0.0, 0.5), (9.0, 0.0, 0.5), (2.0, 0.0, 0.5)))
    assert place.translation == pytest.approx((2.0, 0.0, 0.0))
    assert place.rotation_xyzw == pytest.approx(MARKER.rotation_xyzw)
    assert dragged(Control.MOVE_AXIS, "y", ((1.0, 0.0, 0.0), (1.0, -3.0, 0.0))).translation == pytest.approx(
        (0.0, -3.0, 0.0)
    )


def test_pointer_beside_the_axis_moves_to_the_point_that_is_nearest_to_what_is_under_it() -> None:
    eye, pointer = np.array(ABOVE[0]), np.array((2.0, 1.0, 0.5))
    x = dragged(Control.MOVE_AXIS, "x", ((0.0, 0.0, 0.0), tuple(pointer))).translation[0]
    ray = (pointer - eye) / np.linalg.norm(pointer - eye)

    def distance_m(x: float) -> float:
        return float(np.linalg.norm(np.cross(np.array((x, 0.0, 0.0)) - eye, ray)))

    assert distance_m(x) < min(distance_m(x - 1e-3), distance_m(x + 1e-3))


@pytest.mark.parametrize("mode", [Control.MOVE_PLANE, Control.MOVE_ROTATE])
def test_in_a_plane(mode: int) -> None:
    place = dragged(mode, "z", ((0.5, 0.0, 0.0), (1.5, -2.0, 0.0)))
    assert place.translation == pytest.approx((1.0, -2.0, 0.0))
    assert place.rotation_xyzw == pytest.approx(MARKER.rotation_xyzw)
    # What is under the pointer counts, however far it is: this one is half as high as the eye.
    place = dragged(mode, "z", ((0.0, 0.0, 0.0), (1.0, 0.0, 2.5)))
    assert place.translation == pytest.approx((2.0, 0.0, 0.0))


@pytest.mark.parametrize("mode", [Control.MOVE_3D, Control.MOVE_ROTATE_3D])
def test_in_space_in_the_plane_that_faces_the_view(mode: int) -> None:
    place = dragged(mode, "x", ((0.0, 0.0, 1.0), (0.5, 0.25, 1.0)))
    assert place.translation == pytest.approx((0.5, 0.25, 0.0))
    # From the side: the camera looks along +y.
    beside = ((0.0, -4.0, 0.0), (HALF, -HALF, 0.0, 0.0))
    place = dragged(mode, "x", ((0.0, 0.0, 0.0), (0.5, 0.0, 0.25)), beside)
    assert place.translation == pytest.approx((0.5, 0.0, 0.25))


@pytest.mark.parametrize(("axis", "faces_view"), [("z", False), ("x", True)])
def test_round_an_axis(axis: str, faces_view: bool) -> None:
    place = dragged(Control.ROTATE_AXIS, axis, ((1.0, 0.0, 0.0), (0.0, 2.0, 0.0)), faces_view=faces_view)
    assert turn_since(place).rotation_xyzw == pytest.approx((0.0, 0.0, HALF, HALF))
    place = dragged(
        Control.ROTATE_AXIS,
        axis,
        ((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (-1.0, -1.0, 0.0)),
        faces_view=faces_view,
    )
    w = math.cos(math.radians(-135.0 / 2.0))
    assert abs(turn_since(place).rotation_xyzw[3]) == pytest.approx(w)


def test_front_of_a_ball_goes_with_the_pointer() -> None:
    # A quarter of the way round a ball of radius 1 is as long as pi / 2: what was above is then at +x.
    place = dragged(Control.ROTATE_3D, "x", ((0.0, 0.0, 1.0), (math.pi / 2.0, 0.0, 1.0)))
    turned = turn_since(place) @ Transform((0.0, 0.0, 1.0))
    assert turned.translation == pytest.approx((1.0, 0.0, 0.0))


def test_what_says_nothing_of_the_marker_leaves_it() -> None:
    for mode, axis, points in (
        (Control.MOVE_AXIS, "z", ((0.0, 0.0, 1.0), (0.0, 0.0, 2.0))),  # looked along
        (Control.MOVE_PLANE, "x", ((0.0, 0.0, 1.0), (0.0, 1.0, 1.0))),  # seen from its side
        (Control.MOVE_PLANE, "z", ((0.0, 0.0, 1.0), (1.0, 0.0, 6.0))),  # behind the eye
        (Control.MOVE_AXIS, "x", ((0.0, 0.0, 1.0), (1.0, 0.0, 6.0))),
        (Control.ROTATE_AXIS, "z", ((0.0, 0.0, 1.0), (1.0, 0.0, 1.0))),  # grabbed on the axis
        (Control.ROTATE_3D, "z", ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))),
        *((mode, "x", ((0.5, 0.0, 0.25), (0.5, 0.0, 0.25))) for mode in sorted(MODES)),
    ):
        place = dragged(mode, axis, points)
        assert place.translation == pytest.approx(MARKER.translation, abs=1e-9), (mode, axis)
        assert place.rotation_xyzw == pytest.approx(MARKER.rotation_xyzw, abs=1e-9), (mode, axis)


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, 1e300])
def test_numbers_that_no_camera_has_are_no_sight(bad: float) -> None:
    eye, turn = ABOVE
    assert sight_of((bad, 0.0, 0.0), turn, (0.0, 0.0, 0.0)) is None
    assert sight_of(eye, turn, (0.0, bad, 0.0)) is None
    assert sight_of(eye, turn, eye) is None
    assert sight_of(eye, (0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0)) is None
    assert sight_of(eye, (bad, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0)) is None
