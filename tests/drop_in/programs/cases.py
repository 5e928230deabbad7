"""Cases of the drop-in buffer inside the real rclpy, each a function; print `name: passed`, or a traceback.

By hand, with the names of cases as arguments, only these are run.
"""

from __future__ import annotations

import gc
import inspect
import pickle
import sys
import threading
import time
import traceback
import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import rclpy
from builtin_interfaces.msg import Time as TimeMessage
from geometry_msgs import msg as g
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.task import Future
from rclpy.time import Time
from sensor_msgs.msg import PointCloud2, PointField

import tfloom.tf2.errors
from tfloom import drop_in
from tfloom.drop_in import Buffer, StaticTransformListener, TransformListener, real_ros, sources
from tfloom.ros_imports import guard as ros_guard

SECOND = 1_000_000_000


@contextmanager
def initialized() -> Iterator[None]:
    rclpy.init()
    try:
        yield
    finally:
        rclpy.try_shutdown()


def stamped(parent: str, child: str, stamp_ns: int, x: float = 0.0) -> g.TransformStamped:
    message = g.TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp = Time(nanoseconds=stamp_ns).to_msg()
    message.transform.translation.x = x
    return message


def filled() -> Buffer:
    buffer = Buffer()
    for second in range(5):
        buffer.set_transform(stamped("world", "turtle", second * SECOND + 5, float(second)), "test")
    buffer.set_transform_static(stamped("turtle", "camera", 0, 10.0), "test")
    return buffer


def expect(kind: type[Exception], function: Callable[[], object]) -> Exception:
    try:
        function()
    except kind as error:
        return error
    raise AssertionError(f"{kind} was not raised")


def case_answers_are_the_real_messages() -> None:
    transform = filled().lookup_transform("world", "camera", Time(nanoseconds=2 * SECOND + 5))
    assert type(transform) is g.TransformStamped
    assert type(transform).__module__.startswith("geometry_msgs.msg"), type(transform)
    assert (transform.header.frame_id, transform.child_frame_id) == ("world", "camera")
    assert (transform.header.stamp.sec, transform.header.stamp.nanosec) == (2, 5)
    assert transform.transform.translation.x == 12.0
    assert transform.transform.rotation.w == 1.0
    core = filled().lookup_transform_core("world", "camera", TimeMessage(sec=2, nanosec=5))
    assert core == transform


def case_full_queries() -> None:
    buffer = filled()
    query = ("world", Time(nanoseconds=3 * SECOND), "camera", Time(nanoseconds=2 * SECOND), "world")
    transform = buffer.lookup_transform_full(*query)
    assert type(transform) is g.TransformStamped
    assert abs(transform.transform.translation.x - 12.0) < 1e-6
    assert buffer.can_transform_full(*query) is True
    assert buffer.can_transform_full(*query, return_debug_tuple=True) == (True, "")
    assert buffer.can_transform("world", "turtle", Time()) is True
    verdict, why = buffer.can_transform("world", "nowhere", Time(), return_debug_tuple=True)
    assert (verdict, "nowhere" in why) == (False, True)


def case_exceptions_have_the_names_and_texts_of_tf2() -> None:
    buffer = filled()
    error = expect(drop_in.LookupException, lambda: buffer.lookup_transform("world", "nowhere", Time()))
    assert "nowhere" in str(error)
    assert isinstance(error, drop_in.TransformException)
    assert isinstance(error, tfloom.tf2.errors.LookupException)
    error = expect(
        drop_in.ExtrapolationException, lambda: buffer.lookup_transform("world", "turtle", Time(seconds=9))
    )
    assert "extrapolation into the future" in str(error)
    assert error.newest_ns == 4 * SECOND + 5
    assert str(pickle.loads(pickle.dumps(error))) == str(error)
    buffer.set_transform(stamped("other", "tree", 1, 0.0), "test")
    expect(drop_in.ConnectivityException, lambda: buffer.lookup_transform("world", "tree", Time()))
    expect(drop_in.InvalidArgumentException, lambda: buffer.lookup_transform("/world", "turtle", Time()))
    expect(drop_in.TransformException, lambda: buffer.get_latest_common_time("world", "tree"))


def case_times_are_the_real_classes() -> None:
    newest = filled().get_latest_common_time("world", "camera")
    assert type(newest) is Time
    assert newest.nanoseconds == 4 * SECOND + 5


