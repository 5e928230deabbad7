"""Users' functions on the in-process wire: they run while it holds no lock, so that they may write, match and close."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator

import pytest
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.message_filter import MessageFilter
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_ros.transform_listener import TransformListener

TIMEOUT_S = 30


@pytest.fixture
def buffer(node: Node) -> Iterator[Buffer]:
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    yield buffer
    listener.unregister()


@pytest.fixture
def broadcaster(node: Node) -> TransformBroadcaster:
    return TransformBroadcaster(node)


def in_time(function: Callable[[], object]) -> None:
    """Run a function on a thread, which a deadlock would leave behind; fail the test if it doesn't return."""
    ended = threading.Event()

    def run() -> None:
        function()
        ended.set()

    threading.Thread(target=run, daemon=True).start()
    assert ended.wait(TIMEOUT_S), "the call does not return"


def wait_for(buffer: Buffer, child: str) -> Future[bool]:
    return buffer.wait_for_transform_async("map", child, Time(seconds=1))


def test_done_callback_publishes_with_the_broadcaster_that_completed_it(
    buffer: Buffer, broadcaster: TransformBroadcaster
) -> None:
    found: list[bool] = []

    def publish(_: object) -> None:
        broadcaster.sendTransform(transform_stamped("base", "tool", SECOND))
        found.append(buffer.can_transform("map", "tool", Time(seconds=1)))

    wait_for(buffer, "base").add_done_callback(publish)
    in_time(lambda: broadcaster.sendTransform(transform_stamped("map", "base", SECOND)))
    assert found == [True]  # a write delivers before it returns, in a callback too


def test_message_filter_without_a_node_publishes(buffer: Buffer, broadcaster: TransformBroadcaster) -> None:
    messages: list[PointStamped] = []
    waiting = MessageFilter(None, buffer, "map", 10)

    def publish(message: PointStamped) -> None:
        broadcaster.sendTransform(transform_stamped("base", "tool", SECOND))
        messages.append(message)

    waiting.registerCallback(publish)
    point = PointStamped()
    point.header.frame_id = "base"
    point.header.stamp.sec = 1
    waiting.add(point)
    in_time(lambda: broadcaster.sendTransform(transform_stamped("map", "base", SECOND)))
    assert messages == [point]


def test_done_callback_opens_and_closes_ends_of_the_same_topic(
    node: Node, buffer: Buffer, broadcaster: TransformBroadcaster
) -> None:
    ended: list[str] = []

    def change(_: object) -> None:
        other = TransformListener(Buffer(), node)
        StaticTransformBroadcaster(node).sendTransform(transform_stamped("map", "fixed", SECOND))
        other.unregister()
        ended.append("changed")

    wait_for(buffer, "base").add_done_callback(change)
    in_time(lambda: broadcaster.sendTransform(transform_stamped("map", "base", SECOND)))
    assert ended == ["changed"]


def test_other_threads_write_while_a_callback_runs_and_keep_their_order(
    buffer: Buffer, broadcaster: TransformBroadcaster
) -> None:
    """What other threads write meanwhile is stored by the thread of the callback, after it."""
    count = 100
    after: list[bool] = []

    def publish_elsewhere(_: object) -> None:
        def publish() -> None:
            for number in range(count):
                broadcaster.sendTransform(transform_stamped("base", f"tool{number}", SECOND))

        in_time(publish)
        after.append(buffer.can_transform("map", "base", Time(seconds=1)))

    wait_for(buffer, "base").add_done_callback(publish_elsewhere)
    in_time(lambda: broadcaster.sendTransform(transform_stamped("map", "base", SECOND)))
    assert after == [True]
    assert all(buffer.can_transform("map", f"tool{number}", Time(seconds=1)) for number in range(count))
