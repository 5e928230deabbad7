"""Every kind of callback above rclpy: of transforms, filters, diagnostics and markers. See `node_rows`."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

import pytest
from tests.conftest import wait_until
from tests.faults.conftest import Fails, Injected, World
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.diagnostic_msgs.msg import DiagnosticArray
from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.interfaces.visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerFeedback,
    InteractiveMarkerUpdate,
)
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.tf2_ros import message_filters
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.buffer_interface import TransformRegistration
from tfloom.tf2_ros.input_aligner import InputAligner
from tfloom.tf2_ros.message_filter import MessageFilter
from tfloom.tf2_ros.transform_listener import TransformListener
from tfloom_sensing.diagnostic_tasks import CompositeDiagnosticTask, FunctionDiagnosticTask
from tfloom_sensing.diagnostic_updater import Updater
from tfloom_sensing.interactive_marker_server import InteractiveMarkerServer
from tfloom_sensing.menu_handler import MenuHandler

Row = Callable[[World], list[Exception]]


def _others() -> Fails:
    """Return a callback that does not fail."""
    others = Fails()
    others.calls.append(())
    return others


def _point(number: int, frame_id: str = "base") -> PointStamped:
    point = PointStamped()
    point.header.stamp.sec, point.header.frame_id = number, frame_id
    return point


# Transforms


def transform_future(world: World) -> list[Exception]:
    """A done callback raises on the thread that inserts the transform, which prints it; the transforms are stored."""
    buffer = world.watch(Buffer())
    fails, others = Fails(), _others()
    for callback in (fails, others):
        buffer.wait_for_transform_async("map", "base", Time(seconds=1)).add_done_callback(callback)
    buffer.set_transform(transform_stamped("map", "base", SECOND), "test")
    assert (fails.was_called(1), others.was_called(2)) == (True, True)
    assert buffer.can_transform("map", "base", Time(seconds=1))
    return []


def transform_future_after_its_timeout(world: World) -> list[Exception]:
    buffer = world.watch(Buffer())
    fails, others = Fails(), _others()
    for callback in (fails, others):
        future = buffer.wait_for_transform_async("map", "base", Time(seconds=1), Duration(seconds=0.01))
        future.add_done_callback(callback)
    wait_until(lambda: fails.was_called(1) and others.was_called(2))
    return []


def transformable_request(world: World) -> list[Exception]:
    """The exception is reported as unraisable, and the other requests are answered."""
    buffer = Buffer()
    fails, others = Fails(), _others()
    for callback in (fails, others):
        buffer.add_request("map", "base", SECOND, callback)
    buffer.set_transform(transform_stamped("map", "base", SECOND), "test")
    assert (fails.was_called(1), others.was_called(2)) == (True, True)
    assert world.reported == [fails.error]
    world.reported.clear()
    return []


class _Overridden(TransformListener):
    """A listener whose own callback fails once."""

    def __init__(self, fails: Fails, *args: Any, **options: Any) -> None:
        self.fails = fails
        super().__init__(*args, **options)

    def callback(self, data: TFMessage) -> None:
        self.fails(data)
        super().callback(data)


def _send_until_called(world: World, fails: Fails) -> None:
    publisher = world.node.create_publisher(TFMessage, "/tf", 10)
    wait_until(publisher.get_subscription_count)

    def is_called() -> bool:
        publisher.publish(TFMessage(transforms=[transform_stamped("map", "base", SECOND)]))
        return fails.was_called(2)

    wait_until(is_called, what="the transform after the failure")


def transform_listener(world: World) -> list[Exception]:
    fails, buffer = Fails(), Buffer()
    listener = _Overridden(fails, buffer, world.node)
    _send_until_called(world, fails)
    wait_until(lambda: buffer.can_transform("map", "base", Time(seconds=1)))
    listener.unregister()
    return [fails.error]


def transform_listener_with_a_thread(world: World) -> list[Exception]:
    """The thread of the listener goes on after the exception, which it reports."""
    fails, buffer = Fails(), Buffer()
    listener = _Overridden(fails, buffer, spin_thread=True, node=_second_node(world))
    _send_until_called(world, fails)
    wait_until(lambda: buffer.can_transform("map", "base", Time(seconds=1)))
    assert listener.dedicated_listener_thread is not None
    assert listener.dedicated_listener_thread.is_alive()
    assert world.reported == [fails.error]
    world.reported.clear()
    assert listener.executor is not None
    listener.executor.shutdown()
    listener.dedicated_listener_thread.join(30)
    listener.unregister()
    listener.node.destroy_node()
    return []


def _second_node(world: World) -> Any:
    return type(world.node)("listening", context=world.context)


def transform_registration(world: World) -> list[Exception]:
    """A program's own conversion raises to the caller of `transform`."""

    class Thing:
        header = _point(1).header

    fails = Fails(lambda thing, _: thing)
    TransformRegistration().add(Thing, fails)
    buffer = world.watch(Buffer())
    buffer.set_transform(transform_stamped("map", "base", SECOND), "test")
    with pytest.raises(Injected):
        buffer.transform(Thing(), "map")
    assert isinstance(buffer.transform(Thing(), "map"), Thing)
    return []


