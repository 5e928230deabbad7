"""Synchronization of messages: each is passed on once, with its matches."""

from __future__ import annotations

import random
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.std_msgs.msg import Header, String
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.clock_type import ClockType
from tfloom.node.values.time import Time
from tfloom.tf2_ros.filters.message_filters import (
    ApproximateTimeSynchronizer,
    Cache,
    Chain,
    SimpleFilter,
    Subscriber,
    TimeSynchronizer,
)


def point(seconds: float) -> PointStamped:
    return PointStamped(header=Header(stamp=Time(seconds=seconds).to_msg()))


def seconds(message: PointStamped) -> float:
    return message.header.stamp.sec + message.header.stamp.nanosec / 1e9


def synchronized(
    kind: Any, *arguments: object, count: int = 2
) -> tuple[list[SimpleFilter], list[tuple[float, ...]]]:
    """Return sources, and the list of what a synchronizer of them passes on, by the messages' seconds."""
    sources = [SimpleFilter() for _ in range(count)]
    passed_on: list[tuple[float, ...]] = []
    kind(sources, *arguments).registerCallback(
        lambda *messages: passed_on.append(tuple(map(seconds, messages)))
    )
    return sources, passed_on


def test_cache_keeps_the_last_messages_in_order() -> None:
    source = SimpleFilter()
    cache = Cache(source, 3)
    assert (cache.getLast(), cache.getOldestTime(), cache.getLastestTime()) == (None, None, None)
    for at in (1, 4, 2, 3):
        source.signalMessage(point(at))
    assert [seconds(message) for message in cache.cache_msgs] == [2, 3, 4]
    assert [seconds(m) for m in cache.getInterval(Time(seconds=2), Time(seconds=3))] == [2, 3]
    assert seconds(cache.getElemAfterTime(Time(seconds=2.5))) == 3
    assert seconds(cache.getElemBeforeTime(Time(seconds=2.5))) == 2
    assert cache.getElemAfterTime(Time(seconds=9)) is None
    assert cache.getElemBeforeTime(Time(seconds=1)) is None
    assert (seconds(cache.getLast()), cache.getLastestTime().nanoseconds) == (4, 4_000_000_000)


def test_messages_of_equal_stamps_are_passed_on_together() -> None:
    left, right = SimpleFilter(), SimpleFilter()
    synchronizer = TimeSynchronizer([left, right], 3)
    pairs: list[tuple[float, float, str]] = []
    synchronizer.registerCallback(lambda a, b, tag: pairs.append((seconds(a), seconds(b), tag)), "tag")
    for at in range(5):
        left.signalMessage(point(at))
    for at in range(5):
        right.signalMessage(point(at))
    assert pairs == [
        (2, 2, "tag"),
        (3, 3, "tag"),
        (4, 4, "tag"),
    ]  # the queue was full of newer ones than the first two


def test_times_of_a_cache_are_comparable_with_those_of_a_node(node: Node) -> None:
    cache = Cache(SimpleFilter())
    cache.add(point(7))
    assert cache.getLastestTime() == Time(seconds=7, clock_type=ClockType.ROS_TIME)
    assert (node.get_clock().now() - cache.getOldestTime()).nanoseconds > 0


def test_stamp_can_be_an_rclpy_time_and_messages_of_any_class() -> None:
    left, right = SimpleFilter(), SimpleFilter()
    pairs: list[tuple[object, object]] = []
    for synchronizer in (
        TimeSynchronizer([left, right], 3),
        ApproximateTimeSynchronizer([left, right], 3, 0.1),
    ):
        synchronizer.registerCallback(lambda *pair: pairs.append(pair))
    cache = Cache(left)
    one = SimpleNamespace(header=SimpleNamespace(stamp=Time(seconds=3)))
    other = SimpleNamespace(header=SimpleNamespace(stamp=SimpleNamespace(sec=3, nanosec=0)))
    left.signalMessage(one)
    right.signalMessage(other)
    assert pairs == [(one, other)] * 2
    assert cache.getLastestTime() is one.header.stamp


def test_callbacks_can_be_unregistered() -> None:
    source = SimpleFilter()
    got: list[str] = []
    first = source.registerCallback(lambda _: got.append("first"))
    second = source.registerCallback(lambda _: got.append("second"))
    source.unregisterCallback(first)
    assert source.registerCallback(lambda _: got.append("third")) not in (first, second)
    source.signalMessage(point(1))
    assert got == ["second", "third"]


