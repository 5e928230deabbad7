"""Transforms stamped in the far future, which a listener holds until their publisher confirms them."""

from __future__ import annotations

import gc
import time
import weakref
from collections.abc import Callable

import pytest
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.log import logging
from tfloom.node.node import Node
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer as CoreBuffer
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_ros.transform_listener import TransformListener

POISON = 2147483647 * SECOND
HISTORY = 10 * SECOND
NEWEST = Time()
NOW = 1_000_000 * SECOND
ONE, OTHER = bytes([1] * 16), bytes([2] * 16)


class Listening:
    """A sink as a listener has it, with a clock that the test sets."""

    def __init__(self, cache_time_ns: int = HISTORY) -> None:
        self.buffer = CoreBuffer(cache_time_ns)
        self.reports: list[tuple[object, ...]] = []
        self.sink = self.buffer.tf_sink("me", static=False, on_held=lambda *held: self.reports.append(held))

    def push(self, *transforms: tuple[str, int], now: int = NOW, gid: bytes = ONE) -> None:
        """Receive one message of `gid` at `now`: child frames of map, each with its stamp [ns]."""
        message = TFMessage(
            transforms=[transform_stamped("map", child, stamp) for child, stamp in transforms]
        )
        self.sink.push(cdr.encode(message), now, now, gid)

    def newest(self, child: str) -> int | None:
        """Return the newest stamp of a frame; None: it has none."""
        if not self.buffer.can("map", child, 0):
            return None
        return self.buffer.lookup("map", child, 0).stamp_ns


@pytest.fixture
def listening() -> Listening:
    return Listening()


def test_one_poisoned_stamp_is_never_stored(listening: Listening) -> None:
    for turn in range(5):
        now = NOW + turn * SECOND
        listening.push(("base", now), now=now)
        assert listening.sink.held_count == 0
        listening.push(("base", POISON + turn), now=now)
        assert listening.newest("base") == now
        assert listening.sink.held_count == 1
    assert listening.reports == [(list(ONE), "base", POISON, NOW)]


def test_other_transforms_of_the_message_are_stored(listening: Listening) -> None:
    listening.push(("base", NOW), ("arm", POISON), ("hand", NOW - SECOND))
    assert listening.newest("base") == NOW
    assert listening.newest("hand") == NOW - SECOND
    assert listening.newest("arm") is None


@pytest.mark.parametrize("period_s", [0.02, 1.0, 60.0])
def test_clock_that_is_ahead_is_confirmed_by_the_next_message(listening: Listening, period_s: float) -> None:
    lead = 3600 * SECOND
    for turn in range(4):
        now = NOW + int(turn * period_s * SECOND)
        listening.push(("base", now + lead), now=now)
        assert listening.newest("base") == (None if turn == 0 else now + lead)
    assert len(listening.reports) == 1
    assert listening.sink.held_count == 0