# Filters


def _filtered(world: World, make: Callable[[Any], Any], count: int = 1) -> list[Exception]:
    """Let the first of two callbacks of a filter raise; both receive every message, and no lock is held."""
    fails, others = Fails(), _others()
    sources = [message_filters.SimpleFilter() for _ in range(count)]
    under_test = world.watch(make(sources))
    under_test.registerCallback(fails)
    under_test.registerCallback(others)
    for number in (1, 2):
        message = _point(number)
        for source in sources[:-1]:
            source.signalMessage(message)
        if number == 1:
            with pytest.raises(Injected):
                sources[-1].signalMessage(message)
        else:
            sources[-1].signalMessage(message)
        assert (len(fails.calls), len(others.calls)) == (number, number + 1)
    return []


def filter_itself(world: World) -> list[Exception]:
    return _filtered(world, lambda sources: sources[0])


def filter_cache(world: World) -> list[Exception]:
    return _filtered(world, lambda sources: message_filters.Cache(sources[0], 5))


def filter_chain(world: World) -> list[Exception]:
    return _filtered(world, lambda sources: message_filters.Chain(sources[0]))


def filter_aligner(world: World) -> list[Exception]:
    """The first of two callbacks of an input raises to the caller of `dispatchMessages`; both receive every message."""
    fails, others = Fails(), _others()
    source = message_filters.SimpleFilter()
    aligner = world.watch(InputAligner(Duration(seconds=1), [source]))
    aligner.registerCallback(0, fails)
    aligner.registerCallback(0, others)
    for number in (1, 2):
        source.signalMessage(_point(number))
        if number == 1:
            with pytest.raises(Injected):
                aligner.dispatchMessages()
        else:
            aligner.dispatchMessages()
        assert (len(fails.calls), len(others.calls)) == (number, number + 1)
    return []


def filter_time(world: World) -> list[Exception]:
    return _filtered(world, lambda sources: message_filters.TimeSynchronizer(sources, 5), 2)


def filter_approximate_time(world: World) -> list[Exception]:
    return _filtered(world, lambda sources: message_filters.ApproximateTimeSynchronizer(sources, 5, 0.5), 2)


def filter_subscriber(world: World) -> list[Exception]:
    fails, others = Fails(), _others()
    under_test = message_filters.Subscriber(world.node, PointStamped, "points")
    under_test.registerCallback(fails)
    under_test.registerCallback(others)
    publisher = world.node.create_publisher(PointStamped, "points", 10)
    wait_until(lambda: publisher.get_subscription_count() and under_test.sub.get_publisher_count())
    for number in range(3):
        publisher.publish(_point(number))
    wait_until(lambda: fails.was_called(3) and others.was_called(4))
    return [fails.error]


def filter_of_transforms(world: World) -> list[Exception]:
    """Both messages become transformable at once; the second is passed on, too."""
    fails, buffer = Fails(), Buffer()
    waiting = world.watch(MessageFilter(None, buffer, "map", 10, world.node))
    waiting.registerCallback(fails)
    for number in (1, 2):
        waiting.add(_point(number))
    for number in (1, 2):
        buffer.set_transform(transform_stamped("map", "base", number * SECOND), "test")
    wait_until(lambda: fails.was_called(2), what="the message after the failure")
    return [fails.error]


def filter_of_transforms_with_calls_waiting(world: World) -> list[Exception]:
    """The callbacks for two messages wait when the first one raises; the second is not left until a third comes."""
    entered, gate = threading.Event(), threading.Event()

    def hold() -> None:
        entered.set()
        gate.wait(30)

    fails, buffer = Fails(), Buffer()
    waiting = world.watch(MessageFilter(None, buffer, "map", 10, world.node))
    waiting.registerCallback(fails)
    assert waiting._guard is not None
    held = world.node.create_guard_condition(hold, callback_group=waiting._guard.callback_group)
    held.trigger()
    assert entered.wait(30)
    for number in (1, 2):
        waiting.add(_point(number))
        buffer.set_transform(transform_stamped("map", "base", number * SECOND), "test")
    gate.set()
    wait_until(lambda: fails.was_called(2), what="the message after the failure")
    return [fails.error]


