"""Messages wait for their transforms: target frames, tolerance, timeout and queue size."""

from __future__ import annotations

import threading

import pytest
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.node.clock.clock import ROSClock
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import ClockType, Time
from tfloom.tf2_ros import message_filters
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.message_filter import (
    FilterFailureReason,
    MessageFilter,
    get_filter_failure_reason_string,
)
from tfloom.tf2_ros.message_filters import SimpleFilter, Subscriber
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_ros.transform_listener import TransformListener


def point(stamp_ns: int, frame_id: str = "laser") -> PointStamped:
    return PointStamped(header=Header(stamp=Time(nanoseconds=stamp_ns).to_msg(), frame_id=frame_id))


class Watched:
    """A filter with its buffer, and its output."""

    def __init__(self, target: str | list[str] = "map", queue_size: int = 10, **options: object) -> None:
        self.buffer = Buffer()
        self.filter = MessageFilter(None, self.buffer, target, queue_size, **options)
        self.out: list[int] = []
        self.dropped: list[tuple[int, str]] = []
        self.filter.registerCallback(lambda message: self.out.append(self.stamp(message)))
        self.filter.registerFailureCallback(
            lambda message, reason: self.dropped.append((self.stamp(message), reason.name))
        )

    def stamp(self, message: PointStamped) -> int:
        return message.header.stamp.sec * SECOND + message.header.stamp.nanosec

    def set(self, stamp_ns: int, parent: str = "map", child: str = "laser") -> None:
        self.buffer.set_transform(transform_stamped(parent, child, stamp_ns), "me")


def test_transformable_message_passes_at_once() -> None:
    watched = Watched()
    watched.set(5 * SECOND)
    watched.filter.add(point(5 * SECOND))
    watched.filter.add(point(5 * SECOND, "/laser"))
    assert watched.out == [5 * SECOND] * 2


def test_a_message_waits_for_its_transform_to_the_nanosecond() -> None:
    watched = Watched()
    watched.filter.add(point(5 * SECOND + 1))
    for stamp in (4 * SECOND, 5 * SECOND):
        watched.set(stamp)
        assert watched.out == []
    watched.set(5 * SECOND + 1)
    assert watched.out == [5 * SECOND + 1]
    watched.set(6 * SECOND)
    assert watched.out == [5 * SECOND + 1]


