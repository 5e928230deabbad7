"""message_filters of what has changed, of the order of several inputs, and of stamps with an offset."""

from __future__ import annotations

import threading
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.conftest import wait_until

from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.tf2_ros.delta_filter import (
    CachedComparisonHandler,
    ComparisonFilter,
    ComparisonHandler,
    DeltaCompare,
    DeltaFilter,
    PathDeltaFilter,
)
from tfloom.tf2_ros.input_aligner import InputAligner, QueueStatus
from tfloom.tf2_ros.message_filters import (
    ApproximateTimeSynchronizer,
    Cache,
    Chain,
    SimpleFilter,
    TimeSynchronizer,
)

S = 10**9


def point(seconds: float, x: float = 0.0) -> PointStamped:
    message = PointStamped(header=Header(stamp=Time(nanoseconds=round(seconds * S)).to_msg()))
    message.point.x = x
    return message


def seconds(message: PointStamped) -> float:
    return message.header.stamp.sec + message.header.stamp.nanosec / S


class Overtaken:
    """A jump of time that reaches everything once, and has overtaken messages from a time on."""

    def __init__(self, from_ns: int = 2**62) -> None:
        self._from_ns = from_ns
        self._reached: set[int] = set()

    def reaches(self, filter_: object) -> bool:
        is_first = id(filter_) not in self._reached
        self._reached.add(id(filter_))
        return is_first

    def has_overtaken(self, stamp_ns: int) -> bool:
        return stamp_ns >= self._from_ns


def test_delta_filter_passes_on_what_has_changed() -> None:
    source = SimpleFilter()
    passed: list[tuple[float, float]] = []
    changed = DeltaFilter([lambda message: message.point.x, lambda message: message.point.y], source)
    changed.registerCallback(lambda message: passed.append((message.point.x, message.point.y)))
    for x, y in [(1, 1), (1, 1), (2, 1), (2, 1), (2, 3), (1, 1)]:
        message = point(0, float(x))
        message.point.y = float(y)
        source.signalMessage(message)
    assert passed == [(1, 1), (2, 1), (2, 3), (1, 1)]


def test_delta_is_to_the_last_message_that_was_passed_on() -> None:
    class Farther(CachedComparisonHandler):
        def do_fields_fit(self, field_a: float, field_b: float) -> bool:
            return abs(field_a - field_b) >= 1.0

    passed: list[float] = []
    far = ComparisonFilter(Farther(lambda message: message.point.x))
    far.registerCallback(lambda message: passed.append(message.point.x))
    for x in (0.0, 0.6, 1.2, 1.8, 2.4):
        far.add(point(0, x))
    assert passed == [0.0, 1.2, 2.4]


def test_paths_of_fields() -> None:
    passed: list[float] = []
    changed = PathDeltaFilter(["header.frame_id", ("point", "x")])
    changed.registerCallback(lambda message: passed.append(seconds(message)))
    for number, (frame, x) in enumerate([("a", 1.0), ("a", 1.0), ("b", 1.0), ("b", 2.0)]):
        message = point(number, x)
        message.header.frame_id = frame
        changed.add(message)
    assert passed == [0, 2, 3]
    one = PathDeltaFilter("point.x")
    assert [one.message_fits(point(0, x)) for x in (1.0, 1.0, 2.0)] == [True, False, True]
    for path in ("point..x", [["point", 3]], [[]], "a b"):
        with pytest.raises(TypeError, match=r"as 'pose.position.x', got"):
            PathDeltaFilter(path)


def test_arrays_differ_by_any_element() -> None:
    compare = DeltaCompare([lambda message: message.data])
    arrays = [np.array([1, 2]), np.array([1, 2]), np.array([1, 3])]
    assert [compare.message_fits(SimpleNamespace(data=data)) for data in arrays] == [True, False, True]


def test_arguments_of_comparisons() -> None:
    with pytest.raises(TypeError, match="DeltaCompare needs callables that return a field"):
        DeltaFilter(["x"])  # type: ignore[list-item]
    with pytest.raises(ValueError, match="at least one callable"):
        DeltaFilter([])
    with pytest.raises(TypeError, match="needs a handler, which has message_fits, got 3"):
        ComparisonFilter(3)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="abstract"):
        ComparisonHandler()  # type: ignore[abstract]
    source = SimpleFilter()
    changed = DeltaFilter([seconds], source)
    with pytest.raises(RuntimeError, match="Already connected"):
        changed.connectInput(source)


def test_delta_filters_in_a_chain_forget_at_a_jump() -> None:
    passed: list[float] = []
    chain = Chain()
    chain.addFilter(PathDeltaFilter("point.x"))
    chain.registerCallback(lambda message: passed.append(seconds(message)))
    for number in range(2):
        chain.add(point(number, 1.0))
    chain.clear_after_jump(Overtaken())  # type: ignore[arg-type]
    chain.add(point(5, 1.0))
    assert passed == [0, 5]