def case_stock_messages_are_transformed() -> None:
    buffer = filled()
    kinds = [
        g.PointStamped, g.PoseStamped, g.PoseWithCovarianceStamped, g.Vector3Stamped, g.PolygonStamped,
        g.QuaternionStamped, g.TransformStamped, g.TwistStamped, g.VelocityStamped, g.WrenchStamped,
    ]  # fmt: skip
    for kind in kinds:
        message = kind()
        message.header.frame_id = "camera"
        message.header.stamp = Time(nanoseconds=SECOND + 5).to_msg()
        result = buffer.transform(message, "world")
        assert type(result) is kind, (kind, type(result))
        assert result.header.frame_id == "world"
        assert result.header.stamp == message.header.stamp
    point = g.PointStamped()
    point.header.frame_id = "camera"
    point.point.x = 1.0
    assert buffer.transform(point, "world").point.x == 15.0
    assert buffer.transform_full(point, "world", Time(), "world", new_type=g.PointStamped).point.x == 15.0
    expect(Exception, lambda: buffer.transform(Time(), "world"))


def case_clouds_are_transformed() -> None:
    import numpy as np

    data = np.arange(6, dtype=np.float32).tobytes()
    fields = [PointField(name=name, offset=4 * i, datatype=7, count=1) for i, name in enumerate("xyz")]
    cloud = PointCloud2(height=1, width=2, fields=fields, point_step=12, row_step=24, data=data)
    cloud.header.frame_id = "camera"
    moved = filled().transform(cloud, "world")
    assert type(moved) is PointCloud2
    assert np.frombuffer(bytes(moved.data), np.float32).tolist() == [14.0, 1.0, 2.0, 17.0, 4.0, 5.0]


def case_futures_are_the_real_class() -> None:
    buffer = filled()
    done = buffer.wait_for_transform_async("world", "turtle", Time())
    assert type(done) is Future
    assert done.done()
    assert type(done.result()) is g.TransformStamped
    later = buffer.wait_for_transform_async("world", "turtle", Time(seconds=6))
    assert not later.done()
    buffer.set_transform(stamped("world", "turtle", 7 * SECOND), "test")
    assert later.result().header.stamp.sec == 6
    timed = buffer.wait_for_transform_async("world", "turtle", Time(seconds=99), Duration(seconds=0.05))
    ended = threading.Event()
    timed.add_done_callback(lambda _: ended.set())
    assert ended.wait(30.0)
    assert isinstance(timed.exception(), drop_in.LookupException)
    cancelled = buffer.wait_for_transform_async("world", "turtle", Time(seconds=99))
    cancelled.cancel()
    buffer.set_transform(stamped("world", "turtle", 100 * SECOND), "test")
    assert cancelled.cancelled()
    assert not cancelled.done()


def case_a_timeout_waits_for_a_later_transform() -> None:
    buffer = filled()
    timer = threading.Timer(0.2, buffer.set_transform, [stamped("world", "turtle", 6 * SECOND), "test"])
    timer.start()
    transform = buffer.lookup_transform("world", "turtle", Time(seconds=5), Duration(seconds=30.0))
    assert transform.header.stamp.sec == 5
    begin = time.monotonic()
    query = ("world", "turtle", Time(seconds=99), Duration(seconds=0.1))
    expect(drop_in.ExtrapolationException, lambda: buffer.lookup_transform(*query))
    assert time.monotonic() - begin >= 0.09


def case_a_task_that_awaits_a_transform_is_resumed() -> None:
    with initialized():
        node = rclpy.create_node("under_test")
        buffer = filled()
        buffer.watch_clock(node)
        executor = rclpy.executors.SingleThreadedExecutor()
        executor.add_node(node)

        async def wait() -> Any:
            return await buffer.lookup_transform_async("world", "turtle", Time(seconds=5))

        task = executor.create_task(wait)
        threading.Timer(0.3, buffer.set_transform, [stamped("world", "turtle", 6 * SECOND), "test"]).start()
        executor.spin_until_future_complete(task, timeout_sec=30.0)
        assert task.done()
        assert task.result().header.stamp.sec == 5
        node.destroy_node()
        executor.shutdown()


def case_frames_are_served() -> None:
    from tf2_msgs.srv import FrameGraph

    with initialized():
        node = rclpy.create_node("under_test")
        buffer = Buffer(Duration(seconds=3.0), node)
        buffer.set_transform(stamped("world", "turtle", SECOND), "test")
        assert buffer.cache_time_ns == 3 * SECOND
        client = node.create_client(FrameGraph, "tf2_frames")
        assert client.wait_for_service(30.0)
        future = client.call_async(FrameGraph.Request())
        rclpy.spin_until_future_complete(node, future, timeout_sec=30.0)
        assert "turtle" in future.result().frame_yaml
        node.destroy_node()


