"""Waitables of rclpy programs, in every executor."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.node import implementation as _rclpy
from tfloom.node.context.context import Context
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from tfloom.node.executing.event_types import QoSPublisherEventType
from tfloom.node.executing.events_executor import EventsExecutor
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.executing.waitable import NumberOfEntities, Waitable
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.exceptions import InvalidHandle, TimerCancelledError
from tfloom.rmw.events import Matched

MakeNode = Callable[..., Node]


class Collects(Waitable):
    """Waits for one item of one kind, latches it, and keeps the data taken."""

    def __init__(self, kind: str, waited: Any, take: Callable[[], Any], group: Any = None) -> None:
        super().__init__(group or ReentrantCallbackGroup())
        self.kind = kind
        self.waited = waited
        self.take = take
        self.index: int | None = None
        self.latched = False
        self.collected: list[Any] = []
        self.future: Future[Any] = Future()
        self.add_future(self.future)

    def is_ready(self, wait_set: Any) -> bool:
        if wait_set.is_ready(self.kind, self.index):
            self.latched = True
        return self.latched

    def take_data(self) -> Any:
        self.latched = False
        return self.take()

    async def execute(self, taken_data: Any) -> None:
        self.collected.append(taken_data)
        if not self.future.done():
            self.future.set_result(taken_data)

    def get_num_entities(self) -> NumberOfEntities:
        return NumberOfEntities(num_gcs=1)

    def add_to_wait_set(self, wait_set: Any) -> None:
        self.index = getattr(wait_set, f"add_{self.kind}")(self.waited)


@pytest.fixture(params=[SingleThreadedExecutor, MultiThreadedExecutor, EventsExecutor])
def executor(request: pytest.FixtureRequest, context: Context) -> Iterator[Executor]:
    with request.param(context=context) as executor:
        yield executor


def test_a_guard_condition_runs_a_waitable_from_another_thread(node: Node, executor: Executor) -> None:
    guard = _rclpy.GuardCondition(node.context.handle)
    waitable = Collects("guard_condition", guard, lambda: "triggered")
    node.add_waitable(waitable)
    executor.add_node(node)
    assert list(node.waitables) == [waitable]
    executor.spin_once(timeout_sec=0)
    assert waitable.collected == []
    threading.Timer(0.01, guard.trigger_guard_condition).start()
    executor.spin_until_future_complete(waitable.future, timeout_sec=10)
    assert waitable.collected == ["triggered"]
    executor.spin_once(timeout_sec=0.01)
    assert waitable.collected == ["triggered"]


def test_a_waitable_added_while_it_spins_runs_in_spin_itself(node: Node, executor: Executor) -> None:
    executor.add_node(node)
    guard = node.create_guard_condition(lambda: None).handle
    own = _rclpy.GuardCondition(node.context)
    waitable = Collects("guard_condition", own, lambda: 1)
    waitable.future.add_done_callback(lambda _: executor.shutdown(0))

    def add() -> None:
        timer.cancel()
        node.add_waitable(waitable)
        guard.trigger_guard_condition()
        own.trigger()

    timer = node.create_timer(0.0, add)
    executor.spin()
    assert waitable.collected == [1]


def test_trigger_before_the_waitable_was_added_runs_it(node: Node, executor: Executor) -> None:
    guard = _rclpy.GuardCondition(node.context)
    guard.trigger_guard_condition()
    waitable = Collects("guard_condition", guard, lambda: 1)
    executor.add_node(node)
    node.add_waitable(waitable)
    executor.spin_until_future_complete(waitable.future, timeout_sec=10)
    assert waitable.collected == [1]


def test_waitable_takes_messages_of_its_subscription(node: Node, executor: Executor) -> None:
    profile = QoSProfile(depth=10)
    subscription = _rclpy.Subscription(node.handle, Int32, "numbers", profile.get_c_qos_profile())
    group = MutuallyExclusiveCallbackGroup()  # keeps the order also on several threads
    waitable = Collects("subscription", subscription, lambda: subscription.take_message(Int32, False), group)
    node.add_waitable(waitable)
    executor.add_node(node)
    publisher = node.create_publisher(Int32, "numbers", 10)
    for number in range(3):
        publisher.publish(Int32(data=number))
    end = time.monotonic() + 10
    while len(waitable.collected) < 3 and time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)
    assert [message.data for message, _ in waitable.collected] == [0, 1, 2]
    assert all(info["source_timestamp"] > 0 for _, info in waitable.collected)
    publisher.publish(Int32(data=7))
    raw, _ = subscription.take_message(Int32, True)
    assert raw[:4] == bytes([0, 1, 0, 0])
    assert subscription.take_message(Int32, False) is None
    node.destroy_node()
    with pytest.raises(_rclpy.InvalidHandle):
        subscription.take_message(Int32, False)


def test_call_between_two_waitables(make_node: MakeNode, executor: Executor) -> None:
    node = make_node()
    profile = QoSProfile(depth=10)
    service = _rclpy.Service(node.handle, AddTwoInts, "add", profile)
    client = _rclpy.Client(node.handle, AddTwoInts, "add", profile)
    serving = Collects("service", service, lambda: service.service_take_request(AddTwoInts.Request))
    calling = Collects("client", client, lambda: client.take_response(AddTwoInts.Response))

    def answer(future: Future[Any]) -> None:
        request, header = future.result()
        service.service_send_response(AddTwoInts.Response(sum=request.a + request.b), header)

    serving.future.add_done_callback(answer)
    node.add_waitable(serving)
    node.add_waitable(calling)
    executor.add_node(node)
    assert client.service_server_is_available()
    number = client.send_request(AddTwoInts.Request(a=40, b=2))
    executor.spin_until_future_complete(calling.future, timeout_sec=10)
    header, response = calling.future.result()
    assert response.sum == 42
    assert header.request_id.sequence_number == number
    assert client.take_response(AddTwoInts.Response) == (None, None)


def test_a_timer_in_a_waitable_is_called_once_a_period(node: Node, executor: Executor) -> None:
    start = time.monotonic()
    timer = _rclpy.Timer(node.get_clock().handle, node.context.handle, 10_000_000)
    waitable = Collects("timer", timer, timer.call_timer)
    node.add_waitable(waitable)
    executor.add_node(node)
    while len(waitable.collected) < 3:
        executor.spin_once(timeout_sec=1)
        assert time.monotonic() < start + 10
    assert time.monotonic() - start > 0.02
    timer.cancel_timer()
    with pytest.raises(TimerCancelledError):
        timer.call_timer()


def test_waitable_without_items_is_checked_at_each_wake(node: Node, executor: Executor) -> None:
    class Queue(Waitable):
        """Has no items in the wait set."""

        def __init__(self) -> None:
            super().__init__(MutuallyExclusiveCallbackGroup())
            self.waiting: list[int] = []
            self.ran: list[int] = []
            self.done: Future[None] = Future()

        def is_ready(self, wait_set: Any) -> bool:
            return bool(self.waiting)

        def take_data(self) -> int:
            return self.waiting.pop(0)

        def execute(self, taken_data: int) -> None:  # type: ignore[override]
            self.ran.append(taken_data)
            if not self.waiting:
                self.done.set_result(None)

        def get_num_entities(self) -> NumberOfEntities:
            return NumberOfEntities()

        def add_to_wait_set(self, wait_set: Any) -> None:
            pass

    waitable = Queue()
    node.add_waitable(waitable)
    executor.add_node(node)
    executor.spin_once(timeout_sec=0)

    def fill() -> None:
        waitable.waiting += [1, 2, 3]
        executor.wake()

    threading.Timer(0.01, fill).start()
    executor.spin_until_future_complete(waitable.done, timeout_sec=10)
    assert waitable.ran == [1, 2, 3]
    executor.remove_node(node)
    assert executor._polled == []


def test_removed_waitable_does_not_run(node: Node, executor: Executor) -> None:
    guard = _rclpy.GuardCondition(node.context)
    waitable = Collects("guard_condition", guard, lambda: 1)
    node.add_waitable(waitable)
    executor.add_node(node)
    node.remove_waitable(waitable)
    guard.trigger_guard_condition()
    executor.spin_once(timeout_sec=0.01)
    assert waitable.collected == []
    assert list(node.waitables) == []
    with pytest.raises(ValueError, match="not a waitable of this node"):
        node.remove_waitable(waitable)


@pytest.mark.timing
def test_waiting_waitable_uses_no_cpu_time(node: Node, executor: Executor) -> None:
    guard = _rclpy.GuardCondition(node.context)
    node.add_waitable(Collects("guard_condition", guard, lambda: 1))
    executor.add_node(node)
    executor.spin_once(timeout_sec=0)
    before = time.process_time()
    executor.spin_until_future_complete(Future(), timeout_sec=0.3)
    assert time.process_time() - before < 0.05


def test_wait_set_rejects_unknown_items(node: Node) -> None:
    wait_set = _rclpy.WaitSet()
    with pytest.raises(TypeError, match="a wait set can't wait for 'x'"):
        wait_set.add_subscription("x")
    with pytest.raises(ValueError, match="'topic' is not a kind of entity; known are subscription, guard_"):
        wait_set.is_ready("topic", 0)
    with pytest.raises(IndexError, match="there is no timer 0 in the wait set"):
        wait_set.is_ready("timer", 0)
    guard = _rclpy.GuardCondition(node.context)
    wait_set.add_guard_condition(guard)
    guard.trigger()
    wait_set.update()
    assert wait_set.get_ready_entities("guard_condition") == [guard]


def test_numbers_of_entities_are_added() -> None:
    total = NumberOfEntities(1, 2, 3, 4, 5, 6) + NumberOfEntities(num_subs=1, num_events=1)
    total += NumberOfEntities(num_timers=2)
    assert (total.num_subscriptions, total.num_guard_conditions, total.num_timers) == (2, 2, 5)
    assert (total.num_clients, total.num_services, total.num_events) == (4, 5, 7)
    assert "num_timers=5" in repr(total)


# Wait sets of programs


def test_a_program_waits_for_events_with_a_wait_set_of_its_own(node: Node) -> None:
    publisher = node.create_publisher(Int32, "numbers", 1)
    with node.context.handle:
        wait_set = _rclpy.WaitSet(0, 0, 0, 0, 0, 1, node.context.handle)
    with publisher.handle:
        event = _rclpy.EventHandle(publisher.handle, QoSPublisherEventType.RCL_PUBLISHER_MATCHED)
    with event:
        index = wait_set.add_event(event)
    wait_set.wait(0)
    assert not wait_set.is_ready("event", index)
    assert event.take_event() == Matched(0, 0, 0, 0)
    node.create_subscription(Int32, "numbers", print, 1)
    wait_set.wait(-1)
    assert wait_set.is_ready("event", index)
    assert event.take_event() == Matched(1, 1, 1, 1)
    wait_set.wait(1000)
    assert not wait_set.is_ready("event", index)
    wait_set.clear_entities()
    with pytest.raises(IndexError):
        wait_set.is_ready("event", index)
    event.destroy_when_not_in_use()
    with pytest.raises(InvalidHandle, match="was destroyed"), event:
        pass


def test_a_wait_of_a_program_ends_with_a_timer_or_another_threads_trigger(node: Node) -> None:
    wait_set = _rclpy.WaitSet()
    timer = _rclpy.Timer(node.get_clock(), node.context, 1_000_000, True)
    timer_index = wait_set.add_timer(timer)
    wait_set.wait(-1)
    assert wait_set.is_ready("timer", timer_index)
    timer.cancel_timer()
    guard = _rclpy.GuardCondition(node.context)
    guard_index = wait_set.add_guard_condition(guard)
    wait_set.wait(1_000_000)
    assert not wait_set.is_ready("timer", timer_index)
    assert not wait_set.is_ready("guard_condition", guard_index)
    threading.Timer(0.01, guard.trigger).start()
    wait_set.wait(-1)
    assert wait_set.is_ready("guard_condition", guard_index)


def test_an_event_that_the_wire_does_not_report_is_an_error(node: Node) -> None:
    publisher = node.create_publisher(Int32, "numbers", 1)
    for kind in (
        QoSPublisherEventType.RCL_PUBLISHER_INCOMPATIBLE_TYPE,
        QoSPublisherEventType.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED,  # not on the wire within a process
    ):
        with pytest.raises(_rclpy.UnsupportedEventTypeError):
            _rclpy.EventHandle(publisher.handle, kind)
    handle = publisher.handle
    node.destroy_publisher(publisher)
    with pytest.raises(InvalidHandle, match="was destroyed"):
        _rclpy.EventHandle(handle, QoSPublisherEventType.RCL_PUBLISHER_MATCHED)
