"""What an observation holds, from messages made here: each figure, by hand."""

from __future__ import annotations

import math
from collections.abc import Sequence

import pytest
from tests.tf2_tools.recordings import MS, START_NS, recorded, transform

from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.model import Edge
from tfloom.tf2_tools.watch.recorded import RecordedMessage, observe_recorded


def only_edge(*messages: RecordedMessage) -> Edge:
    """Return the one edge of these messages."""
    (edge,) = observe_recorded(messages, "test").edges
    return edge


def moving(
    stamps_ms: Sequence[int], delays_ms: Sequence[int] | None = None, xs: Sequence[float] | None = None
) -> Edge:
    """Return the edge of transforms at these stamps, received later by these delays, at these positions."""
    delays_ms = [0] * len(stamps_ms) if delays_ms is None else delays_ms
    xs = [0.0] * len(stamps_ms) if xs is None else xs
    return only_edge(
        *(
            recorded(
                START_NS + (stamp + delay) * MS,
                transform("odom", "base", START_NS + stamp * MS, (x, 0.0, 0.0)),
            )
            for stamp, delay, x in zip(stamps_ms, delays_ms, xs, strict=True)
        )
    )


def test_periods_delays_and_rate() -> None:
    seen = moving([0, 100, 200, 500], delays_ms=[10, 20, 10, 40])
    statistics = seen.statistics
    assert (statistics.count, statistics.stamp_period.count) == (4, 3)
    assert statistics.stamp_period.mean == pytest.approx(0.5 / 3)
    assert statistics.stamp_period.greatest == pytest.approx(0.3)
    assert statistics.stamp_period.deviation == pytest.approx(
        math.sqrt(2 * (0.2 / 3) ** 2 / 3 + (0.4 / 3) ** 2 / 3)
    )
    assert statistics.receipt_period.least == pytest.approx(0.09)
    assert (statistics.delay.least, statistics.delay.greatest) == pytest.approx((0.01, 0.04))
    assert statistics.delay.mean == pytest.approx(0.02)
    assert seen.rate_hz == pytest.approx(6.0)
    assert (statistics.oldest_stamp_ns, statistics.newest_stamp_ns) == (START_NS, START_NS + 500 * MS)


def test_order_of_stamps() -> None:
    statistics = moving([0, 100, 100, 50, 200, 20_000, 5_000]).statistics
    assert (statistics.repeated, statistics.out_of_order) == (1, 2)
    assert statistics.too_old == 1  # 5 s, where the newest is at 20 s, and the cache holds 10 s
    assert statistics.largest_step_back_ns == 15_000 * MS
    assert statistics.last_stamp_ns == START_NS + 5_000 * MS


def test_stamps_ahead_and_zero() -> None:
    ahead = moving([0, 100], delays_ms=[-30, 10]).statistics
    assert ahead.ahead == 1
    assert ahead.delay.least == pytest.approx(-0.03)
    zero = only_edge(recorded(START_NS, transform("a", "b", 0))).statistics
    assert (zero.zero_stamps, zero.delay.count) == (1, 0)


def test_steps_of_position_and_angle() -> None:
    statistics = moving([0, 100, 200, 210], xs=[0.0, 0.1, 5.1, 5.6]).statistics
    assert statistics.longest.distance == pytest.approx(5.0)
    assert (statistics.longest.elapsed_ns, statistics.longest.stamp_ns) == (100 * MS, START_NS + 200 * MS)
    assert statistics.longest.speed == pytest.approx(50.0)
    assert statistics.fastest.speed == pytest.approx(50.0)
    assert statistics.distance.mean == pytest.approx(5.6 / 3)
    assert statistics.translation == (5.6, 0.0, 0.0)
    quarter = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
    turned = only_edge(
        recorded(START_NS, transform("a", "b", START_NS)),
        recorded(START_NS, transform("a", "b", START_NS + MS, rotation_xyzw=[-value for value in quarter])),
    ).statistics
    assert turned.widest.angle_rad == pytest.approx(math.pi / 2)
    assert turned.rotation_xyzw == tuple(-value for value in quarter)


def test_values_that_are_no_transform() -> None:
    statistics = only_edge(
        recorded(START_NS, transform("a", "b", START_NS, (math.nan, 0.0, 0.0))),
        recorded(START_NS, transform("a", "b", START_NS + MS, (0.0, math.inf, 0.0))),
        recorded(START_NS, transform("a", "b", START_NS + 2 * MS, rotation_xyzw=(0.0, 0.0, 0.0, 1.5))),
    ).statistics
    assert (statistics.count, statistics.non_finite) == (3, 2)
    assert statistics.worst_norm_error == pytest.approx(0.5)


def test_static_transforms_that_change() -> None:
    same = recorded(START_NS, transform("base", "laser", START_NS, (1.0, 0.0, 0.0)), topic="/tf_static")
    other = recorded(START_NS, transform("base", "laser", START_NS, (3.0, 0.0, 0.0)), topic="/tf_static")
    edge = only_edge(same, same, other)
    assert edge.is_static
    assert (edge.statistics.changes, edge.statistics.repeated) == (1, 0)
    assert (edge.statistics.longest.distance, edge.statistics.translation) == (2.0, (3.0, 0.0, 0.0))


def test_parents_and_publishers() -> None:
    seen = observe_recorded(
        [
            recorded(START_NS, transform("odom", "base", START_NS), transform("base", "arm", START_NS)),
            recorded(START_NS + MS, transform("map", "base", START_NS + MS)),
            recorded(START_NS + 2 * MS, transform("odom", "base", START_NS + 2 * MS)),
            recorded(START_NS + 3 * MS, transform("base", "laser", START_NS), topic="/tf_static"),
            ("/tf", START_NS + 4 * MS, b"\x00\x01\x00\x00\xff\xff\xff\xff"),
            ("/scan", START_NS + 9 * MS, b"other"),
        ],
        "drive.mcap",
    )
    assert seen.children["base"].reparented == 2
    assert seen.parents() == {"base": "odom", "arm": "base", "laser": "base"}
    assert [edge.parent for edge in seen.edges_of("base")] == ["map", "odom"]
    moving_publisher, static_publisher = seen.publishers
    assert moving_publisher.name == static_publisher.label == "drive.mcap"
    assert moving_publisher.traffic is not None
    traffic = moving_publisher.traffic
    assert (traffic.messages, traffic.transforms, traffic.unreadable, traffic.max_transforms) == (4, 4, 1, 2)
    assert (static_publisher.topic, static_publisher.is_static) == ("/tf_static", True)
    assert (seen.started_ns, seen.taken_ns) == (START_NS, START_NS + 4 * MS)
    assert seen.frames() == ["arm", "base", "laser", "map", "odom"]


def test_a_buffer_is_filled_too() -> None:
    buffer = Buffer()
    observe_recorded(
        [recorded(START_NS, transform("a", "b", START_NS, (1.0, 2.0, 3.0)))], "test", buffer=buffer
    )
    assert buffer.lookup("a", "b", START_NS).translation == (1.0, 2.0, 3.0)