def case_listeners_share_a_participant_and_end_with_their_nodes() -> None:
    with initialized():
        nodes = [rclpy.create_node(f"node_{number}") for number in range(2)]
        listeners = [TransformListener(Buffer(), node) for node in nodes]
        assert [listener.why_raw for listener in listeners] == ["", ""]
        (shared,) = sources._shared.values()
        assert shared.users == 2
        nodes[0].destroy_node()
        wait_until(lambda: shared.users == 1)
        listeners[1].unregister()
        assert not sources._shared
        listeners[1].unregister()
        nodes[1].destroy_node()


def case_spin_thread_spins_the_node() -> None:
    with initialized():
        node = rclpy.create_node("under_test")
        fired = threading.Event()
        node.create_timer(0.01, fired.set)
        listener = TransformListener(Buffer(), node, spin_thread=True)
        assert fired.wait(30.0)
        assert listener.dedicated_listener_thread.is_alive()
        rclpy.shutdown()
        listener.dedicated_listener_thread.join(30.0)
        assert not listener.dedicated_listener_thread.is_alive()


def case_listeners_end_with_their_context() -> None:
    rclpy.init()
    node = rclpy.create_node("under_test")
    buffer = Buffer(node=node)
    TransformListener(buffer, node)
    assert sources._shared
    rclpy.shutdown()
    assert not sources._shared
    assert not buffer.can_transform("a", "b", Time(), Duration(seconds=300.0))  # ends at once


def case_the_end_of_a_listener_skips_no_other_callback_of_the_context() -> None:
    """The context calls back in a loop over a list, from which the callbacks of freed objects are removed."""

    class Probe:
        def end(self) -> None:
            ended.append(self)

    ended: list[Probe] = []
    rclpy.init()
    context = rclpy.get_default_context()
    probes = []
    nodes = [rclpy.create_node(f"node_{number}") for number in range(3)]
    for node in nodes:
        TransformListener(Buffer(), node)
        probes.append(Probe())
        context.on_shutdown(probes[-1].end)
    rclpy.shutdown()
    assert ended == probes
    assert not sources._shared


def case_a_listener_lives_as_long_as_its_node() -> None:
    with initialized():
        node = rclpy.create_node("under_test")
        listener = weakref.ref(TransformListener(Buffer(), node))
        gc.collect()
        assert listener() is not None
        node.destroy_node()
        wait_until(lambda: not sources._shared)
        del node
        wait_until(lambda: [gc.collect(), listener() is None][1])  # a check may use it just now


def case_the_reasons_for_a_raw_subscription() -> None:
    import os

    from tfloom.rmw.errors import ConfigurationError, WireError

    with initialized():
        node = rclpy.create_node("under_test")

        def why(raw: bool | None = None) -> str:
            listener = TransformListener(Buffer(), node, raw=raw)
            reason = listener.why_raw
            assert bool(reason) == isinstance(listener.tf_sub, rclpy.subscription.Subscription)
            listener.unregister()
            assert not list(node.subscriptions)
            return reason

        assert not why()
        assert why(raw=True) == "it was requested"
        os.environ["TFLOOM_DROP_IN"] = "raw"
        assert why() == "it was requested"
        assert not why(raw=False)
        os.environ["TFLOOM_DROP_IN"] = "fast"
        assert "none of: auto, reader, raw" in str(expect(ConfigurationError, why))
        os.environ["TFLOOM_DROP_IN"] = "reader"
        os.environ["ROS_DISCOVERY_SERVER"] = "127.0.0.1:11811"
        assert not why()
        del os.environ["TFLOOM_DROP_IN"]
        assert "ROS_DISCOVERY_SERVER" in why()
        del os.environ["ROS_DISCOVERY_SERVER"]
        os.environ["ROS_SECURITY_ENABLE"] = "true"
        assert "ROS_SECURITY_ENABLE" in why()
        del os.environ["ROS_SECURITY_ENABLE"]
        os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "NEAR"
        assert "'NEAR'" in why()
        assert "'NEAR'" in str(expect(ConfigurationError, lambda: why(raw=False)))
        del os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"]
        os.environ["CYCLONEDDS_URI"] = "<CycloneDDS><Domain><Nonsense/></Domain></CycloneDDS>"
        assert "check CYCLONEDDS_URI" in why()
        assert "check CYCLONEDDS_URI" in str(expect(WireError, lambda: why(raw=False)))
        del os.environ["CYCLONEDDS_URI"]
        real = rclpy.utilities.get_rmw_implementation_identifier
        rclpy.utilities.get_rmw_implementation_identifier = lambda: "rmw_zenoh_cpp"
        assert why() == "rmw_zenoh_cpp is in use, whose wire tfloom does not read"
        rclpy.utilities.get_rmw_implementation_identifier = real
        node.destroy_node()


