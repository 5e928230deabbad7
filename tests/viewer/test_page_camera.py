"""Where a camera stands that follows a frame, looks down from above, or looks out of a frame."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tfloom.tf2.transform import Transform
from tfloom.viewer.camera import Camera, projected
from tfloom.viewer.frames import FramePoses
from tfloom.viewer.layout.layout import TOP_FOV_RAD, ViewPoint
from tfloom.viewer.page_camera import (
    BEFORE_M,
    EYE_M,
    USUAL_FOV_RAD,
    Following,
    above,
    eye,
    place_of,
    relative,
    rescaled,
    stepped_back,
    view_in,
)

QUARTER_TURN = Transform.from_rpy(0.0, 0.0, math.pi / 2.0).rotation_xyzw
TILTED = Transform.from_rpy(0.3, -0.4, math.pi / 2.0).rotation_xyzw
NORTH = Camera((0.0, -5.0, 5.0), Transform.from_rpy(math.radians(-135.0), 0.0, 0.0).rotation_xyzw, 1.0, 1.5)
"""It looks along y and down."""


def poses(rotation: tuple[float, ...]) -> FramePoses:
    return FramePoses(["base"], np.array([(1.0, 2.0, 3.0)]), np.array([rotation]), np.array([-1]))


def test_camera_that_follows_a_position_moves_and_doesnt_turn() -> None:
    place = place_of(Following(frame="base"), poses(TILTED))
    assert place is not None
    view = view_in(place, ViewPoint((-1.0, 0.0, 0.5), (0.0, 0.0, 0.0)))
    assert (*view.position, *view.look_at) == pytest.approx((0.0, 2.0, 3.5, 1.0, 2.0, 3.0))


def test_camera_that_turns_with_its_frame_stays_upright() -> None:
    place = place_of(Following(frame="base", turns=True), poses(TILTED))
    assert place is not None
    view = view_in(place, ViewPoint((-1.0, 0.0, 0.5), (0.0, 0.0, 0.0)))
    assert (*view.position, *view.look_at) == pytest.approx((1.0, 1.0, 3.5, 1.0, 2.0, 3.0))


def test_camera_in_a_frame_looks_along_its_x_axis() -> None:
    following = Following("first_person", "base")
    place = place_of(following, poses(TILTED))
    assert place is not None
    view = view_in(place, eye())
    assert view.position == pytest.approx((1.0, 2.0, 3.0))
    ahead = np.subtract(view.look_at, view.position) / EYE_M
    assert ahead == pytest.approx(Transform(rotation_xyzw=TILTED).apply((1.0, 0.0, 0.0)))
    # Wherever its user has moved it, it stays in the frame, and looks to where it was turned.
    standing = relative(following, place, ViewPoint((5.0, 2.0, 3.0), (5.0, 9.0, 3.0)), NORTH)
    assert standing.position == (0.0, 0.0, 0.0)
    again = view_in(place, standing)
    assert np.subtract(again.look_at, again.position) == pytest.approx((0.0, EYE_M, 0.0), abs=1e-9)


def test_frame_that_is_gone_has_no_place_and_no_frame_has_the_fixed_one() -> None:
    assert place_of(Following(frame="laser"), poses(QUARTER_TURN)) is None
    free = place_of(Following(), poses(QUARTER_TURN))
    assert free is not None
    assert free.apply((1.0, 2.0, 3.0)) == (1.0, 2.0, 3.0)


@pytest.mark.parametrize("following", [Following(frame="base"), Following(frame="base", turns=True)])
def test_where_a_camera_stands_is_where_it_was(following: Following) -> None:
    place = place_of(following, poses(TILTED))
    assert place is not None
    view = ViewPoint((4.0, 5.0, 6.0), (7.0, 8.0, 9.5))
    again = view_in(place, relative(following, place, view, NORTH))
    assert (*again.position, *again.look_at) == pytest.approx((*view.position, *view.look_at))


def test_view_from_above_keeps_what_is_up_on_the_screen() -> None:
    view = above(ViewPoint(NORTH.position, (0.0, 0.0, 0.0)), NORTH)
    distance_m = math.hypot(5.0, 5.0)
    assert view.look_at == (0.0, 0.0, 0.0)
    assert view.position == pytest.approx((0.0, 0.0, distance_m), abs=0.01)
    assert view.position[1] < 0.0  # north is up
    assert view.position[0] == pytest.approx(0.0, abs=1e-9)


def test_view_from_above_is_all_but_without_perspective_and_shows_as_much() -> None:
    before = ViewPoint((0.0, 0.0, 10.0), (0.0, 0.0, 0.0))
    after = rescaled(before, USUAL_FOV_RAD, "top")
    down = (1.0, 0.0, 0.0, 0.0)
    usual = Camera(before.position, down, USUAL_FOV_RAD, 1.0)
    top = Camera(after.position, down, TOP_FOV_RAD, 1.0)
    low = np.array([(3.0, 2.0, 0.0)])
    assert projected(top, low)[0, :2] == pytest.approx(projected(usual, low)[0, :2])
    high = projected(top, np.array([(3.0, 2.0, 2.0)]))[0, :2]
    assert high == pytest.approx(projected(top, low)[0, :2], abs=0.004)
    assert rescaled(after, TOP_FOV_RAD, "orbit").position == pytest.approx(before.position)
    for fov_rad in (1.0, USUAL_FOV_RAD):  # which an orbit keeps
        assert rescaled(before, fov_rad, "orbit") == before


def test_camera_that_leaves_a_frame_turns_about_what_is_before_it() -> None:
    view = stepped_back(ViewPoint((1.0, 2.0, 3.0), (1.0, 2.0 + EYE_M, 3.0)))
    assert view == ViewPoint((1.0, 2.0, 3.0), (1.0, 2.0 + BEFORE_M, 3.0))
