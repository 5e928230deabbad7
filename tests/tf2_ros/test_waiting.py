"""Waits for transforms, which end as soon as they can't succeed, also across jumps of simulated time."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

import pytest
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.duration import Duration, Infinite
from tfloom.node.values.time import Time
from tfloom.tf2 import errors
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_ros.transform_listener import TransformListener

LONG = Duration(seconds=60)
NOW = Time()
SetTime = Callable[[float], None]


@pytest.fixture
def buffer() -> Buffer:
    buffer = Buffer()
    buffer.set_transform(transform_stamped("map", "base", 100 * SECOND), "me")
    return buffer


HOPELESS = [
    (("map", "base", Time(seconds=1)), errors.NoDataForExtrapolationException),  # older than the cache keeps
    (("map", "/base", NOW), errors.InvalidArgumentException),
    (("", "base", NOW), errors.InvalidArgumentException),
]


@pytest.mark.parametrize(("query", "kind"), HOPELESS)
def test_impossible_lookup_raises_at_once(buffer: Buffer, query: tuple, kind: type[Exception]) -> None:
    target, source, at = query
    full = target, at, source, at, "map"
    start = time.monotonic()
    for look_up, arguments in ((buffer.lookup_transform, query), (buffer.lookup_transform_full, full)):
        with pytest.raises(kind):
            look_up(*arguments, LONG)
    assert not buffer.can_transform(*query, LONG)
    assert not buffer.can_transform_full(*full, LONG)
    for future in (
        buffer.wait_for_transform_async(*query, timeout=LONG),
        buffer.wait_for_transform_full_async(*full, timeout=LONG),
    ):
        assert isinstance(future.exception(), kind)
    assert time.monotonic() - start < 30


def test_impossible_lookup_is_checked_once(buffer: Buffer, monkeypatch: pytest.MonkeyPatch) -> None:
    looks: list[float] = []

    def wait(*query: object, timeout_s: float) -> bool:
        looks.append(timeout_s)
        return super(Buffer, buffer).wait(*query, timeout_s=timeout_s)

    monkeypatch.setattr(buffer, "wait", wait)
    assert not buffer.can_transform("map", "base", Time(seconds=1), Infinite)
    assert len(looks) <= 2  # two, if the machine stalls during the first


def test_future_can_wait_without_limit(
    buffer: Buffer, wait_until: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    broken: list[object] = []
    monkeypatch.setattr(threading, "excepthook", broken.append)
    endless = buffer.wait_for_transform_async("map", "arm", NOW, timeout=Infinite)
    short = buffer.wait_for_transform_async("map", "leg", NOW, timeout=Duration(seconds=0.05))
    wait_until(short.done)
    again = buffer.wait_for_transform_async("map", "leg", NOW, timeout=Duration(seconds=0.05))
    wait_until(again.done)
    buffer.set_transform(transform_stamped("map", "arm", 100 * SECOND), "me")
    assert endless.done()
    assert endless.exception() is None
    assert broken == []


def test_lookup_wakes_with_the_transform_from_the_wire(node: Node, broadcaster: TransformBroadcaster) -> None:
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    delays = []
    for attempt in range(10):
        woken: list[float] = []

        def look_up(child: str = f"child{attempt}", woken: list[float] = woken) -> None:
            buffer.lookup_transform("map", child, NOW, LONG)
            woken.append(time.perf_counter())

        thread = threading.Thread(target=look_up)
        thread.start()
        time.sleep(0.01)  # let it begin to wait; the result is the same if it has not
        sent = time.perf_counter()
        broadcaster.sendTransform(transform_stamped("map", f"child{attempt}", SECOND))
        thread.join(30)
        delays.append(woken[0] - sent)
    assert min(delays) < 0.005  # polling would find it after 10 ms on average
    listener.unregister()


@pytest.mark.parametrize("kind", [SingleThreadedExecutor, MultiThreadedExecutor])
def test_awaiting_callback_continues_with_the_transform(
    node: Node, kind: type[Executor], broadcaster: TransformBroadcaster
) -> None:
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    told: list[str] = []

    async def look_up() -> None:
        if told:
            return
        told.append("asked")
        transform = await buffer.lookup_transform_async("map", "late", NOW, LONG)
        told.append(transform.child_frame_id)
        with pytest.raises(errors.LookupException, match="timed out"):
            await buffer.lookup_transform_async("map", "never", NOW, Duration(seconds=0.02))
        told.append("timed out")

    node.create_timer(0.001, look_up)
    executor = kind(context=node.context)
    executor.add_node(node)
    end = time.monotonic() + 30
    while "timed out" not in told and time.monotonic() < end:
        executor.spin_once(timeout_sec=1)
        if told == ["asked"]:
            broadcaster.sendTransform(transform_stamped("map", "late", SECOND))
    assert told == ["asked", "late", "timed out"]
    executor.shutdown()
    listener.unregister()


@pytest.mark.parametrize("timeout", [0.5, None, "1 s"])
def test_a_timeout_is_a_duration(buffer: Buffer, timeout: object) -> None:
    with pytest.raises(TypeError, match="duration must have sec and nanosec, or nanoseconds"):
        buffer.lookup_transform("map", "base", NOW, timeout)
    with pytest.raises(TypeError, match="time must have sec and nanosec, or nanoseconds"):
        buffer.lookup_transform("map", "base", 0.5)


@pytest.mark.parametrize("duration", [Duration(), Duration(seconds=-1), Duration(nanoseconds=1)])
def test_timeout_of_zero_does_not_wait(buffer: Buffer, duration: Duration) -> None:
    assert buffer.can_transform("map", "base", NOW, duration)
    assert not buffer.can_transform("map", "other", NOW, duration)


def test_a_chain_of_static_transforms_and_a_moving_one_below() -> None:
    buffer = Buffer()
    buffer.set_transform_static(transform_stamped("a", "b", SECOND), "me")
    buffer.set_transform_static(transform_stamped("b", "c", SECOND), "me")
    assert all(buffer.can_transform("a", "c", Time(seconds=at)) for at in (0, 100, 1000))
    buffer.set_transform(transform_stamped("c", "d", 10 * SECOND), "me")
    known = [bool(buffer.can_transform("a", "d", Time(seconds=at))) for at in (0, 10, 1, 1000)]
    assert known == [True, True, False, False]


class TestSimulatedTime:
    @pytest.fixture(autouse=True)
    def at_100_s(self, set_time: SetTime) -> None:
        set_time(100)

    def test_wait_continues_across_a_jump_backward(self, node: Node, set_time: SetTime) -> None:
        buffer = Buffer(node=node)
        buffer.set_transform(transform_stamped("map", "base", 100 * SECOND), "me")
        found: list[object] = []
        thread = threading.Thread(
            target=lambda: found.append(buffer.lookup_transform("map", "base", Time(seconds=11), LONG))
        )
        # At 11 s it is too old; after the jump it is in the future.
        set_time(10)
        thread.start()
        for at in (10, 12):
            buffer.set_transform(transform_stamped("map", "base", at * SECOND), "me")
        thread.join(30)
        assert found[0].header.stamp.sec == 11

    def test_buffer_uses_the_clock_of_its_node(self, node: Node) -> None:
        assert Buffer(node=node).clock is node.get_clock()
        assert Buffer().clock.now().nanoseconds > 0

    def test_jump_is_logged_once(
        self, node: Node, set_time: SetTime, capfd: pytest.CaptureFixture[str]
    ) -> None:
        buffer = Buffer(node=node)
        TransformListener(buffer, node)
        other = TransformListener(buffer, node)
        other.buffer = buffer
        capfd.readouterr()
        set_time(10)
        lines = [line for line in capfd.readouterr().err.splitlines() if "tf2_buffer" in line]
        assert [line.partition("]: ")[2] for line in lines] == [
            "Detected jump back in time. Clearing tf buffer."
        ]

    def test_forward_and_small_jumps_change_nothing(self, node: Node, set_time: SetTime) -> None:
        buffer = Buffer(node=node)
        buffer.set_transform(transform_stamped("map", "base", 100 * SECOND), "me")
        for seconds in (99.5, 98.6, 1000, 999.1):
            set_time(seconds)
        assert buffer.can_transform("map", "base", NOW)

    def test_static_transforms_survive_a_jump(self, node: Node, set_time: SetTime) -> None:
        buffer = Buffer()
        TransformListener(buffer, node)
        static = StaticTransformBroadcaster(node)
        static.sendTransform(transform_stamped("base", "laser", 100 * SECOND))
        set_time(10)
        assert buffer.can_transform("base", "laser", NOW)
        static.sendTransform(transform_stamped("base", "camera", 100 * SECOND))
        assert buffer.can_transform("base", "camera", NOW)

    def test_stragglers_are_ignored_for_a_short_time_only(
        self, node: Node, set_time: SetTime, broadcaster: TransformBroadcaster
    ) -> None:
        buffer = Buffer()
        TransformListener(buffer, node)
        set_time(99.99)
        jumped = time.monotonic()
        set_time(98.5)  # 1.49 s back: transforms from 99.245 s on are stragglers, for 0.745 s
        broadcaster.sendTransform(transform_stamped("map", "base", 100 * SECOND))
        is_known = buffer.can_transform("map", "base", NOW)
        assert not is_known or time.monotonic() - jumped > 0.7
        end = time.monotonic() + 30
        while not buffer.can_transform("map", "base", NOW) and time.monotonic() < end:
            broadcaster.sendTransform(transform_stamped("map", "base", 100 * SECOND))
            time.sleep(0.02)
        assert buffer.lookup_transform("map", "base", NOW).header.stamp.sec == 100


def test_log_of_a_flood_of_old_data_has_the_count(
    capfd: pytest.CaptureFixture[str],
) -> None:
    buffer = Buffer()
    buffer.set_transform(transform_stamped("map", "base", 100 * SECOND), "me")
    old = transform_stamped("map", "base", SECOND)
    for _ in range(500):
        buffer.set_transform(old, "me")
    printed, end = "", time.monotonic() + 30
    while "held back" not in printed and time.monotonic() < end:
        time.sleep(0.02)
        buffer.set_transform(old, "me")
        printed += capfd.readouterr().err
    assert (
        "TF_OLD_DATA ignoring data from the past for frame base at time 1.000000 according to authority me"
        in printed
    )
    held_back = int(printed.partition(" more like this were held back")[0].rpartition("(")[2])
    assert held_back >= 499
