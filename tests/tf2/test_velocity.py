"""lookupVelocity as recorded, and the correct twist."""

from __future__ import annotations

import math
from typing import Any

import pytest
from tests.tf2.replay import velocities

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import BackwardExtrapolationException, TransformException
from tfloom.tf2.transform import Transform

SECOND = 1_000_000_000
RUNS = velocities()


@pytest.mark.parametrize("run", RUNS, ids=range(len(RUNS)))
def test_lookup_velocity_is_the_recorded_one(run: dict[str, Any]) -> None:
    buffer = Buffer()
    for frame, child, stamp, xyz, xyzw, *is_static in run["sets"]:
        assert buffer.set(frame, child, stamp, xyz, xyzw, static=bool(is_static))
    assert run["queries"]
    for query in run["queries"]:
        asked = {key: value for key, value in query.items() if key not in ("ok", "raises", "text")}
        if "raises" in query:
            with pytest.raises(TransformException) as raised:
                buffer.lookup_velocity(**asked)
            assert query["raises"] in [kind.__name__ for kind in type(raised.value).__mro__]
            assert str(raised.value) == query["text"]
            continue
        for ours, theirs in zip(buffer.lookup_velocity(**asked), query["ok"], strict=True):
            assert ours == pytest.approx(theirs, rel=1e-7, abs=1e-7)


@pytest.fixture
def circling() -> Buffer:
    """A body on a circle of 2 m at 0.5 rad/s, looking ahead; a sensor 1 m before it."""
    buffer = Buffer(None)
    for step in range(1001):
        angle = 0.5 * step * 0.01
        stamp = 100 * SECOND + step * SECOND // 100
        position = 2 * math.cos(angle), 2 * math.sin(angle), 0.0
        heading = angle + math.pi / 2
        buffer.set("world", "body", stamp, position, (0, 0, math.sin(heading / 2), math.cos(heading / 2)))
    buffer.set("body", "sensor", 0, (1, 0, 0), (0, 0, 0, 1), static=True)
    return buffer


def test_twist_in_the_axes_of_the_fixed_frame_and_of_the_body(circling: Buffer) -> None:
    stamp = 104 * SECOND
    linear, angular = circling.velocity("body", "world", stamp)
    assert linear == pytest.approx((-math.sin(2.0), math.cos(2.0), 0), abs=1e-3)
    assert angular == pytest.approx((0, 0, 0.5), abs=1e-9)
    linear, _ = circling.velocity("body", "world", stamp, axes_frame="body")
    assert linear == pytest.approx((1, 0, 0), abs=1e-3)
    linear, _ = circling.velocity("sensor", "world", stamp, axes_frame="sensor")
    assert linear == pytest.approx((1, 0.5, 0), abs=1e-3)


def test_velocity_at_the_latest_time_and_of_static_frames(circling: Buffer) -> None:
    assert circling.velocity("body", "world").angular == pytest.approx((0, 0, 0.5), abs=1e-9)
    assert circling.velocity("sensor", "body") == ((0, 0, 0), (0, 0, 0))
    with pytest.raises(ValueError, match="interval_ns must be positive"):
        circling.velocity("body", "world", interval_ns=0)