STEP = 1_000_000
"""Between the stamps of transforms that are sent in a row: so small that the buffer forgets none of them [ns]."""


class _Sent:
    """A publisher that a listener's own reader hears, and what it has sent."""

    def __init__(self, listener: TransformListener, buffer: Buffer) -> None:
        from tf2_msgs.msg import TFMessage

        self._message = TFMessage
        self._buffer = buffer
        self.node = rclpy.create_node("other")
        self._publisher = self.node.create_publisher(TFMessage, "/tf", 100)
        self.numbers: list[int] = []
        wait_until(lambda: listener.tf_sub.get_publisher_count() == 1)
        wait_until(lambda: self._publisher.get_subscription_count() == 1)
        # Each side knows of the other when the first message has arrived.
        wait_until(lambda: [self.send(), self.has_newest()][1])
        self.numbers = self.numbers[-1:]

    def send(self) -> None:
        """Send the next transform. Its x is not a linear function of its stamp, so that a missing one is detected."""
        number = self.numbers[-1] + 1 if self.numbers else 1
        self.numbers.append(number)
        transform = stamped("world", "turtle", SECOND + number * STEP, float(number**2))
        self._publisher.publish(self._message(transforms=[transform]))

    def has_newest(self) -> bool:
        return self._buffer.can_transform("world", "turtle", self._time(self.numbers[-1]))

    def lost(self) -> list[int]:
        """Return the numbers of the transforms that the buffer lacks."""
        found = [
            self._buffer.lookup_transform("world", "turtle", self._time(number)) for number in self.numbers
        ]
        return [
            number
            for number, transform in zip(self.numbers, found, strict=True)
            if abs(transform.transform.translation.x - number**2) > 0.5
        ]

    def _time(self, number: int) -> Time:
        return Time(nanoseconds=SECOND + number * STEP)


def case_no_transform_is_lost_while_a_listener_changes_to_a_subscription() -> None:
    """Some are sent before the subscription exists, while no publisher knows of it, and until the readers close."""
    with initialized():
        node = rclpy.create_node("under_test")
        buffer = Buffer(node=node)
        listener = TransformListener(buffer, node)
        sent = _Sent(listener, buffer)
        create = node.create_subscription

        def create_between(*arguments: Any, **options: Any) -> Any:
            sent.send()
            subscription = create(*arguments, **options)
            sent.send()
            return subscription

        node.create_subscription = create_between
        executor = rclpy.executors.SingleThreadedExecutor()
        executor.add_node(node)
        listener._change_to_raw("of the test")
        assert listener.why_raw == "of the test"

        def has_left() -> bool:
            sent.send()
            executor.spin_once(timeout_sec=0.01)
            return not sources._shared

        wait_until(has_left)
        sent.send()
        wait_until(lambda: [executor.spin_once(timeout_sec=0.01), sent.has_newest()][1])
        assert sent.lost() == []
        executor.shutdown()
        node.destroy_node()
        sent.node.destroy_node()


def case_a_listener_that_can_not_subscribe_keeps_its_readers() -> None:
    with initialized():
        node = rclpy.create_node("under_test")
        buffer = Buffer(node=node)
        listener = TransformListener(buffer, node)
        sent = _Sent(listener, buffer)
        create = node.create_subscription

        def fail_for_static(message: Any, topic: str, *arguments: Any, **options: Any) -> Any:
            if topic == "/tf_static":
                raise RuntimeError("no more subscriptions")
            return create(message, topic, *arguments, **options)

        node.create_subscription = fail_for_static
        expect(RuntimeError, lambda: listener._change_to_raw("of the test"))
        assert not listener.why_raw
        assert not list(node.subscriptions)
        sent.send()
        wait_until(sent.has_newest)
        listener.unregister()
        assert not sources._shared
        node.destroy_node()
        sent.node.destroy_node()


