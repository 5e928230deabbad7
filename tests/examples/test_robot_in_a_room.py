"""The robot in a room by itself: rays, wheels, map and matching with known answers, and a mapper fed wrongly."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from tests.conftest import wait_until
from tests.examples.conftest import room_modules

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import PoseWithCovarianceStamped, Twist
from tfloom.interfaces.sensor_msgs.msg import LaserScan
from tfloom.node import client_library as rclpy

Load = Callable[[str], ModuleType]
HALL = ((-2.0, -1.0), (2.0, -1.0), (2.0, 1.0), (-2.0, 1.0))
ANGLES = np.linspace(-math.pi, math.pi, 360, endpoint=False)


def hits(room: Any, x: float, y: float, yaw: float, limit: float = 8.0, noise: float = 0.01) -> np.ndarray:
    """Return where a laser's rays meet something, in the laser's frame."""
    ranges = room.ranges((x, y), ANGLES + yaw)
    ranges = ranges + np.random.default_rng(1).normal(0.0, noise, len(ranges))
    ends = np.stack((np.cos(ANGLES), np.sin(ANGLES)), axis=1) * ranges[:, np.newaxis]
    return ends[ranges < limit]


@pytest.fixture(scope="module")
def mapped_room() -> Any:
    """The map of the room from four places whose poses are known."""
    with room_modules() as load:
        planar, occupancy, room = load("planar"), load("occupancy"), load("room")
        grid = occupancy.OccupancyMap()
        for x, y in ((0.0, 0.0), (3.0, -1.5), (6.0, 2.5), (-1.5, 3.5)):
            for _ in range(3):
                grid.insert(planar.Pose2D(x, y), hits(room.Room(), x, y, 0.0), np.empty((0, 2)))
    return grid


@pytest.fixture
def room_map(mapped_room: Any) -> Any:
    return copy.deepcopy(mapped_room)


@pytest.mark.parametrize(
    ("degrees", "distance"),
    [
        (0.0, 0.75),  # the pillar
        (90.0, 1.0),
        (180.0, 2.0),
        (-90.0, 1.0),
        (135.0, math.sqrt(2.0)),
        (math.degrees(math.atan2(1.0, -2.0)), math.sqrt(5.0)),  # a corner
    ],
)
def test_rays_end_where_the_geometry_says(load_room: Load, degrees: float, distance: float) -> None:
    room = load_room("room").Room([HALL], [(1.0, 0.0, 0.25)])
    assert room.ranges((0.0, 0.0), np.radians([degrees])) == pytest.approx([distance])


def test_rays_into_nothing_have_no_end(load_room: Load) -> None:
    empty = load_room("room").Room([], [])
    assert (empty.ranges((0.0, 0.0), ANGLES) == np.inf).all()
    behind = load_room("room").Room([], [(-3.0, 0.0, 0.5)])
    assert behind.ranges((0.0, 0.0), np.array([0.0, math.pi])).tolist() == [math.inf, 2.5]
    plate = load_room("room").Room([((1.0, -1.0), (1.0, 1.0))], [])
    beside, on_it = np.arctan2([1.02, 0.98], 1.0)
    assert plate.ranges((0.0, 0.0), np.array([beside, on_it])) == pytest.approx(
        [math.inf, math.hypot(1.0, 0.98)]
    )


def test_clearance_is_that_to_the_nearest_thing(load_room: Load) -> None:
    room = load_room("room").Room([HALL], [(1.0, 0.0, 0.25)])
    assert room.clearance(0.0, 0.0) == pytest.approx(0.75)
    assert room.clearance(-1.7, 0.0) == pytest.approx(0.3)
    assert room.clearance(3.0, 2.0) == pytest.approx(math.sqrt(2.0))  # of a corner, from outside
    assert room.clearance(1.0, 0.1) == pytest.approx(-0.15)


def test_exact_wheels_drive_a_circle(load_room: Load) -> None:
    drive = load_room("differential_drive").DifferentialDrive(
        load_room("room").Room([], []), wheel_error=0.0, track_error=0.0, slip=0.0
    )
    drive.speed = (0.5, 0.5)  # at full speed from the start, on a circle of 1 m
    drive.drive(0.5, 0.5)
    drive.step(math.pi)  # a quarter of it
    assert drive.truth == pytest.approx((1.0, 1.0, math.pi / 2.0), abs=1e-9)
    assert drive.odometry == pytest.approx(drive.truth)
    left, right = drive.wheels
    assert (left, right) == pytest.approx((0.82 * 5.0 * math.pi, 1.18 * 5.0 * math.pi))


def test_odometry_drifts_as_the_wheels_differ(load_room: Load) -> None:
    drive = load_room("differential_drive").DifferentialDrive(
        load_room("room").Room([], []), wheel_error=0.01, track_error=0.0, slip=0.0
    )
    drive.speed = (0.5, 0.0)
    drive.drive(0.5, 0.0)
    drive.step(10.0)
    assert drive.odometry == pytest.approx((5.0, 0.0, 0.0))
    assert drive.truth.yaw == pytest.approx(
        -5.0 * 0.01 / 0.36
    )  # the smaller right wheel turns it to the right
    assert drive.truth.y < -0.3


def test_acceleration_and_speed_are_limited(load_room: Load) -> None:
    drive = load_room("differential_drive").DifferentialDrive(load_room("room").Room([], []))
    drive.drive(100.0, -100.0)
    drive.step(0.1)
    assert drive.speed == pytest.approx((0.15, -0.4))
    drive.step(5.0)
    assert drive.speed == (0.8, -1.6)
    for speed in (math.nan, math.inf):
        with pytest.raises(ValueError, match="a speed has to be finite, not"):
            drive.drive(speed, 0.0)
    assert drive.command == (0.8, -1.6)


def test_robot_stands_at_a_wall_while_its_wheels_turn(load_room: Load) -> None:
    drive = load_room("differential_drive").DifferentialDrive(
        load_room("room").Room([HALL], []), wheel_error=0.0, track_error=0.0, slip=0.0
    )
    drive.drive(0.5, 0.0)
    drive.step(10.0)
    assert drive.is_blocked
    assert 1.70 < drive.truth.x <= 1.75 + 1e-9
    assert drive.odometry.x > 4.0
    drive.drive(-0.5, 0.0)
    drive.step(2.0)
    assert not drive.is_blocked
    assert drive.truth.x < 1.5


def test_ray_leaves_free_cells_and_an_occupied_end(load_room: Load) -> None:
    planar, occupancy = load_room("planar"), load_room("occupancy")
    grid = occupancy.OccupancyMap()
    for _ in range(3):
        grid.insert(planar.Pose2D(0.0, 0.0, math.pi / 2.0), np.array([[1.0, 0.01]]), np.array([[0.01, -0.5]]))
    percentages = grid.percentages()

    def at(x: float, y: float) -> int:
        ((column, row),) = grid.cells(np.array([[x, y]]))
        return int(percentages[row, column])

    assert at(-0.01, 1.0) > 90
    assert 0 <= at(-0.01, 0.5) < 30
    assert 0 <= at(0.4, 0.0) < 30
    assert at(0.52, 0.0) == -1  # the end of a ray that met nothing
    assert at(-0.01, 1.06) == -1
    # What has gone is forgotten after some rays through its place.
    for _ in range(15):
        grid.insert(planar.Pose2D(0.0, 0.0, math.pi / 2.0), np.array([[1.5, 0.01]]), np.empty((0, 2)))
    percentages = grid.percentages()
    assert at(-0.01, 1.0) < 50
    assert at(-0.01, 1.5) > 90


def test_cell_in_which_a_ray_ends_is_not_passed_by_another(load_room: Load) -> None:
    planar, occupancy = load_room("planar"), load_room("occupancy")
    grid = occupancy.OccupancyMap()
    grid.insert(planar.Pose2D(), np.array([[1.01, 0.01], [1.51, 0.012]]), np.empty((0, 2)))
    ((column, row),) = grid.cells(np.array([[1.01, 0.01]]))
    assert grid.log_odds[row, column] == np.float32(occupancy.HIT)


def test_what_was_seen_for_long_is_forgotten_as_fast(load_room: Load) -> None:
    planar, occupancy = load_room("planar"), load_room("occupancy")
    grid = occupancy.OccupancyMap()
    for _ in range(100):
        grid.insert(planar.Pose2D(), np.array([[1.01, 0.01]]), np.empty((0, 2)))
    for _ in range(15):
        grid.insert(planar.Pose2D(), np.array([[1.51, 0.012]]), np.empty((0, 2)))
    ((column, row),) = grid.cells(np.array([[1.01, 0.01]]))
    assert grid.log_odds[row, column] < 0.0


def test_wall_is_known_more_exactly_than_a_cell(load_room: Load) -> None:
    planar, occupancy = load_room("planar"), load_room("occupancy")
    grid = occupancy.OccupancyMap()
    for x in (1.001, 1.003, 1.005):
        grid.insert(planar.Pose2D(), np.array([[x, 0.011]]), np.empty((0, 2)))
    ((cell, wall),) = zip(*grid.occupied(), strict=True)
    assert grid.origin + wall * occupancy.RESOLUTION_M == pytest.approx([1.003, 0.011])
    assert np.floor(wall).tolist() == cell.tolist()
    for _ in range(12):  # rays through it
        grid.insert(planar.Pose2D(), np.array([[1.5, 0.015]]), np.empty((0, 2)))
    ((_, wall),) = zip(*grid.occupied(), strict=True)
    assert grid.origin + wall * occupancy.RESOLUTION_M == pytest.approx([1.5, 0.015])


def test_map_grows_to_all_sides_and_keeps_its_cells(load_room: Load) -> None:
    planar, occupancy = load_room("planar"), load_room("occupancy")
    grid = occupancy.OccupancyMap()
    ends = np.array([[3.02, 0.02], [0.02, 3.02], [-3.02, 0.02], [0.02, -3.02]])
    for end in ends:
        grid.insert(planar.Pose2D(), end[np.newaxis], np.empty((0, 2)))
    cells = grid.cells(ends)
    assert (grid.percentages()[cells[:, 1], cells[:, 0]] > 65).all()
    before = grid.log_odds.copy()
    with pytest.raises(occupancy.GridError, match="the map would be larger than 100 m"):
        grid.insert(planar.Pose2D(), np.array([[1e6, 0.0]]), np.empty((0, 2)))
    np.testing.assert_array_equal(grid.log_odds, before)


@pytest.mark.parametrize("position", [(1.0, -0.6, 0.3), (5.8, -1.4, 1.6), (1.1, 3.4, -2.0)])
@pytest.mark.parametrize(
    ("search", "offset"),
    [
        ("NEAR", (0.0, 0.0, 0.0)),
        ("NEAR", (0.2, -0.15, 0.1)),
        ("NEAR", (-0.25, 0.25, -0.15)),
        ("WIDE", (0.8, -0.7, 0.4)),
        ("WIDE", (-0.9, 0.1, -0.45)),
    ],
)
def test_known_displacement_is_recovered_within_a_cell(
    load_room: Load,
    room_map: Any,
    position: tuple[float, float, float],
    search: str,
    offset: tuple[float, float, float],
) -> None:
    planar, matching, room = load_room("planar"), load_room("matching"), load_room("room")
    truth = planar.Pose2D(*position)
    expected = planar.Pose2D(truth.x + offset[0], truth.y + offset[1], truth.yaw + offset[2])
    found = matching.match(room_map, hits(room.Room(), *truth), expected, getattr(matching, search))
    assert found.is_found
    assert found.problem == ""
    assert math.hypot(found.pose.x - truth.x, found.pose.y - truth.y) < 0.05
    assert abs(math.remainder(found.pose.yaw - truth.yaw, math.tau)) < 0.02


def test_pose_is_found_between_the_cells(load_room: Load) -> None:
    planar, matching, room = load_room("planar"), load_room("matching"), load_room("room").Room()
    grid = load_room("occupancy").OccupancyMap()
    for step in range(20):
        truth = planar.Pose2D(0.1 * step, -0.03 * step, 0.02 * step)
        grid.insert(truth, hits(room, *truth), np.empty((0, 2)))
    errors = []
    for step in range(10):
        truth = planar.Pose2D(0.05 + 0.19 * step, -0.05 * step, 0.01 + 0.04 * step)
        expected = planar.Pose2D(truth.x + 0.012, truth.y - 0.013, truth.yaw + 0.011)
        found = matching.match(grid, hits(room, *truth), expected).pose
        errors.append((found.x - truth.x, found.y - truth.y, found.yaw - truth.yaw))
    x, y, yaw = np.sqrt(np.mean(np.square(errors), axis=0))
    assert max(x, y) < 0.008
    assert yaw < 0.004


def test_scan_of_another_place_does_not_fit(load_room: Load, room_map: Any) -> None:
    planar, matching, room = load_room("planar"), load_room("matching"), load_room("room")
    elsewhere = room.Room([HALL], [(1.0, 0.4, 0.25)])
    expected = planar.Pose2D(6.0, 2.5, 0.3)
    found = matching.match(room_map, hits(elsewhere, 0.0, 0.0, 0.0), expected)
    assert not found.is_found
    assert found.pose == expected
    assert found.problem.startswith("the scan does not fit the map")


def test_nothing_in_range_matches_nothing(load_room: Load, room_map: Any) -> None:
    planar, matching = load_room("planar"), load_room("matching")
    expected = planar.Pose2D(1.0, 2.0, 3.0)
    for points in (np.empty((0, 2)), np.full((20, 2), 0.5)):
        found = matching.match(room_map, points, expected)
        assert (found.is_found, found.pose) == (False, expected)
        assert found.problem == f"the laser sees too little: {len(points)} points"


def test_corridor_corrects_across_and_keeps_along(load_room: Load) -> None:
    planar, matching, room = load_room("planar"), load_room("matching"), load_room("room")
    corridor = room.Room([[(-30.0, -1.0), (30.0, -1.0), (30.0, 1.0), (-30.0, 1.0)]], [])
    grid = load_room("occupancy").OccupancyMap()
    for x in (-2.0, 0.0, 2.0):
        grid.insert(planar.Pose2D(x, 0.0), hits(corridor, x, 0.0, 0.0), np.empty((0, 2)))
    expected = planar.Pose2D(0.2, 0.15, 0.1)
    found = matching.match(grid, hits(corridor, 0.0, 0.0, 0.0), expected)
    assert found.is_found
    assert found.problem.startswith("all walls run alike")
    assert found.pose.x == pytest.approx(expected.x, abs=0.03)
    assert abs(found.pose.y) < 0.05
    assert abs(found.pose.yaw) < 0.02


class Feed:
    """Feeds a mapper: scans at true poses, and the odometry's transforms at other ones."""

    def __init__(self, load_room: Load) -> None:
        self.planar, self.module = load_room("planar"), load_room("mapper")
        self.room = load_room("room").Room()
        self.node = self.module.Mapper()
        self.seconds = 100.0

    def scan(self, truth: Any, ranges: Any = None) -> LaserScan:
        if ranges is None:
            ranges = self.room.ranges((truth.x, truth.y), ANGLES + truth.yaw)
            ranges[ranges > 8.0] = math.inf
        message = LaserScan(
            angle_min=-math.pi, angle_increment=math.tau / 360, range_min=0.1, range_max=8.0, ranges=ranges
        )
        message.header.frame_id, message.header.stamp = "laser", Time(sec=int(self.seconds))
        return message

    def see(self, truth: Any, odometry: Any = None, ranges: Any = None) -> Any:
        """Let a second pass, and the mapper use a scan; return its correction."""
        self.seconds += 1.0
        message = self.scan(truth, ranges)
        self.node.on_scan(message)
        odometry = truth if odometry is None else odometry
        for frames in (("odom", "laser"), ("odom", "base_link")):
            transform = self.planar.transform_message(*frames, message.header.stamp, odometry)
            self.node.buffer.set_transform(transform, "test")
        self.node.on_timer()
        assert self.node.scan is None
        return self.node.map_from_odom

    def tour(self, drift: Any) -> None:
        """Go round the room, with an odometry that is the truth seen from a drifting frame."""
        for step in range(0, 25, 2):
            truth = self.planar.Pose2D(0.12 * step, -0.05 * step, 0.02 * step)
            part = step / 24
            self.see(truth, self.planar.Pose2D(*(part * value for value in drift)).inverse() @ truth)