class TestSquares:
    """A frame that moves back and forth along each axis in turn, by 0.1 m or rad each 0.1 s, observed from others."""

    TIMES = (0.5, 1.5, 2.5, 3.5, 4.5, 5.5)
    START = 1000 * SECOND

    def build(
        self, pose: Any, steps: list[tuple[int, float]], above: tuple[float, float, float], count: int
    ) -> Buffer:
        """`steps`: for each second, the index of the number that changes, and its change each 0.1 s."""
        buffer = Buffer(None)
        numbers = [-0.1, 0.0, 0.0]
        seconds = 0.0
        for tenth in range(1, count):
            seconds += 0.1  # as it's added up, the first second ends a tenth late: 0.9999999999999999
            which, change = steps[min(int(seconds), 5)]
            numbers[which] += change
            stamp = self.START + tenth * SECOND // 10
            assert buffer.set("foo", "bar", stamp, *pose(numbers))
            assert buffer.set("foo", "stationary_offset_child", stamp, (1, 0, 0), (0, 0, 0, 1))
            assert buffer.set("stationary_offset_parent", "foo", stamp, above, (0, 0, 0, 1))
        return buffer

    @pytest.fixture
    def sliding(self) -> Buffer:
        steps = [(0, 0.1), (1, 0.1), (0, -0.1), (1, -0.1), (2, 0.1), (2, -0.1)]
        return self.build(lambda numbers: (tuple(numbers), (0, 0, 0, 1)), steps, (0, 0, 1), 61)

    @pytest.fixture
    def turning(self) -> Buffer:
        steps = [(0, 0.1), (0, -0.1), (1, 0.1), (1, -0.1), (2, 0.1), (2, -0.1)]
        return self.build(
            lambda numbers: ((0, 0, 0), Transform.from_rpy(*numbers).rotation_xyzw), steps, (0, 0, -1), 60
        )

    def twists(self, buffer: Buffer, observer: str) -> list[tuple[list[float], list[float]]]:
        found = [
            buffer.lookup_velocity("bar", observer, self.START + round(time * SECOND), 0.1)
            for time in self.TIMES
        ]
        return [([round(v, 6) for v in linear], [round(w, 6) for w in angular]) for linear, angular in found]

    @pytest.mark.parametrize("observer", ["foo", "stationary_offset_child", "stationary_offset_parent"])
    def test_linear_velocity_is_measured(self, sliding: Buffer, observer: str) -> None:
        assert self.twists(sliding, observer) == [
            ([1, 0, 0], [0, 0, 0]), ([0, 1, 0], [0, 0, 0]), ([-1, 0, 0], [0, 0, 0]),
            ([0, -1, 0], [0, 0, 0]), ([0, 0, 1], [0, 0, 0]), ([0, 0, -1], [0, 0, 0]),
        ]  # fmt: skip

    @pytest.mark.parametrize(
        ("observer", "linear"),
        [
            ("foo", [[0, 0, 0]] * 6),
            (
                "stationary_offset_child",
                [[0, 0, 0], [0, 0, 0], [0, 0, -1], [0, 0, 1], [0, 1, 0], [0, -1, 0]],
            ),
            (
                "stationary_offset_parent",
                [[0, -1, 0], [0, 1, 0], [1, 0, 0], [-1, 0, 0], [0, 0, 0], [0, 0, 0]],
            ),
        ],
    )
    def test_angular_velocity_is_measured(
        self, turning: Buffer, observer: str, linear: list[list[int]]
    ) -> None:
        angular = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
        assert self.twists(turning, observer) == list(zip(linear, angular, strict=True))

    def test_twist_is_equal_in_all_frames_at_rest(self, sliding: Buffer, turning: Buffer) -> None:
        for buffer in (sliding, turning):
            for time in self.TIMES:
                at = self.START + round(time * SECOND)
                first, *others = (
                    buffer.velocity("bar", observer, at)
                    for observer in ("foo", "stationary_offset_child", "stationary_offset_parent")
                )
                for other in others:
                    assert other.linear == pytest.approx(first.linear, abs=1e-9)
                    assert other.angular == pytest.approx(first.angular, abs=1e-9)


def test_velocity_between_two_samples() -> None:
    now = 100 * SECOND
    buffer = Buffer()
    for second, x in ((-1, 0.0), (0, 1.0), (1, 2.0)):
        buffer.set("bar", "foo", now + second * SECOND, (x, 0, 0), (0, 0, 0, 1))
    assert buffer.lookup_velocity("foo", "bar", now, 0.1).linear == pytest.approx((1, 0, 0))
    for second in range(6):
        buffer.set("parent", "frame", now + second * SECOND, (0.3 * second, 0, 0), (0, 0, 0, 1))
    assert buffer.lookup_velocity("frame", "parent", now + 3 * SECOND, 0.1).linear == pytest.approx(
        (0.3, 0, 0)
    )


def test_the_latest_velocity_by_the_reference_formula_starts_at_the_epoch(circling: Buffer) -> None:
    with pytest.raises(BackwardExtrapolationException, match=r"Requested time 0\.000010"):
        circling.lookup_velocity("body", "world", 0, 0.1)


def test_all_recorded_cases_are_replayed() -> None:
    assert (len(RUNS), sum(len(run["queries"]) for run in RUNS)) == (6, 480)