def test_chain_passes_messages_through_its_filters() -> None:
    source, chain = SimpleFilter(), Chain()
    got: list[float] = []
    chain.registerCallback(lambda message: got.append(seconds(message)))
    chain.connectInput(source)
    with pytest.raises(RuntimeError, match="Already connected"):
        chain.connectInput(source)
    source.signalMessage(point(1))
    first, second = Cache(None, 5), Cache(None, 5)
    for number, input_filter in enumerate((first, second)):
        chain.addFilter(input_filter)
        assert chain.getFilter(number) is input_filter
        source.signalMessage(point(2 + number))
    assert got == [1, 2, 3]
    assert [len(cache.cache_msgs) for cache in (first, second)] == [2, 1]
    with pytest.raises(KeyError):
        chain.getFilter(2)
    Chain(source).registerCallback(lambda message: got.append(-seconds(message)))
    source.signalMessage(point(4))
    assert got == [1, 2, 3, 4, -4]


@pytest.mark.parametrize("count", [1, 2, 5, 9])
def test_scrambled_sequences_are_synchronized(count: int) -> None:
    sources, pairs = synchronized(ApproximateTimeSynchronizer, count, 0.1)
    shuffler = random.Random(count)
    for source in sources:
        for at in shuffler.sample(range(count), count):
            source.signalMessage(point(at))
    assert sorted(pairs) == [(at, at) for at in range(count)]


def test_a_message_older_than_a_full_queue_is_dropped() -> None:
    left, right = SimpleFilter(), SimpleFilter()
    pairs: list[tuple[float, float]] = []
    synchronizer = ApproximateTimeSynchronizer([left, right], 1, 0.1)
    synchronizer.registerCallback(lambda a, b: pairs.append((seconds(a), seconds(b))))
    right.signalMessage(point(1))
    left.signalMessage(point(5))
    left.signalMessage(point(1))
    assert pairs == []
    assert [len(queue) for queue in synchronizer.queues] == [1, 1]


def test_stamps_that_differ_by_the_slop_do_not_match() -> None:
    (left, right), pairs = synchronized(ApproximateTimeSynchronizer, 5, 0.5)
    left.signalMessage(point(1))
    right.signalMessage(point(1.5))
    assert pairs == []
    right.signalMessage(point(1.499999999))
    assert len(pairs) == 1


def test_messages_without_a_header_are_stamped_with_simulated_time(
    node: Node, set_time: Callable[[float], None]
) -> None:
    set_time(50)
    points, words = Subscriber(node, PointStamped, "points"), Subscriber(node, String, "words")
    pairs: list[str] = []
    ApproximateTimeSynchronizer([points, words], 5, 0.5, allow_headerless=True).registerCallback(
        lambda message, word: pairs.append(f"{seconds(message)} {word.data}")
    )
    cache = Cache(words, allow_headerless=True)
    points.signalMessage(point(50.2))
    words.signalMessage(String(data="now"))
    assert pairs == ["50.2 now"]
    assert cache.getLastestTime() == Time(seconds=50, clock_type=ClockType.ROS_TIME)


@pytest.mark.parametrize("slop", [0.05, 0.2])
def test_near_stamps_match(slop: float) -> None:
    (left, right, third), sets = synchronized(ApproximateTimeSynchronizer, 10, slop, count=3)
    for at in (1.0, 2.0, 3.0):
        left.signalMessage(point(at))
        right.signalMessage(point(at + 0.04))
        third.signalMessage(point(at + 0.1))
    assert sets == ([] if slop < 0.1 else [(1.0, 1.04, 1.1), (2.0, 2.04, 2.1), (3.0, 3.04, 3.1)])


def test_nearest_message_is_used_and_only_once() -> None:
    (left, right), pairs = synchronized(ApproximateTimeSynchronizer, 10, 0.5)
    for at in (1.0, 1.3, 1.45):
        left.signalMessage(point(at))
    right.signalMessage(point(1.4))
    right.signalMessage(point(1.4))
    assert pairs == [(1.45, 1.4), (1.3, 1.4)]


def test_messages_without_a_header_are_dropped_or_stamped(capfd: pytest.CaptureFixture[str]) -> None:
    source = SimpleFilter()
    cache = Cache(source)
    source.signalMessage(String(data="x"))
    assert cache.getLast() is None
    assert "dropped a String without a header" in capfd.readouterr().err
    Cache(source, allow_headerless=True)
    timed = Cache(source, allow_headerless=True)
    source.signalMessage(String(data="y"))
    assert timed.getLast().data == "y"


def test_subscriber_passes_messages_on(node: Node, executor: SingleThreadedExecutor) -> None:
    subscriber = Subscriber(node, PointStamped, "points")
    got: list[float] = []
    subscriber.registerCallback(lambda message: got.append(seconds(message)))
    assert (subscriber.getTopic(), subscriber.topic_name) == ("points", "/points")
    node.create_publisher(PointStamped, "points", 10).publish(point(7))
    executor.spin_once(timeout_sec=30)
    assert got == [7]