def test_tolerance_requires_a_later_transform_too() -> None:
    watched = Watched()
    watched.filter.setTolerance(Duration(seconds=0.2))
    watched.set(4 * SECOND)
    watched.filter.add(point(5 * SECOND))
    watched.set(5 * SECOND + SECOND // 10)
    assert watched.out == []
    watched.set(5 * SECOND + SECOND // 5)
    assert watched.out == [5 * SECOND]


def test_all_target_frames_are_required() -> None:
    watched = Watched(["/map", "odom"])
    assert watched.filter.getTargetFramesString() == "map odom "
    watched.filter.add(point(5 * SECOND))
    watched.set(5 * SECOND)
    assert watched.out == []
    watched.set(5 * SECOND, "odom", "map")
    assert watched.out == [5 * SECOND]
    watched.filter.setTargetFrame("elsewhere")
    watched.filter.add(point(5 * SECOND))
    assert watched.out == [5 * SECOND]


def test_full_queue_drops_the_oldest(capfd: pytest.CaptureFixture[str]) -> None:
    watched = Watched(queue_size=2)
    assert watched.filter.getQueueSize() == 2
    for second in range(1, 5):
        watched.filter.add(point(second * SECOND))
    assert watched.dropped == [(SECOND, "QueueFull"), (2 * SECOND, "QueueFull")]
    assert (
        "Message Filter dropping message: frame 'laser' at time 2.000 for reason 'discarding message because the "
        "queue is full'" in "".join(capfd.readouterr())
    )
    for second in range(1, 5):
        watched.set(second * SECOND)
    assert watched.out == [3 * SECOND, 4 * SECOND]


def test_queue_size_zero_has_no_limit() -> None:
    watched = Watched(queue_size=0)
    for second in range(100):
        watched.filter.add(point(second * SECOND + 1))
    watched.filter.clear()
    watched.set(1)
    assert (watched.out, watched.dropped) == ([], [])


def test_message_that_can_never_be_transformed_is_dropped() -> None:
    watched = Watched()
    watched.filter.add(point(SECOND, ""))
    watched.filter.add(point(SECOND, "/"))
    watched.filter.add(point(3 * SECOND))
    watched.set(100 * SECOND)
    watched.filter.add(point(2 * SECOND))
    assert watched.dropped == [
        (SECOND, "EmptyFrameID"), (SECOND, "EmptyFrameID"), (3 * SECOND, "OutTheBack"), (2 * SECOND, "OutTheBack")
    ]  # fmt: skip
    assert watched.out == []


def test_message_is_dropped_after_the_timeout(wait_until: object) -> None:
    watched = Watched(buffer_timeout=Duration(seconds=0.02))
    watched.filter.add(point(SECOND))
    wait_until(lambda: watched.dropped)
    assert watched.dropped == [(SECOND, "NoTransformFound")]
    watched.set(SECOND)
    assert watched.out == []


def test_names_of_reasons() -> None:
    names = [get_filter_failure_reason_string(reason) for reason in range(6)]
    assert names == [
        "Unknown", "OutTheBack", "EmptyFrameID", "NoTransformFound", "QueueFull", "Invalid Failure Reason"
    ]  # fmt: skip


def test_from_a_topic_by_the_nodes_executor(
    node: Node, broadcaster: TransformBroadcaster, executor: SingleThreadedExecutor
) -> None:
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    waiting = MessageFilter(Subscriber(node, PointStamped, "points"), buffer, "map", 10)
    threads: list[threading.Thread] = []
    waiting.registerCallback(lambda _: threads.append(threading.current_thread()))
    dropped: list[FilterFailureReason] = []
    waiting.registerFailureCallback(lambda _, reason: dropped.append(reason))
    node.create_publisher(PointStamped, "points", 10).publish(point(5 * SECOND))
    executor.spin_once(timeout_sec=30)
    sender = threading.Thread(
        target=broadcaster.sendTransform, args=(transform_stamped("map", "laser", 5 * SECOND),)
    )
    sender.start()
    while not threads:  # the transform ends a spin_once, too
        executor.spin_once(timeout_sec=30)
    assert threads == [threading.current_thread()]
    sender.join()
    waiting.add(point(SECOND, ""))
    while not dropped:
        executor.spin_once(timeout_sec=30)
    assert dropped == [FilterFailureReason.EmptyFrameID]
    listener.unregister()


def test_messages_and_transforms_from_many_threads() -> None:
    watched = Watched(queue_size=0)
    source = SimpleFilter()
    watched.filter.connectInput(source)
    count = 2000

    def send(start: int) -> None:
        for index in range(start, count, 2):
            source.signalMessage(point(SECOND + index))

    def store() -> None:
        for index in range(count):
            watched.set(SECOND + index)

    threads = [
        threading.Thread(target=send, args=(0,)),
        threading.Thread(target=send, args=(1,)),
        threading.Thread(target=store),
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
    watched.set(3 * SECOND)
    assert sorted(watched.out) == [SECOND + index for index in range(count)]
    assert watched.dropped == []


def test_messages_that_wait_for_the_executor_are_dropped_by_clear_and_failures_are_not(
    node: Node, executor: SingleThreadedExecutor
) -> None:
    watched = Watched(node=node)
    watched.filter.add(point(5 * SECOND))
    watched.filter.add(point(7 * SECOND, ""))
    watched.set(5 * SECOND)
    watched.filter.clear()
    watched.filter.add(point(6 * SECOND))
    watched.set(6 * SECOND)
    while not watched.out:
        executor.spin_once(timeout_sec=30)
    assert (watched.out, watched.dropped) == ([6 * SECOND], [(7 * SECOND, "EmptyFrameID")])


def test_nothing_is_passed_on_or_raised_after_the_end_of_the_node(
    node: Node, capfd: pytest.CaptureFixture[str]
) -> None:
    watched = Watched(node=node)
    watched.filter.add(point(5 * SECOND))
    node.destroy_node()
    watched.set(5 * SECOND)
    watched.filter.add(point(7 * SECOND, ""))
    assert watched.out == watched.dropped == []
    assert "InvalidHandle" not in capfd.readouterr().err


def test_a_message_that_is_added_during_clear_is_not_held() -> None:
    watched = Watched()
    add_request = watched.buffer.add_request

    def clear_before(*query: object) -> int | None:
        watched.filter.clear()
        return add_request(*query)

    watched.buffer.add_request = clear_before  # type: ignore[assignment,method-assign]
    watched.filter.add(point(5 * SECOND))
    watched.set(5 * SECOND)
    assert (watched.out, watched.dropped, watched.filter._held) == ([], [], {})


@pytest.mark.parametrize("is_fed_by_subscriber", [True, False])
def test_messages_are_forgotten_when_time_jumps_backward(
    is_fed_by_subscriber: bool, node: Node, executor: SingleThreadedExecutor
) -> None:
    clock = node.get_clock()
    assert isinstance(clock, ROSClock)
    clock.set_ros_time_is_active(True)
    clock.set_ros_time_override(Time(seconds=100, clock_type=ClockType.ROS_TIME))
    watched = Watched(node=node)
    if is_fed_by_subscriber:
        subscriber = Subscriber(node, PointStamped, "points")
        watched.filter = MessageFilter(subscriber, watched.buffer, "map", 1)
        watched.filter.registerCallback(lambda message: watched.out.append(watched.stamp(message)))
    add = subscriber.callback if is_fed_by_subscriber else watched.filter.add
    add(point(100 * SECOND))
    clock.set_ros_time_override(Time(seconds=10, clock_type=ClockType.ROS_TIME))
    add(point(10 * SECOND))
    for stamp in (10, 100):
        watched.set(stamp * SECOND)
        executor.spin_once(timeout_sec=0.1)
    assert (watched.out, watched.dropped) == ([10 * SECOND], [])


def test_a_message_from_before_a_jump_that_comes_after_it_crowds_out_none(
    node: Node, executor: SingleThreadedExecutor, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(message_filters, "monotonic", lambda: 0.0)  # the time of such messages isn't over
    clock = node.get_clock()
    assert isinstance(clock, ROSClock)
    clock.set_ros_time_is_active(True)
    clock.set_ros_time_override(Time(seconds=100, clock_type=ClockType.ROS_TIME))
    watched = Watched(queue_size=1, node=node)
    clock.set_ros_time_override(Time(seconds=10, clock_type=ClockType.ROS_TIME))
    watched.filter.add(point(11 * SECOND))
    watched.filter.add(point(100 * SECOND))
    watched.set(11 * SECOND)
    watched.filter.add(point(11 * SECOND, ""))
    while not watched.dropped:
        executor.spin_once(timeout_sec=30)
    assert (watched.out, watched.dropped) == ([11 * SECOND], [(11 * SECOND, "EmptyFrameID")])
