"""Where frames are at a time, which are out of date, and trails."""

from __future__ import annotations

import math
import time

import numpy as np
import pytest

from tfloom.tf2.buffer import Buffer
from tfloom.viewer.frames import (
    MAX_TRAIL_POINTS,
    Span,
    connected_from,
    default_fixed_frame,
    frames_at,
    frames_behind,
    span_of,
    trail_of,
)

S = 1_000_000_000
STILL = (0.0, 0.0, 0.0, 1.0)


def moving_robot() -> Buffer:
    """world → base moves along x by 1 m/s for 4 s; base → laser is static; lonely is its own tree."""
    buffer = Buffer()
    for second in range(1, 6):
        buffer.set("world", "base", second * S, (second - 1.0, 0.0, 0.0), STILL, "driver")
    turned = (0.0, 0.0, math.sin(math.pi / 4), math.cos(math.pi / 4))
    buffer.set("base", "laser", 0, (0.0, 1.0, 0.5), turned, static=True)
    buffer.set("moon", "lonely", 0, (0.0, 0.0, 0.0), STILL, static=True)
    return buffer


def test_frames_are_where_lookups_say_at_any_time() -> None:
    buffer = moving_robot()
    for stamp_ns in (0, 2 * S, 2 * S + S // 2):
        poses = frames_at(buffer, "world", stamp_ns)
        assert sorted(poses.names) == ["base", "laser", "world"]  # not what is in another tree
        for index, name in enumerate(poses.names):
            expected = buffer.lookup("world", name, stamp_ns)
            assert poses.positions[index] == pytest.approx(expected.translation)
            assert poses.rotations_xyzw[index] == pytest.approx(expected.rotation_xyzw)
        parents = {poses.names[child]: poses.names[poses.parents[child]] for child in poses.links()}
        assert parents == {"base": "world", "laser": "base"}
        assert poses.parents[poses.index_of("world")] == -1
    half = frames_at(buffer, "world", 2 * S + S // 2)
    assert half.positions[half.index_of("base")] == pytest.approx((1.5, 0.0, 0.0))


def test_frames_in_a_moving_fixed_frame() -> None:
    poses = frames_at(moving_robot(), "base")
    assert poses.positions[poses.index_of("world")] == pytest.approx((-4.0, 0.0, 0.0))
    assert poses.index_of("lonely") == -1


def test_frame_is_absent_outside_of_its_history() -> None:
    assert frames_at(moving_robot(), "world", 9 * S).names == ["world"]
    assert frames_at(moving_robot(), "nowhere").names == []


def test_span_is_that_of_what_moves_and_not_longer_than_the_history() -> None:
    buffer = Buffer(3 * S)
    assert span_of(buffer) is None
    buffer.set("a", "b", 0, (0.0, 0.0, 0.0), STILL, static=True)
    assert span_of(buffer) is None
    buffer.set("b", "ended_long_ago", 1 * S, (0.0, 0.0, 0.0), STILL)
    for second in range(100, 103):
        buffer.set("b", "c", second * S, (0.0, 0.0, 0.0), STILL)
    assert span_of(buffer) == Span(99 * S, 102 * S)
    assert Span(1, 5).clamped(9) == 5


def test_default_fixed_frame_is_a_usual_one_or_the_root_of_the_largest_tree() -> None:
    assert default_fixed_frame({}) == ""
    assert default_fixed_frame({"base": "odom", "odom": None, "zoo": None}) == "odom"
    assert default_fixed_frame({"x": "root", "root": None, "lonely": None}) == "root"
    assert default_fixed_frame({"a": "b", "b": "a"}) in {"a", "b"}  # a loop ends


def test_frame_is_out_of_date_if_a_link_to_the_fixed_frame_is() -> None:
    parents = {"map": None, "odom": "map", "base": "odom", "laser": "base", "arm": "base"}
    assert frames_behind(parents, set(), "map", parents) == set()
    assert frames_behind(parents, {"base"}, "map", parents) == {"base", "laser", "arm"}
    assert frames_behind(parents, {"base"}, "laser", parents) == {"map", "odom"}
    assert frames_behind(parents, {"arm"}, "laser", parents) == {"arm"}


def test_trail_is_the_way_through_the_fixed_frame_up_to_a_time() -> None:
    buffer = moving_robot()
    assert trail_of(buffer, "world", "base")[:, 0] == pytest.approx([0.0, 1.0, 2.0, 3.0, 4.0])
    assert trail_of(buffer, "world", "base", 3 * S)[:, 0] == pytest.approx([0.0, 1.0, 2.0])
    assert trail_of(buffer, "world", "lonely").shape == (0, 3)
    assert len(trail_of(buffer, "base", "laser")) <= 1  # nothing between them moves


def test_long_trail_is_thinned_and_keeps_its_newest_point() -> None:
    buffer = Buffer(None)
    count = 3 * MAX_TRAIL_POINTS + 7
    stamps = np.arange(1, count + 1) * 1_000_000
    positions = np.stack([np.arange(count), np.zeros(count), np.zeros(count)], axis=1).astype(float)
    buffer.set_many("world", "base", stamps, positions, np.tile(STILL, (count, 1)))
    trail = trail_of(buffer, "world", "base")
    assert len(trail) <= MAX_TRAIL_POINTS
    assert trail[-1, 0] == count - 1


def test_frames_whose_parents_are_a_ring_end() -> None:
    ring = {"a": "b", "b": "a", "c": "a"}
    assert frames_behind(ring, {"b"}, "map", ["c", "map"]) == {"c"}
    assert default_fixed_frame(ring) in ring


def buffer_of(*edges: tuple[str, str, int, int]) -> Buffer:
    """Return a buffer with transforms from parents to children, each known from one second to another one."""
    buffer = Buffer(None)
    for parent, child, first, last in edges:
        for second in (first, last):
            buffer.set(parent, child, second * S, (1.0, 0.0, 0.0), STILL, "test")
    buffer.set("base", "laser", 0, (0.0, 1.0, 0.5), STILL, static=True)
    return buffer


@pytest.mark.parametrize(
    ("fixed_frame", "edges", "second"),
    [
        ("map", [("odom", "base", 1, 99), ("map", "odom", 8, 99)], 8),  # the localization starts later
        ("base", [("odom", "base", 1, 99), ("map", "odom", 8, 99)], 1),  # half of them
        ("odom", [("odom", "base", 2, 99), ("moon", "stone", 1, 99)], 2),  # another tree is before
        ("odom", [("odom", "base", 1, 99), ("base", "wheel", 2, 99)], 2),  # within a second after the others
        ("odom", [("odom", "base", 1, 99), ("base", "cup", 60, 70)], 1),  # seen now and then
        ("odom", [("odom", "base", 1, 9), *(("base", cup, 10, 99) for cup in "abc")], 1),  # no cup ever
        ("moon", [("odom", "base", 3, 99)], 3),  # there is no such frame: as without any
        ("map", [("odom", "base", 3, 50), ("map", "odom", 60, 99)], 60),  # map to odom, and never to base
        ("odom", [("odom", "base", 1, 50), ("base", "odom", 60, 99)], 1),  # a loop
        ("moon", [("odom", "base", 1, 99), ("moon", "odom", 99, 99)], 1),  # at the very end
    ],
)
def test_time_from_which_frames_connect(
    fixed_frame: str, edges: list[tuple[str, str, int, int]], second: int
) -> None:
    buffer = buffer_of(*edges)
    span = span_of(buffer)
    assert span is not None
    assert connected_from(buffer, fixed_frame, span) == second * S


def test_time_from_which_many_frames_connect_is_found_at_once() -> None:
    buffer = buffer_of(*((f"f{number}", f"f{number + 1}", 1 + (number > 3), 9) for number in range(20_000)))
    started_s = time.thread_time()
    assert connected_from(buffer, "f0", Span(S, 9 * S)) == 2 * S
    assert time.thread_time() - started_s < 5.0