def test_held_transforms_are_stored_before_what_confirms_them(listening: Listening) -> None:
    lead = 3600 * SECOND
    listening.push(("base", NOW + lead), ("arm", NOW + lead))
    assert listening.sink.held_count == 2
    listening.push(("base", NOW + lead + SECOND), now=NOW + SECOND)
    assert listening.buffer.lookup("map", "base", NOW + lead + SECOND // 2).translation == (1.0, 2.0, 3.0)
    assert listening.newest("arm") == NOW + lead


def test_frames_sent_one_by_one_with_a_clock_ahead(listening: Listening) -> None:
    lead = 3600 * SECOND
    for turn in range(3):
        now = NOW + turn * SECOND
        listening.push(("base", now + lead), now=now)
        listening.push(("arm", now + lead), now=now)
        listening.push(("world", now), now=now)
    assert [listening.newest(child) for child in ("base", "arm")] == [NOW + lead + 2 * SECOND] * 2
    assert listening.newest("world") == NOW + 2 * SECOND


def test_one_message_confirms_neither_itself_nor_that_of_another_publisher(listening: Listening) -> None:
    listening.push(("base", POISON), ("arm", POISON - SECOND))
    listening.push(("base", POISON + 1), gid=OTHER)
    assert listening.newest("base") is None
    assert listening.sink.held_count == 3
    assert [report[0] for report in listening.reports] == [list(ONE), list(OTHER)]


def test_constant_stamp_confirms_nothing(listening: Listening) -> None:
    for turn in range(100):
        listening.push(("base", POISON), now=NOW + turn * SECOND)
    assert listening.newest("base") is None
    assert listening.sink.held_count == 1


@pytest.mark.parametrize("lead", [-1, 0, HISTORY // 2, HISTORY])
def test_stamp_within_the_history_ahead_is_stored_at_once(listening: Listening, lead: int) -> None:
    listening.push(("base", NOW + lead))
    assert listening.newest("base") == NOW + lead
    assert listening.reports == []


def test_stamp_near_the_former_one_is_stored_at_once(listening: Listening) -> None:
    for step in range(5):
        listening.push(("base", NOW + step * HISTORY))
        assert listening.newest("base") == NOW + step * HISTORY


def test_reach_is_that_of_the_buffer() -> None:
    long = Listening(cache_time_ns=100 * SECOND)
    long.push(("base", NOW + 99 * SECOND))
    assert long.newest("base") == NOW + 99 * SECOND
    none = Listening(cache_time_ns=0)  # then a second
    none.push(("base", NOW + SECOND))
    assert none.newest("base") == NOW + SECOND
    none.push(("arm", NOW + 3 * SECOND))
    assert none.newest("arm") is None


def test_static_transforms_are_not_concerned() -> None:
    buffer = CoreBuffer()
    sink = buffer.tf_sink("me", static=True, on_held=lambda *_: pytest.fail("held"))
    message = TFMessage(transforms=[transform_stamped("map", "base", POISON)])
    sink.push(cdr.encode(message), NOW, NOW, ONE)
    assert buffer.can("map", "base", 0)


def test_sink_of_a_plain_buffer_holds_nothing() -> None:
    buffer = CoreBuffer()
    message = TFMessage(transforms=[transform_stamped("map", "base", POISON)])
    buffer.tf_sink("me", static=False).push(cdr.encode(message), NOW, NOW, ONE)
    assert buffer.lookup("map", "base", 0).stamp_ns == POISON


def test_simulated_time_takes_the_place_of_the_systems(listening: Listening) -> None:
    listening.sink.set_simulated_time(0)
    listening.push(("base", 50 * SECOND))  # before the first /clock
    assert listening.newest("base") == 50 * SECOND
    listening.sink.set_simulated_time(50 * SECOND)
    listening.push(("arm", NOW))
    assert listening.newest("arm") is None
    listening.sink.set_simulated_time(None)
    listening.push(("hand", NOW))
    assert listening.newest("hand") == NOW


def test_jump_in_time_drops_what_is_held(listening: Listening) -> None:
    lead = 3600 * SECOND
    listening.push(("base", NOW + lead))
    listening.sink.forget_all()
    assert listening.sink.publisher_count == listening.sink.held_count == 0
    listening.push(("base", NOW + lead + SECOND), now=NOW + SECOND)
    assert listening.newest("base") is None


def test_memory_is_bounded_by_publisher(listening: Listening) -> None:
    for number in range(2000):
        listening.push((f"f{number}", POISON - number), gid=number.to_bytes(16, "big"))
        listening.push((f"f{number}", POISON - SECOND - number), ("x" * 1000, POISON - number))
    assert listening.sink.publisher_count <= 256
    assert listening.sink.held_count <= 256 * 128
    listening.sink.forget_all()
    for number in range(1000):
        listening.push((f"f{number}", POISON - number))
    assert listening.sink.held_count <= 128
    listening.sink.forget(ONE)
    assert listening.sink.publisher_count == 0


@pytest.mark.parametrize("now", [-(2**63), 2**63 - 1, -1, 1])
@pytest.mark.parametrize("stamp", [POISON, -(2**31) * SECOND, 0])
def test_extreme_times_overflow_nowhere(listening: Listening, now: int, stamp: int) -> None:
    for gid in (ONE, ONE, OTHER):
        listening.push(("base", stamp), ("arm", POISON), now=now, gid=gid)
    assert listening.sink.message_count == 3


class Warnings:
    """The warnings of all loggers."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.texts: list[str] = []
        monkeypatch.setattr(
            logging.RcutilsLogger, "warning", lambda _, text, **__: self.texts.append(text) or True
        )


def now_ns() -> int:
    return time.time_ns()


def test_listener_names_the_publisher_once(
    make_node: Callable[..., Node], wait_until: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    warnings = Warnings(monkeypatch)
    node, robot = make_node("listening"), make_node("robot", namespace="/fleet")
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    broadcaster = TransformBroadcaster(robot)
    for _ in range(3):
        broadcaster.sendTransform(transform_stamped("map", "base", POISON))
        broadcaster.sendTransform(transform_stamped("map", "base", now_ns()))
    assert abs(buffer.lookup_transform("map", "base", NEWEST).header.stamp.sec - now_ns() // SECOND) < 60
    wait_until(lambda: warnings.texts)
    (text,) = warnings.texts
    gid = ".".join(f"{byte:02x}" for byte in node.get_publishers_info_by_topic("/tf")[0].endpoint_gid)
    assert text.startswith(f"The transform of 'base' from /fleet/robot, GID {gid}, on /tf is stamped ")
    assert "(at 2147483647.000)" in text
    listener.unregister()


def test_listener_goes_on_with_a_robot_whose_clock_is_ahead(
    buffer: Buffer, broadcaster: TransformBroadcaster
) -> None:
    ahead = now_ns() + 86_400 * SECOND
    for step in range(3):
        broadcaster.sendTransform(transform_stamped("map", "base", ahead + step * SECOND))
    stamp = buffer.lookup_transform("map", "base", NEWEST).header.stamp
    assert stamp.sec * SECOND + stamp.nanosec == ahead + 2 * SECOND
    assert buffer.can_transform("map", "base", Time(nanoseconds=ahead))


def test_static_poison_is_stored(node: Node, buffer: Buffer) -> None:
    StaticTransformBroadcaster(node).sendTransform(transform_stamped("map", "base", POISON))
    assert buffer.can_transform("map", "base", NEWEST)


def test_listener_compares_with_simulated_time(
    node: Node, broadcaster: TransformBroadcaster, set_time: Callable[[float], None]
) -> None:
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    set_time(100)
    broadcaster.sendTransform(transform_stamped("map", "base", 100 * SECOND))
    broadcaster.sendTransform(transform_stamped("map", "base", now_ns()))
    assert buffer.lookup_transform("map", "base", NEWEST).header.stamp.sec == 100
    set_time(5000)
    broadcaster.sendTransform(transform_stamped("map", "base", 5000 * SECOND))
    assert buffer.lookup_transform("map", "base", NEWEST).header.stamp.sec == 5000
    assert listener._sink.held_count == 0
    broadcaster.sendTransform(transform_stamped("map", "base", now_ns()))
    assert listener._sink.held_count == 1
    set_time(50)  # back
    assert listener._sink.held_count == listener._sink.publisher_count == 0


def test_publisher_that_leaves_is_forgotten(make_node: Callable[..., Node]) -> None:
    node, robot = make_node("listening"), make_node("robot")
    listener = TransformListener(Buffer(), node)
    broadcaster = TransformBroadcaster(robot)
    broadcaster.sendTransform(transform_stamped("map", "base", POISON))
    assert listener._sink.publisher_count == listener._sink.held_count == 1
    robot.destroy_publisher(broadcaster.pub_tf)
    assert listener._sink.publisher_count == listener._sink.held_count == 0


def test_on_held_that_refers_to_its_sink_is_collected() -> None:
    class Owner:
        def __init__(self) -> None:
            self.sink = CoreBuffer().tf_sink("me", static=False, on_held=self.held)

        def held(self, *_: object) -> None:
            pass

    owner = weakref.ref(Owner())
    gc.collect()
    assert owner() is None


def test_listener_without_a_reference_but_its_nodes_is_freed_with_it(node: Node) -> None:
    listener = TransformListener(Buffer(cache_time=Duration(seconds=10)), node)
    handles = len(node.get_clock().jump_handles())
    listener.unregister()
    assert len(node.get_clock().jump_handles()) == handles - 1