def filter_failure(world: World) -> list[Exception]:
    fails, others = Fails(), _others()
    waiting = world.watch(MessageFilter(None, Buffer(), "map", 10, world.node))
    waiting.registerFailureCallback(fails)
    waiting.registerFailureCallback(others)
    for number in (1, 2):
        waiting.add(_point(number, frame_id=""))
    wait_until(lambda: fails.was_called(2) and others.was_called(3), what="the other callback")
    return [fails.error]


def filter_failure_without_a_node(world: World) -> list[Exception]:
    fails, others = Fails(), _others()
    waiting = world.watch(MessageFilter(None, Buffer(), "map", 10))
    waiting.registerFailureCallback(fails)
    waiting.registerFailureCallback(others)
    with pytest.raises(Injected):
        waiting.add(_point(1, frame_id=""))
    waiting.add(_point(2, frame_id=""))
    assert (len(fails.calls), len(others.calls)) == (2, 3)
    return []


# Diagnostics and markers


def _updates(world: World, add: Callable[[Updater, Fails], None]) -> list[Exception]:
    """Let one of two tasks raise: both are published, the one with its exception."""
    arrived: list[dict[str, str]] = []
    world.node.create_subscription(
        DiagnosticArray,
        "/diagnostics",
        lambda message: arrived.append({status.name: status.message for status in message.status}),
        10,
    )
    updater = world.watch(Updater(world.node, 0.01))
    fails = Fails(lambda status: status)
    with updater.lock:  # so that no update comes between
        add(updater, fails)
        updater.add("sound", lambda status: (status.summary(b"\x00", "fine"), status)[1])

    def both() -> list[dict[str, str]]:
        return [names for names in arrived if names.get("under_test: sound") == "fine"]

    wait_until(lambda: len(both()) > 1, what="an update after the failure")
    assert "Injected" in both()[0]["under_test: failing"]
    return [fails.error]


def diagnostic_task(world: World) -> list[Exception]:
    return _updates(world, lambda updater, fails: updater.add("failing", fails))


def diagnostic_function_task(world: World) -> list[Exception]:
    return _updates(world, lambda updater, fails: updater.add(FunctionDiagnosticTask("failing", fails)))


def diagnostic_composite_task(world: World) -> list[Exception]:
    def add(updater: Updater, fails: Fails) -> None:
        composite = CompositeDiagnosticTask("failing")
        composite.addTask(FunctionDiagnosticTask("part", fails))
        updater.add(composite)

    return _updates(world, add)


def _marker_server(world: World) -> tuple[InteractiveMarkerServer, list[InteractiveMarkerUpdate]]:
    updates: list[InteractiveMarkerUpdate] = []
    server = world.watch(InteractiveMarkerServer(world.node, "markers"))
    world.node.create_subscription(InteractiveMarkerUpdate, "markers/update", updates.append, 10)
    return server, updates


def _feedback(event_type: int, x: float = 0.0, menu_entry_id: int = 0) -> InteractiveMarkerFeedback:
    feedback = InteractiveMarkerFeedback(
        marker_name="cube", client_id="me", event_type=event_type, menu_entry_id=menu_entry_id
    )
    feedback.pose.position.x = x
    return feedback


def marker_feedback(world: World) -> list[Exception]:
    """The new pose is published, although the callback for it raises."""
    server, updates = _marker_server(world)
    fails = Fails()
    server.insert(InteractiveMarker(name="cube"), feedback_callback=fails)
    server.applyChanges()
    publisher = world.node.create_publisher(InteractiveMarkerFeedback, "markers/feedback", 10)
    wait_until(lambda: publisher.get_subscription_count() and server.feedback_sub.get_publisher_count())
    for number in (1.0, 2.0):
        publisher.publish(_feedback(InteractiveMarkerFeedback.POSE_UPDATE, number))
        wait_until(
            lambda number=number: any(
                pose.pose.position.x == number for update in updates for pose in update.poses
            ),
            what="the pose",
        )
    server.shutdown()
    return [fails.error]


def marker_menu(world: World) -> list[Exception]:
    server, _ = _marker_server(world)
    fails, menu = Fails(), MenuHandler()
    server.insert(InteractiveMarker(name="cube"))
    entry = menu.insert("entry", callback=fails)
    menu.apply(server, "cube")
    server.applyChanges()
    publisher = world.node.create_publisher(InteractiveMarkerFeedback, "markers/feedback", 10)
    wait_until(lambda: publisher.get_subscription_count() and server.feedback_sub.get_publisher_count())
    for number in (1, 2):
        publisher.publish(_feedback(InteractiveMarkerFeedback.MENU_SELECT, menu_entry_id=entry or 0))
        wait_until(lambda number=number: fails.was_called(number))
    server.shutdown()
    return [fails.error]


ROWS: dict[str, Row] = {
    name: row
    for name, row in list(globals().items())
    if getattr(row, "__module__", None) == __name__ and not name.startswith("_") and callable(row)
}
