"""Which message a display shows while transforms are behind the messages."""

from __future__ import annotations

import math

import pytest

from tfloom.interfaces.sensor_msgs.msg import LaserScan
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2.transform import Transform
from tfloom.viewer.displays.kinds import kind_of
from tfloom.viewer.feed import PATIENCE_NS, Feed
from tfloom.viewer.topic_log import TopicLog

S = 1_000_000_000
STEP_NS = S // 10


@pytest.fixture
def buffer() -> Buffer:
    made = Buffer()
    made.set_log_callback(None)
    return made


class Scanner:
    """A laser that turns by a radian a second, and its display; each range says the number of its scan."""

    def __init__(self, buffer: Buffer) -> None:
        self.buffer = buffer
        self.log = TopicLog(60 * S, lambda data: cdr.decode(LaserScan, data))
        kind = kind_of("/scan", "sensor_msgs/msg/LaserScan")
        assert kind is not None
        self.feed = Feed("/scan", kind, self.log.open())

    def turn(self, number: int) -> None:
        stamp_ns = S + number * STEP_NS
        yaw = Transform.from_rpy(0.0, 0.0, number / 10)
        self.buffer.set("map", "laser", stamp_ns, (0.0, 0.0, 0.0), yaw.rotation_xyzw)

    def scan(self, number: int) -> None:
        message = LaserScan(range_max=1e6, ranges=[1.0 + number])
        message.header.frame_id = "laser"
        message.header.stamp.sec, message.header.stamp.nanosec = divmod(S + number * STEP_NS, S)
        self.log.add(S + number * STEP_NS, cdr.encode(message))

    def shown(self, held_ns: int | None = None) -> tuple[float, float]:
        """Return the number of the scan that is shown, and by how many tenths of a radian it is turned."""
        ((shape, pose),) = self.feed.draw(self.buffer, "map", held_ns, 0)
        assert pose is not None
        yaw_rad = 2.0 * math.atan2(pose[1][2], pose[1][3])
        return float(shape.positions[0, 0]) - 1.0, round(10.0 * yaw_rad, 3)


def test_scan_waits_for_its_transform_and_is_never_turned(buffer: Buffer) -> None:
    scanner = Scanner(buffer)
    scanner.turn(0)
    scanner.scan(0)
    assert scanner.shown() == (0.0, 0.0)
    for number in range(1, 20):
        scanner.scan(number)
        assert scanner.shown() == (number - 1.0, number - 1.0)
        scanner.turn(number)
        assert scanner.shown() == (float(number), float(number))


def test_scans_are_shown_though_each_is_followed_by_another_before_its_transform_comes(
    buffer: Buffer,
) -> None:
    scanner = Scanner(buffer)
    scanner.turn(0)
    for number in range(20):
        scanner.scan(number)
        if number >= 3:
            scanner.turn(number - 3)
        number_shown, turned = scanner.shown()
        if number >= 4:
            assert (number_shown, turned) == (number - 3.0, number - 3.0)


def test_scan_whose_transform_stays_away_is_shown_all_the_same(buffer: Buffer) -> None:
    scanner = Scanner(buffer)
    scanner.turn(0)
    scanner.scan(0)
    assert scanner.shown() == (0.0, 0.0)
    late = PATIENCE_NS // STEP_NS + 1
    for number in range(1, late):
        scanner.scan(number)
        assert scanner.shown() == (0.0, 0.0)
    scanner.scan(late)
    assert scanner.shown() == (float(late), 0.0)
    scanner.turn(late)
    assert scanner.shown() == (float(late), float(late))


def test_scan_stays_where_its_frame_was_at_its_stamp(buffer: Buffer) -> None:
    scanner = Scanner(buffer)
    scanner.turn(0)
    scanner.scan(0)
    for number in range(1, 5):
        scanner.turn(number)
        assert scanner.shown() == (0.0, 0.0)


def test_scan_in_the_fixed_frame_waits_for_nothing(buffer: Buffer) -> None:
    scanner = Scanner(buffer)
    scanner.turn(0)
    for number in range(5):
        scanner.scan(number)
        ((shape, _),) = scanner.feed.draw(buffer, "laser", None, 0)
        assert shape.positions[0, 0] == number + 1.0


def test_time_that_is_held_shows_the_scan_of_then(buffer: Buffer) -> None:
    scanner = Scanner(buffer)
    for number in range(5):
        scanner.turn(number)
        scanner.scan(number)
    scanner.scan(5)
    assert scanner.shown() == (
        5.0,
        4.0,
    )  # the first one that is shown doesn't wait, so that something is there
    assert scanner.shown(S + 2 * STEP_NS) == (2.0, 2.0)
    assert scanner.shown() == (4.0, 4.0)
