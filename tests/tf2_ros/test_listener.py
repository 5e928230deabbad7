"""Broadcasters, listeners and buffers on the in-process wire."""

from __future__ import annotations

import gc
import threading
import time
import weakref
from collections.abc import Callable, Iterator
from contextlib import suppress

import pytest
from tests.conftest import wait_until
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.interfaces.tf2_msgs.srv import FrameGraph
from tfloom.node.executing.events_executor import EventsExecutor
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import ExternalShutdownException
from tfloom.node.values.time import Time
from tfloom.rmw.base import Topic
from tfloom.tf2.errors import LookupException
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_ros.transform_listener import StaticTransformListener, TransformListener

NOW = Time()


def test_broadcast_transform_can_be_looked_up_without_executor(node: Node) -> None:
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    TransformBroadcaster(node).sendTransform(transform_stamped("map", "base", 5 * SECOND))
    StaticTransformBroadcaster(node).sendTransform([transform_stamped("base", "laser", 0)])
    transform = buffer.lookup_transform("map", "laser", NOW)
    assert (transform.header.frame_id, transform.child_frame_id, transform.header.stamp.sec) == (
        "map",
        "laser",
        5,
    )
    assert transform.transform.translation.x == 2.0
    assert "broadcaster: 'default_authority'" in buffer.all_frames_as_yaml()
    listener.unregister()


def test_several_transforms_in_one_message(buffer: Buffer, broadcaster: TransformBroadcaster) -> None:
    sent = (transform_stamped("map", f"f{i}", SECOND) for i in range(5))
    broadcaster.send_transform(sent)
    assert buffer.frame_names() == ["f0", "map", "f1", "f2", "f3", "f4"]


def test_qos_of_publishers_and_subscriptions(node: Node) -> None:
    listener = TransformListener(Buffer(), node)
    moving, static = TransformBroadcaster(node), StaticTransformBroadcaster(node)
    profiles = {
        "sub": listener.tf_sub.qos_profile,
        "static sub": listener.tf_static_sub.qos_profile,
        "pub": moving.pub_tf.qos_profile,
        "static pub": static.pub_tf.qos_profile,
    }
    assert {name: (p.depth, p.durability) for name, p in profiles.items()} == {
        "sub": (100, DurabilityPolicy.VOLATILE),
        "static sub": (100, DurabilityPolicy.TRANSIENT_LOCAL),
        "pub": (100, DurabilityPolicy.VOLATILE),
        "static pub": (1, DurabilityPolicy.TRANSIENT_LOCAL),
    }
    assert {p.reliability for p in profiles.values()} == {ReliabilityPolicy.RELIABLE}


def test_late_subscriptions_receive_all_static_transforms(node: Node) -> None:
    broadcaster = StaticTransformBroadcaster(node)
    for index in range(3):
        broadcaster.sendTransform(transform_stamped("base", f"s{index}", 0))
    buffer = Buffer()
    TransformListener(buffer, node)
    assert all(buffer.can_transform("base", f"s{index}", NOW) for index in range(3))


