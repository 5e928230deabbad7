"""Messages that belong together come together, each once."""

from __future__ import annotations

import pytest

from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.std_msgs.msg import Header, String
from tfloom.node.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.time import Time
from tfloom.tf2_ros.message_filters import (
    ApproximateTimeSynchronizer,
    Cache,
    SimpleFilter,
    Subscriber,
    TimeSynchronizer,
)


def point(seconds: float) -> PointStamped:
    return PointStamped(header=Header(stamp=Time(seconds=seconds).to_msg()))


def seconds(message: PointStamped) -> float:
    return message.header.stamp.sec + message.header.stamp.nanosec / 1e9


def test_a_cache() -> None:
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


def test_the_same_stamp() -> None:
    left, right = SimpleFilter(), SimpleFilter()
    synchronizer = TimeSynchronizer([left, right], 3)
    pairs: list[tuple[float, float, str]] = []
    synchronizer.registerCallback(lambda a, b, tag: pairs.append((seconds(a), seconds(b), tag)), "tag")
    for at in range(5):
        left.signalMessage(point(at))
    for at in range(5):
        right.signalMessage(point(at))
    assert pairs == [(2, 2, "tag"), (3, 3, "tag"), (4, 4, "tag")]  # the first two no longer fitted


@pytest.mark.parametrize("slop", [0.05, 0.2])
def test_stamps_that_are_near(slop: float) -> None:
    left, right, third = SimpleFilter(), SimpleFilter(), SimpleFilter()
    sets: list[list[float]] = []
    ApproximateTimeSynchronizer([left, right, third], 10, slop).registerCallback(
        lambda *messages: sets.append([seconds(message) for message in messages])
    )
    for at in (1.0, 2.0, 3.0):
        left.signalMessage(point(at))
        right.signalMessage(point(at + 0.04))
        third.signalMessage(point(at + 0.1))
    assert sets == ([] if slop < 0.1 else [[1.0, 1.04, 1.1], [2.0, 2.04, 2.1], [3.0, 3.04, 3.1]])


def test_the_nearest_is_taken_and_only_once() -> None:
    left, right = SimpleFilter(), SimpleFilter()
    pairs: list[tuple[float, float]] = []
    ApproximateTimeSynchronizer([left, right], 10, 0.5).registerCallback(
        lambda a, b: pairs.append((seconds(a), seconds(b)))
    )
    for at in (1.0, 1.3, 1.45):
        left.signalMessage(point(at))
    right.signalMessage(point(1.4))
    right.signalMessage(point(1.4))
    assert pairs == [(1.45, 1.4), (1.3, 1.4)]


def test_messages_without_a_header(capfd: pytest.CaptureFixture[str]) -> None:
    source = SimpleFilter()
    cache = Cache(source)
    source.signalMessage(String(data="x"))
    assert cache.getLast() is None
    assert "dropped a String without a header" in capfd.readouterr().err
    Cache(source, allow_headerless=True)
    timed = Cache(source, allow_headerless=True)
    source.signalMessage(String(data="y"))
    assert timed.getLast().data == "y"


def test_a_subscriber(node: Node) -> None:
    subscriber = Subscriber(node, PointStamped, "points")
    got: list[float] = []
    subscriber.registerCallback(lambda message: got.append(seconds(message)))
    assert (subscriber.getTopic(), subscriber.topic_name) == ("points", "/points")
    node.create_publisher(PointStamped, "points", 10).publish(point(7))
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    executor.spin_once(timeout_sec=30)
    assert got == [7]
    executor.shutdown()