@pytest.fixture
def feed(load_room: Load, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Any:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    rclpy.init(args=[], signal_handler_options=rclpy.SignalHandlerOptions.NO)
    made = Feed(load_room)
    yield made
    made.node.destroy_node()
    context = rclpy.get_default_context()
    rclpy.try_shutdown()
    context.destroy()


def logged(capsys: pytest.CaptureFixture[str]) -> list[str]:
    """Return the lines since the last call, without their heads."""
    return [line.partition("]: ")[2] for line in capsys.readouterr().err.splitlines()]


def test_mapper_finds_the_drift(feed: Feed, capsys: pytest.CaptureFixture[str]) -> None:
    drift = (0.5, -0.4, 0.3)
    feed.tour(drift)
    correction = feed.node.map_from_odom
    assert correction[:2] == pytest.approx(drift[:2], abs=0.06)
    assert correction.yaw == pytest.approx(drift[2], abs=0.02)
    assert logged(capsys) == []


def test_second_mapper_on_the_graph_is_reported_once(feed: Feed, capsys: pytest.CaptureFixture[str]) -> None:
    feed.node.publish_map()
    assert logged(capsys) == []
    second = feed.module.Mapper()
    try:
        wait_until(lambda: feed.node.count_publishers("map") == 2)
        for _ in range(2):
            feed.node.publish_map()
        # Both have one name, which is logged, too.
        (line,) = (line for line in logged(capsys) if "publisher(s)" in line)
        assert line.startswith("/map has 1 more publisher(s): map → odom jumps between")
    finally:
        second.destroy_node()
    wait_until(lambda: feed.node.count_publishers("map") == 1)
    feed.node.publish_map()
    assert logged(capsys) == []


def test_scan_that_does_not_fit_changes_nothing_and_is_reported_once(
    feed: Feed, capsys: pytest.CaptureFixture[str]
) -> None:
    pose = feed.planar.Pose2D
    feed.tour((0.2, 0.1, 0.1))
    before, cells = feed.node.map_from_odom, feed.node.grid.log_odds.copy()
    wrong = 0.5 + np.abs(np.sin(ANGLES * 9.0))
    for step in range(8):
        assert feed.see(pose(3.0 + 0.2 * step, -1.2), ranges=wrong) == before
    np.testing.assert_array_equal(feed.node.grid.log_odds, cells)
    (line,) = logged(capsys)
    assert line.startswith("The scan does not fit the map")
    assert line.endswith("map → odom stays as it is")
    truth = pose(2.9, -1.2, 0.5)
    feed.see(truth, before.inverse() @ truth)
    assert logged(capsys) == ["Scans fit the map again"]


def test_ranges_that_say_nothing_change_nothing(feed: Feed, capsys: pytest.CaptureFixture[str]) -> None:
    truth = feed.planar.Pose2D(2.5, 0.0)
    feed.tour((0.2, 0.1, 0.1))
    for wrong in (math.nan, math.inf, -math.inf, 0.0, -1.0, 1e30):
        before = feed.node.map_from_odom
        assert feed.see(truth, ranges=np.full(360, wrong)) == before, wrong
        assert logged(capsys) == ["The laser sees too little: 0 points; map → odom stays as it is"], wrong
        feed.see(truth, before.inverse() @ truth)
        assert logged(capsys) == ["Scans fit the map again"], wrong


def test_single_wrong_ranges_are_left_out(feed: Feed) -> None:
    hit, free = feed.module.rays(
        LaserScan(
            angle_increment=0.1,
            range_min=0.1,
            range_max=8.0,
            ranges=[1.0, math.nan, math.inf, -math.inf, 0.0, 0.05, 9.0, 2.0],
        )
    )
    np.testing.assert_allclose(np.linalg.norm(hit, axis=1), [1.0, 2.0])
    np.testing.assert_allclose(np.linalg.norm(free, axis=1), [8.0])
    np.testing.assert_allclose(np.arctan2(free[:, 1], free[:, 0]), [0.2])
    for field in ("angle_min", "angle_increment", "range_min", "range_max"):
        scan = LaserScan(angle_increment=0.1, range_max=8.0, ranges=[1.0])
        setattr(scan, field, math.nan)
        assert [len(part) for part in feed.module.rays(scan)] == [0, 0]
    assert [len(part) for part in feed.module.rays(LaserScan())] == [0, 0]
    _, free = feed.module.rays(LaserScan(angle_increment=0.1, range_max=-1.0, ranges=[math.inf, 1.0]))
    np.testing.assert_allclose(free, [[0.0, 0.0]])


def test_very_many_rays_are_thinned_out(feed: Feed) -> None:
    count = 100_001
    hit, _ = feed.module.rays(
        LaserScan(angle_increment=math.tau / count, range_max=8.0, ranges=np.full(count, 2.0))
    )
    assert 1000 < len(hit) <= feed.module.MAX_RAYS
    angles = np.unwrap(np.arctan2(hit[:, 1], hit[:, 0]))
    np.testing.assert_allclose(np.diff(angles), math.tau / len(hit), rtol=0.01)
    assert angles[-1] == pytest.approx(math.tau, abs=0.01)
    truth = feed.planar.Pose2D()
    feed.node.grid.insert(truth, hit, np.empty((0, 2)))
    assert feed.node.grid.log_odds.max() > 0.0


def test_map_does_not_begin_with_nothing(feed: Feed, capsys: pytest.CaptureFixture[str]) -> None:
    pose = feed.planar.Pose2D
    feed.see(pose(), ranges=np.full(360, np.inf))
    feed.see(pose(0.5), ranges=np.full(360, np.inf))
    assert logged(capsys) == ["The laser sees nothing, so the map can't begin"]
    feed.see(pose(1.0))
    assert feed.node.grid.log_odds.size
    assert logged(capsys) == ["Scans fit the map again"]


def test_silent_laser_is_reported_once(
    feed: Feed, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    feed.see(feed.planar.Pose2D())
    before = feed.node.map_from_odom
    monkeypatch.setattr(feed.module, "SILENCE_S", 0.0)
    for _ in range(3):
        feed.node.on_timer()
    assert logged(capsys) == ["No scan for 0 s: map → odom stays as it is"]
    assert feed.node.map_from_odom == before
    monkeypatch.setattr(feed.module, "SILENCE_S", 60.0)
    feed.see(feed.planar.Pose2D(0.2))
    assert logged(capsys) == ["Scans are received again"]


@pytest.mark.parametrize("begins_anew", [True, False])
def test_time_that_jumps_back_keeps_the_map(
    feed: Feed, begins_anew: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    """A recording that is played again begins with the first odometry; a clock that is set goes on with the last."""
    drift = feed.planar.Pose2D(1.6, -1.3, 0.7)
    feed.tour(drift)
    cells = feed.node.grid.log_odds.shape
    feed.seconds = 50.0
    truth = feed.planar.Pose2D(0.1, 0.0, 0.05) if begins_anew else feed.planar.Pose2D(2.7, -1.1, 0.4)
    correction = feed.see(truth, truth if begins_anew else drift.inverse() @ truth)
    expected = feed.planar.Pose2D() if begins_anew else drift
    assert correction[:2] == pytest.approx(expected[:2], abs=0.1)
    assert correction.yaw == pytest.approx(expected.yaw, abs=0.03)
    assert feed.node.grid.log_odds.shape == cells
    assert logged(capsys) == ["The time of the scans jumped back by 62.0 s"]


def test_initial_pose_finds_a_lost_robot(feed: Feed, capsys: pytest.CaptureFixture[str]) -> None:
    pose = feed.planar.Pose2D
    feed.tour((0.0, 0.0, 0.0))
    truth, odometry = pose(5.9, 1.2, 1.5), pose(0.5, 0.5, -1.0)  # carried away
    for step in range(4):
        feed.see(truth, odometry @ pose(0.15 * step))
    assert "does not fit" in logged(capsys)[0]
    message = PoseWithCovarianceStamped()
    message.header.frame_id = "map"
    feed.planar.fill_pose(message.pose.pose, pose(5.6, 1.5, 1.3))
    odometry @= pose(0.45)
    feed.node.on_initial_pose(message)
    found = feed.see(truth, odometry) @ odometry
    assert found[:2] == pytest.approx(truth[:2], abs=0.06)
    assert found.yaw == pytest.approx(truth.yaw, abs=0.03)
    assert logged(capsys) == ["The robot is at 5.60, 1.50, 74°", "Scans fit the map again"]
    message.header.frame_id = "laser"
    feed.node.on_initial_pose(message)
    message.header.frame_id, message.pose.pose.position.x = "map", math.nan
    feed.node.on_initial_pose(message)
    assert all(
        "An initial pose is ignored: it has to be finite, and in map" in line for line in logged(capsys)
    )
    assert feed.node.map_from_odom @ odometry == found


def test_map_that_grew_too_large_is_reported_once(
    feed: Feed, load_room: Load, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    feed.tour((0.0, 0.0, 0.0))
    monkeypatch.setattr(load_room("occupancy"), "MAX_SIDE_CELLS", 10)
    grid = feed.node.grid
    for name in ("log_odds", "counts", "sums"):  # without a part, which scans would add again
        setattr(grid, name, getattr(grid, name)[:, :-60].copy())
    for step in range(3):
        feed.see(feed.planar.Pose2D(1.0 + 0.2 * step, -0.5))
    assert logged(capsys) == ["The map would be larger than 0 m"]


def test_robot_says_what_it_does_not_obey(
    load_room: Load, feed: Feed, capsys: pytest.CaptureFixture[str]
) -> None:
    node = load_room("robot").Robot()
    message = Twist()
    message.linear.x = math.nan
    node.on_command(message)
    assert logged(capsys) == ["A command is ignored: a speed has to be finite, not nan m/s and 0.0 rad/s"]
    assert node.drive.command == (0.0, 0.0)
    node.destroy_node()


def test_tour_waits_while_another_drives(
    load_room: Load, feed: Feed, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    tour = load_room("tour")
    node = tour.Tour()
    node.send(0.25, 0.5)
    own, other = Twist(), Twist()
    own.linear.x, own.angular.z, other.linear.x = 0.25, 0.5, 0.3
    node.on_command(own)
    assert logged(capsys) == []
    node.on_command(other)
    node.on_command(other)
    assert logged(capsys) == ["Someone else drives: the tour waits"]
    assert node.is_paused(node.get_clock().now())
    monkeypatch.setattr(tour, "OTHERS_S", 0.0)
    assert not node.is_paused(node.get_clock().now())
    assert logged(capsys) == ["The tour goes on"]
    node.destroy_node()


def test_tour_backs_off_where_it_is_stuck(
    load_room: Load, feed: Feed, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    tour, pose = load_room("tour"), feed.planar.Pose2D(2.5, -1.2)
    node = tour.Tour()
    now = node.get_clock().now()
    node.drive(now, pose)
    later = tour.Time(nanoseconds=now.nanoseconds + int(4.1e9), clock_type=now.clock_type)
    before = node.place
    node.drive(later, pose)
    assert logged(capsys) == ["Stuck at 2.50, -1.20: back, and to the next place"]
    assert node.place == before + 1
    assert node.back_until > later
    node.destroy_node()
