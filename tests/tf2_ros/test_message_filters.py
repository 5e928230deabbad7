"""Synchronization of messages: each is passed on once, with its matches."""

from __future__ import annotations

import gc
import random
import sys
import weakref
from collections.abc import Callable
from functools import partial
from types import FrameType, SimpleNamespace
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.std_msgs.msg import Header, String
from tfloom.node.clock.clock import Clock, ROSClock
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import ClockType, Time
from tfloom.tf2_ros import message_filters
from tfloom.tf2_ros.message_filters import (
    ApproximateTimeSynchronizer,
    Cache,
    Chain,
    JumpBack,
    SimpleFilter,
    Subscriber,
    TimeSequencer,
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


def test_callbacks_may_be_registered_on_another_thread_while_messages_come() -> None:
    source = SimpleFilter()
    passed_on: list[float] = []
    source.registerCallback(lambda message: passed_on.append(seconds(message)))

    def register(frame: FrameType, _: str, __: object) -> Any:
        if frame.f_code.co_filename != message_filters.__file__:
            return None
        frame.f_trace_opcodes = True
        source.registerCallback(lambda _: None)
        return register

    former = sys.gettrace()
    sys.settrace(register)
    try:
        source.signalMessage(point(1))
    finally:
        sys.settrace(former)
    assert len(source.callbacks) > 3
    assert passed_on == [1]


def test_a_number_of_a_callback_is_not_given_again() -> None:
    source = SimpleFilter()
    former = source.registerCallback(print)
    source.unregisterCallback(former)
    source.registerCallback(print)
    source.unregisterCallback(former)
    assert len(source.callbacks) == 1


@pytest.mark.parametrize("meanwhile", ["add", "jump"])
def test_a_question_to_a_cache_is_answered_for_one_moment(meanwhile: str, sim: Sim) -> None:
    class Asked:
        """A stamp that is read while another thread changes the cache."""

        @property
        def nanoseconds(self) -> int:
            if meanwhile == "add":
                cache.add(point(5))
            else:
                cache.clear_after_jump(JumpBack(sim.clock, 0))
            return 3_000_000_000

    for question, answer in (("getElemBeforeTime", 3), ("getElemAfterTime", 3)):
        cache = Cache(None, 3)
        for at in (1, 2, 3):
            cache.add(point(at))
        assert seconds(getattr(cache, question)(Asked())) == answer
    cache = Cache(None, 3)
    for at in (1, 2, 3):
        cache.add(point(at))
    assert [seconds(message) for message in cache.getInterval(Time(seconds=1), Asked())] == [1, 2, 3]


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


class Sim:
    """A node with simulated time, and subscribers whose messages are called in."""

    def __init__(self, node: Node) -> None:
        self.node = node
        self.clock = node.get_clock()
        assert isinstance(self.clock, ROSClock)
        self.clock.set_ros_time_is_active(True)
        self.subscribers = [Subscriber(node, PointStamped, topic) for topic in ("left", "right")]

    def show(self, second: float) -> None:
        assert isinstance(self.clock, ROSClock)
        self.clock.set_ros_time_override(Time(seconds=second, clock_type=ClockType.ROS_TIME))

    def pair(self, second: float) -> None:
        for subscriber in self.subscribers:
            subscriber.callback(point(second))


@pytest.fixture
def sim(node: Node) -> Sim:
    return Sim(node)


class Passing(SimpleFilter):
    """A filter of a program's own."""

    def __init__(self, source: Any) -> None:
        super().__init__()
        source.registerCallback(self.add)

    def add(self, message: Any) -> None:
        self.signalMessage(message)


def chained(source: Any) -> Chain:
    chain = Chain(source)
    chain.addFilter(Cache(None, 1))
    return chain


WAYS: dict[str, Callable[[Any], Any]] = {
    "directly": lambda source: source,
    "through a cache": lambda source: Cache(source, 1),
    "through an empty chain": Chain,
    "through a chain": chained,
    "through a filter of one's own": Passing,
    "through two": lambda source: Passing(Cache(Chain(source), 1)),
}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(
    "kind", [TimeSynchronizer, partial(ApproximateTimeSynchronizer, slop=0.1)], ids=["exact", "near"]
)
def test_pairs_go_on_after_a_jump_backward(kind: Any, way: str, sim: Sim) -> None:
    passed_on: list[float] = []
    # What goes through one filter first is not kept alive by anything else.
    inputs = [WAYS[way](subscriber) for subscriber in sim.subscribers]
    kind(inputs, 1).registerCallback(lambda left, _: passed_on.append(seconds(left)))
    for jump_to in (10.0, 3.0, 0.5):
        passed_on.clear()
        sim.show(100)
        sim.pair(100)
        sim.subscribers[0].callback(point(101))  # waits for its match
        sim.show(jump_to)
        sim.subscribers[0].callback(point(101.2))  # was sent before the jump
        sim.pair(jump_to)
        sim.subscribers[1].callback(point(101))
        sim.pair(jump_to + 0.2)
        assert passed_on == [100, jump_to, jump_to + 0.2]


def test_a_set_is_not_made_across_a_jump(sim: Sim) -> None:
    passed_on: list[float] = []
    synchronizer = TimeSynchronizer(sim.subscribers, 5)
    synchronizer.registerCallback(lambda left, _: passed_on.append(seconds(left)))
    sim.show(10)
    sim.subscribers[0].callback(point(9.5))
    sim.show(9)
    sim.subscribers[1].callback(point(9.5))
    assert (passed_on, [len(queue) for queue in synchronizer.queues]) == ([], [0, 0])


@pytest.mark.parametrize("way", WAYS)
def test_a_cache_forgets_after_a_jump_backward_alone(way: str, sim: Sim) -> None:
    cache = Cache(WAYS[way](sim.subscribers[0]), 2)
    for at in (10, 11):
        sim.show(at)
        sim.pair(at)
    assert [seconds(message) for message in cache.cache_msgs] == [10, 11]
    sim.show(5)
    assert (cache.cache_msgs, cache.cache_times, cache.getLast(), cache.getLastestTime()) == (
        [],
        [],
        None,
        None,
    )
    sim.subscribers[0].callback(point(11))
    assert cache.getLast() is None
    sim.pair(5)
    sim.pair(6)
    assert [seconds(message) for message in cache.cache_msgs] == [5, 6]


def test_a_message_of_the_old_time_counts_again_when_the_time_is_reached(sim: Sim) -> None:
    cache = Cache(sim.subscribers[0], 5)
    sim.show(10)
    sim.show(9.9)
    sim.pair(10)
    assert cache.getLast() is None
    wait_until(lambda: (sim.pair(10), cache.getLast())[1] is not None)  # after the twentieth of a second


def test_another_source_of_time_clears_filters(sim: Sim) -> None:
    cache = Cache(sim.subscribers[0], 5)
    assert isinstance(sim.clock, ROSClock)
    for is_active in (False, True):
        sim.pair(5)
        sim.clock.set_ros_time_is_active(is_active)
        assert cache.getLast() is None


def test_filters_of_other_nodes_and_unregistered_ones_keep_their_messages(
    sim: Sim, make_node: Callable[..., Node]
) -> None:
    other = Cache(Subscriber(make_node("other"), PointStamped, "topic"), 5)
    freed = Cache(sim.subscribers[0], 5)
    kept = Cache(sim.subscribers[0], 5)
    other.add(point(50))
    sim.show(100)
    sim.pair(100)
    sim.subscribers[0].unregisterCallback(freed.incoming_connection)
    sim.show(10)
    assert [len(cache.cache_msgs) for cache in (other, freed, kept)] == [1, 1, 0]


def test_the_clock_keeps_no_subscriber_alive(node: Node) -> None:
    clock = node.get_clock()
    handles = len(clock.jump_handles())
    subscriber = Subscriber(node, PointStamped, "topic")
    gone = weakref.ref(subscriber)
    assert len(clock.jump_handles()) == handles + 1
    node.destroy_subscription(subscriber.sub)
    del subscriber
    gc.collect()
    assert gone() is None
    assert len(clock.jump_handles()) == handles


def test_filters_in_a_circle_hear_of_a_jump_once(sim: Sim) -> None:
    first, second = Passing(sim.subscribers[0]), Passing(SimpleFilter())
    first.registerCallback(second.signalMessage)
    second.registerCallback(first.clear_after_jump)  # of the first, and not called
    second.unregisterCallback(0)
    second.registerCallback(first.add)
    cache = Cache(second, 5)
    cache.add(point(1))
    sim.show(100)
    sim.show(10)
    assert cache.getLast() is None


def test_equal_stamps_match_without_slop() -> None:
    sources, passed_on = synchronized(ApproximateTimeSynchronizer, 5, 0)
    for at in (1, 2.000000001, 3):
        sources[0].signalMessage(point(at))
    for at in (1, 2, 3):
        sources[1].signalMessage(point(at))
    assert passed_on == [(1, 1), (3, 3)]


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


def sequenced(
    sim: Sim, executor: SingleThreadedExecutor
) -> tuple[TimeSequencer, list[float], Callable[[], None]]:
    """Return a sequencer with a delay of 1 s, what it passes on, and a function that lets it look."""
    passed_on: list[float] = []
    sequencer = TimeSequencer(sim.subscribers[0], Duration(seconds=1), 0.001, 3, sim.node)
    sequencer.registerCallback(lambda message: passed_on.append(seconds(message)))
    looks: list[None] = []
    sim.node.create_timer(0.001, lambda: looks.append(None), clock=Clock(clock_type=ClockType.STEADY_TIME))
    executor.add_node(sim.node)

    def look() -> None:
        looks.clear()
        wait_until(lambda: (executor.spin_once(timeout_sec=0.1), len(looks) > 2)[1])

    return sequencer, passed_on, look


def test_messages_are_sequenced_by_their_stamps(sim: Sim, executor: SingleThreadedExecutor) -> None:
    sequencer, passed_on, look = sequenced(sim, executor)
    sim.show(10)
    for at in (9.5, 8.5, 9.0):
        sim.subscribers[0].callback(point(at))
    look()
    assert passed_on == [8.5, 9.0]
    sim.subscribers[0].callback(point(8.9))  # too late
    sim.subscribers[0].callback(point(9.0))  # as the last one, which is not
    sim.show(10.5)
    look()
    assert passed_on == [8.5, 9.0, 9.0, 9.5]
    for at in (11.0, 12.0, 13.0, 10.0):  # of four, the oldest is dropped
        sequencer.add(point(at))
    sim.show(20)
    look()
    assert passed_on[4:] == [11.0, 12.0, 13.0]


def test_a_sequencer_begins_anew_after_a_jump_backward(sim: Sim, executor: SingleThreadedExecutor) -> None:
    sequencer, passed_on, look = sequenced(sim, executor)
    sim.show(100)
    for at in (50, 99.9):
        sequencer.add(point(at))
    look()
    assert passed_on == [50]
    sim.show(3)
    sequencer.add(point(1))
    look()
    sim.show(200)
    look()
    assert passed_on == [50, 1]
    source = SimpleFilter()
    sequencer.connectInput(source)
    sim.subscribers[0].callback(point(150))
    source.signalMessage(point(160))
    look()
    assert passed_on == [50, 1, 160]


@pytest.mark.parametrize("wrong", [{"queue_size": 0}, {"delay": -1}, {"update_rate": 0}])
def test_wrong_numbers_of_a_sequencer_are_refused(wrong: dict[str, float], node: Node) -> None:
    values: dict[str, Any] = {"delay": 1.0, "update_rate": 0.1, "queue_size": 1} | wrong
    with pytest.raises(ValueError, match="TimeSequencer needs a queue size of 1 or more"):
        TimeSequencer(None, node=node, **values)
    with pytest.raises(TypeError, match="TimeSequencer"):
        TimeSequencer(None, 1.0, 0.1, 1, node=None)