def test_offsets_are_added_to_stamps() -> None:
    sources = [SimpleFilter() for _ in range(2)]
    matched: list[tuple[float, ...]] = []
    synchronizer = ApproximateTimeSynchronizer(sources, 10, 0.1, queue_offset=[0, S // 2])
    synchronizer.registerCallback(lambda *messages: matched.append(tuple(map(seconds, messages))))
    for number in range(3):
        sources[0].signalMessage(point(number + 0.5))
        sources[1].signalMessage(point(number))
    sources[0].signalMessage(point(10))
    sources[1].signalMessage(point(10))
    assert matched == [(0.5, 0), (1.5, 1), (2.5, 2)]


@pytest.mark.parametrize(
    ("offset", "error", "said"),
    [
        (True, ValueError, "for that of Jazzy write allow_headerless=True"),
        ([1], ValueError, "a number for each of 2 filters, got 1"),
        ([1, 0.5], TypeError, r"must be a list of int \[ns\]"),
        (5, TypeError, r"must be a list of int \[ns\], got 5"),
    ],
)
def test_offsets_that_cannot_be_used(offset: Any, error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        ApproximateTimeSynchronizer([SimpleFilter(), SimpleFilter()], 10, 0.1, queue_offset=offset)


class Aligned:
    """An aligner of inputs, and what it has passed on: input and seconds."""

    def __init__(self, count: int = 2, timeout_s: float = 10.0) -> None:
        self.sources = [SimpleFilter() for _ in range(count)]
        self.aligner = InputAligner(Duration(seconds=timeout_s), self.sources)
        self.passed: list[tuple[int, float]] = []
        self.register()

    def register(self) -> None:
        for index in range(len(self.sources)):
            self.aligner.registerCallback(
                index, lambda message, index: self.passed.append((index, seconds(message))), index
            )

    def send(self, index: int, *stamps: float) -> None:
        for stamp in stamps:
            self.sources[index].signalMessage(point(stamp))

    def expect(self, *expected: tuple[int, float]) -> None:
        self.aligner.dispatchMessages()
        assert self.passed == list(expected)
        self.passed.clear()

    def status(self, index: int) -> QueueStatus:
        return self.aligner.getQueueStatus(index)


def test_messages_are_passed_on_in_the_order_of_stamps() -> None:
    aligned = Aligned()
    aligned.send(0, 1, 3, 5)
    aligned.send(1, 4, 2)
    assert aligned.passed == []
    aligned.expect((0, 1), (1, 2), (0, 3), (1, 4))
    assert aligned.status(0) == QueueStatus(active=True, queue_size=1, msgs_processed=2, msgs_dropped=0)
    aligned.send(1, 7)
    aligned.expect((0, 5))


def test_equal_stamps_are_in_the_order_of_arrival() -> None:
    aligned = Aligned()
    aligned.send(0, 1, 1)
    aligned.send(1, 1)
    aligned.expect((0, 1), (0, 1), (1, 1))


def test_inputs_without_a_first_message_are_not_waited_for() -> None:
    aligned = Aligned(3)
    assert aligned.status(2) == QueueStatus(False, 0, 0, 0)
    aligned.send(0, 1, 2)
    aligned.expect((0, 1), (0, 2))


def test_period_of_an_input_spares_others_the_wait() -> None:
    aligned = Aligned()
    aligned.aligner.setInputPeriod(1, Duration(seconds=1.0))
    aligned.send(1, 1)
    aligned.send(0, 1.5, 1.9, 2.1)
    aligned.expect((1, 1), (0, 1.5), (0, 1.9))
    aligned.send(1, 2)
    aligned.expect((1, 2), (0, 2.1))


def test_input_that_is_silent_times_out_and_comes_back() -> None:
    aligned = Aligned(timeout_s=2.0)
    aligned.send(0, 1, 2, 3)
    aligned.send(1, 1)
    aligned.expect((0, 1), (1, 1))
    aligned.send(0, 3.5)
    aligned.expect((0, 2), (0, 3), (0, 3.5))
    assert not aligned.status(1).active
    aligned.send(1, 3)  # too late
    assert aligned.status(1) == QueueStatus(False, 0, 1, 1)
    aligned.send(1, 4)
    assert aligned.status(1).active
    aligned.expect()
    aligned.send(0, 6)
    aligned.expect((1, 4))


def test_new_inputs_replace_the_old_ones() -> None:
    aligned = Aligned()
    old = aligned.sources
    aligned.send(0, 1)
    aligned.sources = [SimpleFilter(), SimpleFilter()]
    aligned.aligner.connectInput(aligned.sources)
    old[0].signalMessage(point(2))
    aligned.expect()
    aligned.register()
    aligned.send(0, 0.5)
    aligned.expect((0, 0.5))
    aligned.aligner.disconnectAll()
    aligned.send(0, 1)
    aligned.expect()


def test_a_callback_that_raises_ends_one_call_alone() -> None:
    aligned = Aligned()

    def fail(message: Any) -> None:
        if seconds(message) == 1:
            raise KeyError("inside")

    aligned.aligner.registerCallback(0, fail)
    aligned.send(0, 1, 2)
    with pytest.raises(KeyError, match="inside"):
        aligned.aligner.dispatchMessages()
    aligned.expect((0, 1), (0, 2))


def test_a_callback_may_add_and_dispatch() -> None:
    aligned = Aligned()

    def add_once(message: Any) -> None:
        if seconds(message) == 1:
            aligned.send(1, 1.5)
            aligned.aligner.dispatchMessages()

    aligned.aligner.registerCallback(0, add_once)
    aligned.send(0, 1, 2)
    aligned.expect((0, 1), (1, 1.5))
    aligned.send(1, 3)
    aligned.expect((0, 2))


def test_two_threads_keep_the_order() -> None:
    aligned = Aligned()
    aligned.send(0, *range(1, 400))
    aligned.send(1, *(number + 0.5 for number in range(1, 400)))
    threads = [threading.Thread(target=aligned.aligner.dispatchMessages) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    stamps = [stamp for _, stamp in aligned.passed]
    assert stamps == sorted(stamps)
    assert len(stamps) == 797


def test_names_and_inputs_that_are_not_there() -> None:
    aligned = Aligned()
    assert aligned.aligner.getName() == ""
    aligned.aligner.setName("aligner")
    assert aligned.aligner.getName() == "aligner"
    for use in (
        lambda: aligned.aligner.registerCallback(2, print),
        lambda: aligned.aligner.getQueueStatus(-1),
        lambda: aligned.aligner.add(point(1), 2),
    ):
        with pytest.raises(IndexError, match="there are 2, from 0"):
            use()  # type: ignore[no-untyped-call]
    with pytest.raises(TypeError, match="needs a callback"):
        aligned.aligner.registerCallback(0, 3)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="setupDispatchTimer"):
        aligned.aligner.setupDispatchTimer(3, Duration(seconds=1.0))


def test_messages_are_passed_on_by_a_timer(make_node: Any) -> None:
    aligned = Aligned()
    node: Node = make_node("aligning")
    aligned.aligner.setupDispatchTimer(node, Duration(seconds=0.01))
    aligned.send(0, 1, 2)
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        wait_until(lambda: executor.spin_once(0.01) or len(aligned.passed) == 2)  # type: ignore[func-returns-value]
    assert aligned.passed == [(0, 1), (0, 2)]


def test_a_jump_of_time_reaches_the_aligner_and_what_follows() -> None:
    aligned = Aligned()
    behind = Cache(None, 10)
    aligned.aligner.registerCallback(0, behind.add)
    aligned.send(0, 1, 5)
    aligned.send(1, 4)
    aligned.expect((0, 1), (1, 4))
    aligned.sources[0].clear_after_jump(Overtaken(5 * S))  # type: ignore[arg-type]
    assert behind.getLast() is None
    assert aligned.status(0) == QueueStatus(False, 0, 1, 0)
    aligned.send(0, 5, 2)  # 5 was sent before the jump
    aligned.send(1, 2.5)
    aligned.expect((0, 2))
    aligned.send(0, 3)
    aligned.expect((1, 2.5))
    assert seconds(behind.getLast()) == 2


def test_names_of_ros() -> None:
    import message_filters
    import message_filters.delta_filter as delta
    import message_filters.input_aligner as aligner
    import message_filters.simple_filter as simple

    assert (delta.DeltaFilter, aligner.InputAligner, simple.SimpleFilter) == (
        DeltaFilter,
        InputAligner,
        SimpleFilter,
    )
    assert message_filters.InputAligner is InputAligner
    assert isinstance(TimeSynchronizer([SimpleFilter()], 1), simple.SimpleFilter)


def test_getter_that_waits_delays_no_other_message_and_may_add_one() -> None:
    is_waiting, may_end = threading.Event(), threading.Event()

    def value_of(message: int) -> int:
        if message == 2:
            is_waiting.set()
            assert may_end.wait(30.0)
        return message

    passed: list[int] = []
    differing = DeltaFilter(value_of)
    differing.registerCallback(passed.append)
    differing.add(1)
    thread = threading.Thread(target=differing.add, args=[2], daemon=True)
    thread.start()
    assert is_waiting.wait(30.0)
    other = threading.Thread(target=differing.add, args=[3], daemon=True)
    other.start()
    other.join(30.0)
    assert (passed, other.is_alive()) == ([1, 3], False)
    may_end.set()
    thread.join(30.0)
    # It is compared once more, with the message that was passed on meanwhile.
    assert passed == [1, 3, 2]