def case_a_listener_ends_in_the_middle_of_its_change() -> None:
    """The readers that wait for the subscription's publishers are closed with it."""
    with initialized():
        for end in (TransformListener.unregister, lambda listener: listener.node.destroy_node()):
            node = rclpy.create_node("under_test")
            buffer = Buffer(node=node)
            listener = TransformListener(buffer, node)
            sent = _Sent(listener, buffer)
            listener._change_to_raw("of the test")
            assert sources._shared
            end(listener)
            wait_until(lambda: not sources._shared)
            sent.node.destroy_node()
            node.destroy_node()


def case_without_tf2_msgs_the_reader_works_and_a_subscription_is_refused() -> None:
    """As with the wheels of rclpy on PyPI, which have no tf2_msgs."""
    origin = ros_guard._origin
    ros_guard._origin = lambda name: None if name == "tf2_msgs" else origin(name)
    real_ros.find.cache_clear()
    try:
        with initialized():
            node = rclpy.create_node("under_test")
            buffer = Buffer(node=node)
            assert buffer.srv is None
            listener = TransformListener(buffer, node)
            assert not listener.why_raw
            listener.unregister()
            error = expect(ImportError, lambda: TransformListener(buffer, node, raw=True))
            text = "'tf2_msgs' is not installed for the ROS 2 that 'rclpy' comes from"
            assert str(error) == f"{text}; a raw subscription needs it: it was requested"
            expect(ImportError, lambda: TransformListener(object(), node))
            assert not sources._shared
            node.destroy_node()
    finally:
        ros_guard._origin = origin
        real_ros.find.cache_clear()


def case_qos_is_that_of_the_profile() -> None:
    from rclpy.qos import HistoryPolicy, LivelinessPolicy, ReliabilityPolicy

    from tfloom.rmw import qos as wire

    profile = QoSProfile(
        depth=3,
        history=HistoryPolicy.KEEP_LAST,
        reliability=ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL,
        deadline=Duration(seconds=2),
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
        liveliness_lease_duration=Duration(nanoseconds=5),
    )
    assert sources.wire_qos(profile).resolved() == wire.QoS(
        reliability=wire.ReliabilityPolicy.BEST_EFFORT,
        durability=wire.DurabilityPolicy.TRANSIENT_LOCAL,
        depth=3,
        deadline_ns=2 * SECOND,
        liveliness=wire.LivelinessPolicy.MANUAL_BY_TOPIC,
        liveliness_lease_ns=5,
    )
    assert sources.wire_qos(QoSProfile(depth=7)).resolved() == wire.QoS(depth=7)
    assert sources.wire_qos(7).resolved() == wire.QoS(depth=7)
    expect(ValueError, lambda: sources.wire_qos(-1))


def case_overrides_get_the_real_messages() -> None:
    class Listener(TransformListener):
        def callback(self, data: Any) -> None:
            received.append(data)
            super().callback(data)

    from tf2_msgs.msg import TFMessage

    received: list[Any] = []
    with initialized():
        node = rclpy.create_node("under_test")
        buffer = Buffer()
        listener = Listener(buffer, node)
        publisher = node.create_publisher(TFMessage, "/tf", 10)
        while not received:
            publisher.publish(TFMessage(transforms=[stamped("world", "turtle", SECOND, 3.0)]))
            rclpy.spin_once(node, timeout_sec=0.05)
        assert type(received[0]) is TFMessage
        assert buffer.lookup_transform("world", "turtle", Time()).transform.translation.x == 3.0
        assert not sources._shared
        listener.unregister()
        node.destroy_node()


def case_another_buffer_receives_what_comes_after_its_assignment() -> None:
    from tf2_msgs.msg import TFMessage

    with initialized():
        node = rclpy.create_node("under_test")
        publisher = node.create_publisher(TFMessage, "/tf", 10)
        for raw in (False, True):
            first, second = Buffer(), Buffer()
            listener = TransformListener(first, node, raw=raw)
            for name, buffer in (("before", first), ("after", second)):
                listener.buffer = buffer
                while not buffer.can_transform("world", name, Time()):
                    publisher.publish(TFMessage(transforms=[stamped("world", name, SECOND)]))
                    rclpy.spin_once(node, timeout_sec=0.05)
            assert listener.buffer is second
            assert not first.has_frame("after")
            expect(TypeError, lambda listener=listener: setattr(listener, "buffer", object()))
            listener.unregister()
        node.destroy_node()