def test_static_transforms_of_several_threads_are_all_in_the_last_message(
    node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    broadcaster = StaticTransformBroadcaster(node)
    sent: list[list[str]] = []
    others = [transform_stamped("base", "c", 0)]

    def publish(message: TFMessage) -> None:
        while others:  # another thread, between the change of the message and its publication
            broadcaster.sendTransform(others.pop())
        sent.append(sorted(stamped.child_frame_id for stamped in message.transforms))

    def given() -> Iterator[TransformStamped]:
        yield transform_stamped("base", "a", 0)
        broadcaster.sendTransform(transform_stamped("base", "b", 0))  # another thread, before the change

    monkeypatch.setattr(broadcaster.pub_tf, "publish", publish)
    broadcaster.sendTransform(transform_stamped("base", "d", 0))
    assert sent[-1] == ["c", "d"]
    broadcaster.sendTransform(given())
    assert sent[-1] == ["a", "b", "c", "d"]


def test_a_static_transform_sent_again_replaces_the_first(node: Node, buffer: Buffer) -> None:
    broadcaster = StaticTransformBroadcaster(node)
    broadcaster.sendTransform(transform_stamped("a", "b", 0))
    broadcaster.sendTransform(transform_stamped("b", "d", 0))
    broadcaster.sendTransform(transform_stamped("new_parent", "d", 0, (7.0, 0.0, 0.0)))
    assert len(broadcaster.net_message.transforms) == 2
    assert buffer.lookup_transform("new_parent", "d", NOW).transform.translation.x == 7.0
    assert not buffer.can_transform("a", "d", NOW)


def test_lookup_can_wait_in_a_callback_of_a_single_threaded_executor(
    node: Node, buffer: Buffer, broadcaster: TransformBroadcaster, executor: SingleThreadedExecutor
) -> None:
    found: list[float] = []

    def look_up() -> None:
        transform = buffer.lookup_transform("map", "base", Time(seconds=5), Duration(seconds=30))
        found.append(transform.transform.translation.x)

    node.create_timer(0.001, look_up)
    send_soon(broadcaster)
    start = time.monotonic()
    executor.spin_once(timeout_sec=30)
    assert found == [1.0]
    assert time.monotonic() - start < 20


def send_soon(broadcaster: TransformBroadcaster) -> None:
    threading.Timer(0.05, broadcaster.sendTransform, [transform_stamped("map", "base", 5 * SECOND)]).start()


def test_spin_once_returns_after_a_transform(
    executor: SingleThreadedExecutor, buffer: Buffer, broadcaster: TransformBroadcaster
) -> None:
    send_soon(broadcaster)
    while not buffer.can_transform("map", "base", NOW):
        executor.spin_once()


def test_spin_once_returns_for_transforms_since_the_last_call(
    node: Node, executor: SingleThreadedExecutor, buffer: Buffer, broadcaster: TransformBroadcaster
) -> None:
    """As for a callback: also if the message was received before, or while the node was in no executor."""
    StaticTransformBroadcaster(node).sendTransform(transform_stamped("base", "laser", 0))
    executor.remove_node(node)
    executor.add_node(node)
    executor.spin_once()
    broadcaster.sendTransform(transform_stamped("map", "base", 5 * SECOND))
    executor.spin_once()
    start = time.monotonic()
    executor.spin_once(timeout_sec=0.05)  # for none
    assert time.monotonic() - start >= 0.05


def test_spin_once_inside_a_callback_returns_for_a_transform(
    node: Node, executor: SingleThreadedExecutor, buffer: Buffer, broadcaster: TransformBroadcaster
) -> None:
    seen: Future[bool] = Future()

    def wait() -> None:
        timer.cancel()
        send_soon(broadcaster)
        while not buffer.can_transform("map", "base", NOW):
            executor.spin_once()
        seen.set_result(True)

    timer = node.create_timer(0.001, wait)
    executor.spin_until_future_complete(seen, 30)
    assert seen.done()


@pytest.mark.parametrize("kind", [SingleThreadedExecutor, MultiThreadedExecutor, EventsExecutor])
@pytest.mark.parametrize("spin", ["spin", "spin_until_future_complete"])
def test_long_spins_do_not_wake_for_transforms(
    node: Node,
    kind: type[Executor],
    spin: str,
    monkeypatch: pytest.MonkeyPatch,
    buffer: Buffer,
    broadcaster: TransformBroadcaster,
) -> None:
    begun, ended = [], []
    collect = kind._collect

    def counted(self: Executor, *args: object, **options: object) -> bool:
        begun.append(1)
        has_response = collect(self, *args, **options)
        ended.append(1)
        return has_response

    with kind(context=node.context) as executor:
        executor.add_node(node)
        broadcaster.sendTransform(transform_stamped("map", "base", SECOND))
        done: Future[bool] = Future()
        executor.spin_until_future_complete(done, 0.01)  # what was posted before
        monkeypatch.setattr(kind, "_collect", counted)

        def run() -> None:
            with suppress(ExternalShutdownException):
                getattr(executor, spin)(*([done] if spin != "spin" else []))

        thread = threading.Thread(target=run)
        thread.start()
        wait_until(lambda: len(begun) > len(ended))
        for stamp in range(1, 101):
            broadcaster.sendTransform(transform_stamped("map", "base", stamp * SECOND))
        assert len(ended) < 5
        done.set_result(True)
        node.context.try_shutdown()
        thread.join(30)
        assert not thread.is_alive()
    assert buffer.get_latest_common_time("map", "base").nanoseconds == 100 * SECOND


def test_timeout_raises_the_error_of_the_lookup() -> None:
    start = time.monotonic()
    with pytest.raises(
        LookupException, match='"map" passed to lookupTransform argument target_frame does not exist'
    ):
        Buffer().lookup_transform("map", "base", NOW, Duration(seconds=0.1))
    assert 0.1 <= time.monotonic() - start < 10
    assert Buffer().can_transform(
        "map", "base", NOW, timeout=Duration(seconds=0.01), return_debug_tuple=True
    ) == (
        False,
        'Invalid frame ID "map" passed to canTransform argument target_frame - frame does not exist',
    )


def test_waiting_ends_when_the_context_is_shut_down(node: Node) -> None:
    buffer = Buffer(node=node)
    threading.Timer(0.05, node.context.try_shutdown).start()
    start = time.monotonic()
    assert not buffer.can_transform("map", "base", NOW, Duration(seconds=60))
    assert time.monotonic() - start < 30


def test_buffer_can_be_replaced(node: Node, broadcaster: TransformBroadcaster) -> None:
    first, second = Buffer(), Buffer()
    listener = TransformListener(first, node)
    broadcaster.sendTransform(transform_stamped("map", "a", SECOND))
    listener.buffer = second
    broadcaster.sendTransform(transform_stamped("map", "b", SECOND))
    assert listener.buffer is second
    assert (first.frame_names(), second.frame_names()) == (["a", "map"], ["b", "map"])


def test_an_overridden_setter_is_called_for_each_transform(
    node: Node, executor: SingleThreadedExecutor
) -> None:
    seen: list[str] = []

    class Filtering(Buffer):
        def set_transform(self, transform: object, authority: str) -> None:
            seen.append(transform.child_frame_id)
            super().set_transform(transform, authority)

    buffer = Filtering()
    TransformListener(buffer, node)
    TransformBroadcaster(node).sendTransform(transform_stamped("map", "base", SECOND))
    executor.spin_once(timeout_sec=30)
    assert seen == ["base"]
    assert buffer.can_transform("map", "base", NOW)


def test_spin_thread_spins_the_node_until_the_listener_is_freed(node: Node) -> None:
    ticked = threading.Event()
    node.create_timer(0.001, ticked.set)
    listener = TransformListener(Buffer(), node, spin_thread=True)
    assert ticked.wait(30)
    thread = listener.dedicated_listener_thread
    assert thread.is_alive()
    listener.unregister()
    del listener
    gc.collect()
    thread.join(30)
    assert not thread.is_alive()


def test_custom_topics_and_static_only(node: Node) -> None:
    buffer = Buffer()
    listener = TransformListener(buffer, node, tf_topic="/robot/tf", tf_static_topic="/robot/tf_static")
    assert (listener.tf_sub.topic_name, listener.tf_static_sub.topic_name) == (
        "/robot/tf",
        "/robot/tf_static",
    )
    static = StaticTransformListener(buffer, node)
    assert static.tf_sub is None
    TransformBroadcaster(node).sendTransform(transform_stamped("map", "base", SECOND))
    StaticTransformBroadcaster(node).sendTransform(transform_stamped("base", "laser", 0))
    assert buffer.frame_names() == ["laser", "base"]


def test_a_listener_frees_its_buffer(node: Node) -> None:
    buffer = Buffer(node=node)
    listener = TransformListener(buffer, node)
    listener.unregister()
    alive = weakref.ref(buffer)
    del buffer, listener
    gc.collect()
    assert alive() is None


def test_unreadable_messages_are_dropped_with_one_warning(
    node: Node, capfd: pytest.CaptureFixture[str], wait_until: Callable[..., None], buffer: Buffer
) -> None:
    publisher = node.create_publisher(TFMessage, "/tf", 100)
    for _ in range(200):
        publisher.publish(b"\0\1\0\0\xff\xff\xff\xff")
    TransformBroadcaster(node).sendTransform(transform_stamped("map", "base", SECOND))
    wait_until(lambda: buffer.can_transform("map", "base", NOW))
    warnings = [line for line in capfd.readouterr().err.splitlines() if "dropped a message" in line]
    assert 1 <= len(warnings) <= 3


def test_a_future_is_completed_by_the_transform(buffer: Buffer, broadcaster: TransformBroadcaster) -> None:
    future = buffer.wait_for_transform_async("map", "base", Time(seconds=2))
    cancelled = buffer.wait_for_transform_async("map", "base", Time(seconds=2))
    cancelled.cancel()
    assert not future.done()
    broadcaster.sendTransform(transform_stamped("map", "base", SECOND))
    assert not future.done()
    broadcaster.sendTransform(transform_stamped("map", "base", 3 * SECOND))
    assert future.result().header.stamp.sec == 2
    assert not cancelled.done()
    done = buffer.wait_for_transform_full_async("map", NOW, "base", NOW, "map")
    assert done.result().child_frame_id == "base"


def test_coroutine_suspends_once() -> None:
    buffer = Buffer()
    waiting = buffer.lookup_transform_async("map", "base", NOW)
    waiting.send(None)
    buffer.set_transform(transform_stamped("map", "base", SECOND), "me")
    for coroutine in (waiting, buffer.lookup_transform_full_async("base", NOW, "map", NOW, "map")):
        with pytest.raises(StopIteration) as ended:
            coroutine.send(None)
        assert ended.value.value.header.stamp.sec == 1


def test_future_of_an_impossible_transform_has_the_error() -> None:
    buffer = Buffer()
    buffer.set_transform(transform_stamped("map", "base", 100 * SECOND), "me")
    future = buffer.wait_for_transform_async("map", "base", Time(seconds=1))
    with pytest.raises(Exception, match="extrapolation"):
        future.result()


def test_jump_backward_clears_the_buffer(buffer: Buffer, set_time: Callable[[float], None]) -> None:
    set_time(100)
    buffer.set_transform(transform_stamped("map", "base", 100 * SECOND), "me")
    set_time(99.5)
    assert buffer.can_transform("map", "base", NOW)
    set_time(10)
    assert not buffer.can_transform("map", "base", NOW)


def test_service_returns_the_frames(node: Node, executor: SingleThreadedExecutor) -> None:
    buffer = Buffer(node=node)
    buffer.set_transform(transform_stamped("map", "base", SECOND), "me")
    client = node.create_client(FrameGraph, "tf2_frames")
    future = client.call_async(FrameGraph.Request())
    executor.spin_until_future_complete(future, timeout_sec=30)
    assert future.result().frame_yaml == buffer.all_frames_as_yaml() != "[]"


def test_stragglers_from_before_a_jump_are_ignored(
    buffer: Buffer, broadcaster: TransformBroadcaster, set_time: Callable[[float], None]
) -> None:
    set_time(100)
    broadcaster.sendTransform(transform_stamped("map", "base", 100 * SECOND))
    set_time(10)
    broadcaster.sendTransform(transform_stamped("map", "base", 100 * SECOND))  # late
    assert not buffer.can_transform("map", "base", NOW)
    broadcaster.sendTransform(transform_stamped("map", "base", 10 * SECOND))
    assert buffer.lookup_transform("map", "base", NOW).header.stamp.sec == 10


def test_futures_time_out_with_the_reason(wait_until: Callable[..., None]) -> None:
    buffer = Buffer()
    slow = buffer.wait_for_transform_async("map", "base", NOW, timeout=Duration(seconds=30))
    quick = buffer.wait_for_transform_async("map", "base", NOW, timeout=Duration(seconds=0.02))
    wait_until(quick.done)
    with pytest.raises(LookupException, match='timed out: Invalid frame ID "map" passed to canTransform'):
        quick.result()
    buffer.set_transform(transform_stamped("map", "base", SECOND), "me")
    assert slow.result().header.stamp.sec == 1
    coroutine = buffer.lookup_transform_full_async(
        "map", NOW, "nowhere", NOW, "map", timeout=Duration(seconds=0.01)
    )
    awaited = coroutine.send(None)
    wait_until(awaited.done)
    with pytest.raises(LookupException, match="timed out"):
        coroutine.send(None)


def test_listener_creates_a_node_if_none_is_given(
    local_context: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tfloom.node import client_library as rclpy

    monkeypatch.setenv("ROS_DOMAIN_ID", "77")
    rclpy.init(args=["program", "--ros-args", "-r", "__node:=renamed"])
    try:
        listener = TransformListener(Buffer())
        assert listener.node.get_name().startswith("transform_listener_impl_")
        del listener
        gc.collect()
    finally:
        rclpy.try_shutdown()


def test_messages_have_the_type_of_tf2_msgs(node: Node) -> None:
    assert Topic("/tf", TFMessage._TYPE_NAME, TFMessage._TYPE_HASH).type_name == "tf2_msgs/msg/TFMessage"
    assert isinstance(TransformBroadcaster(node, QoSProfile(depth=3)).pub_tf.qos_profile, QoSProfile)