def case_a_buffer_of_another_kind_gets_the_real_messages() -> None:
    from tf2_msgs.msg import TFMessage

    class Other:
        def __init__(self) -> None:
            self.got: list[tuple[Any, str, bool]] = []

        def set_transform(self, transform: Any, authority: str) -> None:
            self.got.append((transform, authority, False))

        def set_transform_static(self, transform: Any, authority: str) -> None:
            self.got.append((transform, authority, True))

    with initialized():
        node = rclpy.create_node("under_test")
        buffer = Other()
        StaticTransformListener(buffer, node, tf_static_topic="/latched")
        qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        message = stamped("world", "turtle", SECOND)
        node.create_publisher(TFMessage, "/latched", qos).publish(TFMessage(transforms=[message]))
        while not buffer.got:
            rclpy.spin_once(node, timeout_sec=0.05)
        assert buffer.got == [(message, "default_authority", True)]
        assert not sources._shared
        node.destroy_node()


def case_the_reader_belongs_to_a_hidden_node() -> None:
    with initialized():
        node = rclpy.create_node("under_test", namespace="/robot")
        TransformListener(Buffer(), node)

        def readers() -> set[tuple[str, str]]:
            infos = node.get_subscriptions_info_by_topic("/tf")
            return {(info.node_namespace, info.node_name) for info in infos}

        wait_until(lambda: readers() == {("/robot", "_tf_listener_of_under_test")})
        assert ("_tf_listener_of_under_test", "/robot") in node.get_node_names_and_namespaces()
        node.destroy_node()


def case_simulated_time() -> None:
    from rcl_interfaces.msg import Log
    from rosgraph_msgs.msg import Clock
    from tf2_msgs.msg import TFMessage

    with initialized():
        other = rclpy.create_node("clock")
        clock, tf = other.create_publisher(Clock, "/clock", 10), other.create_publisher(TFMessage, "/tf", 10)
        node = rclpy.create_node(
            "under_test", parameter_overrides=[rclpy.Parameter("use_sim_time", value=True)]
        )
        buffer = Buffer(node=node)
        TransformListener(buffer, node)
        logged: list[str] = []
        other.create_subscription(Log, "/rosout", lambda log: logged.append(log.msg), 100)
        wait_until(lambda: other.count_publishers("/rosout") >= 2)

        def set_clock(seconds: int) -> None:
            while node.get_clock().now().nanoseconds != seconds * SECOND:
                clock.publish(Clock(clock=TimeMessage(sec=seconds)))
                rclpy.spin_once(node, timeout_sec=0.05)

        def send(seconds: int) -> None:
            while not buffer.can_transform("world", "turtle", Time(seconds=seconds)):
                tf.publish(TFMessage(transforms=[stamped("world", "turtle", seconds * SECOND)]))
                time.sleep(0.01)

        set_clock(100)
        send(100)
        tf.publish(
            TFMessage(transforms=[stamped("world", "turtle", 5000 * SECOND)])
        )  # held: far ahead of now
        tf.publish(TFMessage(transforms=[stamped("world", "marker", 100 * SECOND)]))
        wait_until(lambda: buffer.can_transform("world", "marker", Time(seconds=100)))
        assert buffer.get_latest_common_time("world", "turtle").nanoseconds == 100 * SECOND
        # The warning comes by another thread, and only while its node is there.
        while not any("is stamped" in text for text in logged):
            rclpy.spin_once(other, timeout_sec=0.05)
        set_clock(50)
        assert not buffer.can_transform("world", "turtle", Time(seconds=100))  # cleared
        send(50)
        assert buffer.clock is node.get_clock()
        node.destroy_node()
        other.destroy_node()


def wait_until(condition: Callable[[], object]) -> None:
    end = time.monotonic() + 30.0
    while not condition():
        assert time.monotonic() < end, inspect.getsource(condition)
        time.sleep(0.01)


def main() -> None:
    for name, case in list(globals().items()):
        if name.startswith("case_") and (len(sys.argv) == 1 or name in sys.argv):
            try:
                case()
            except BaseException:  # noqa: BLE001, the test shows it
                print(f"{name}: failed\n{traceback.format_exc()}", flush=True)
                rclpy.try_shutdown()
            else:
                print(f"{name}: passed", flush=True)
    print("end", flush=True)


if __name__ == "__main__":
    sys.exit(main())
