"""Operations of programs while an executor spins: on both wires, with every executor."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.node import client_library as rclpy
from tfloom.node.context.context import Context
from tfloom.node.context.utilities import own_defaults
from tfloom.node.executing.callback_groups import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)
from tfloom.node.executing.events_executor import EventsExecutor
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.node.values.exceptions import (
    ExternalShutdownException,
    InvalidHandle,
    RCLError,
    ROSInterruptException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
)

EXECUTORS = [SingleThreadedExecutor, MultiThreadedExecutor, EventsExecutor]
LATCHED = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
"""What is sent before the other end is heard of comes all the same."""


@pytest.fixture
def context(context_on_each_wire: Context) -> Context:
    return context_on_each_wire


@pytest.fixture(params=EXECUTORS)
def executor(request: pytest.FixtureRequest, context: Context) -> Iterator[Executor]:
    with request.param(context=context) as executor:
        yield executor


class Spinning:
    """A thread in `executor.spin()`, or in another of its methods, and the exception that ended it."""

    def __init__(self, executor: Executor, method: str = "spin", *arguments: object) -> None:
        self.error: BaseException | None = None
        self.thread = threading.Thread(target=self._spin, args=(getattr(executor, method), *arguments))
        self.thread.start()

    def _spin(self, spin: Callable[..., None], *arguments: object) -> None:
        try:
            spin(*arguments)
        except BaseException as error:  # noqa: BLE001
            self.error = error

    def join(self) -> BaseException | None:
        self.thread.join(20)
        assert not self.thread.is_alive()
        return self.error


def numbers_into(node: Node, callback: Callable[[Int32], Any], count: int) -> None:
    """Publish `count` messages to `callback`."""
    publisher = node.create_publisher(Int32, "numbers", LATCHED)
    node.create_subscription(Int32, "numbers", callback, LATCHED)
    for number in range(count):
        publisher.publish(Int32(data=number))


def test_messages_arrive_in_order_and_executor_shutdown_ends_the_spin(node: Node, executor: Executor) -> None:
    heard: list[int] = []
    numbers_into(node, lambda msg: heard.append(msg.data), 50)
    executor.add_node(node)
    spinning = Spinning(executor)
    wait_until(lambda: len(heard) == 50)
    assert executor.shutdown(10)
    assert spinning.join() is None
    assert heard == list(range(50))


def test_destroyed_entity_does_not_run_again(node: Node, executor: Executor) -> None:
    ran: list[str] = []
    finished = threading.Event()
    group = node.default_callback_group

    def destroy_all() -> None:
        for timer in list(node.timers):
            node.destroy_timer(timer)
        for subscription in list(node.subscriptions):
            node.destroy_subscription(subscription)
        for client in list(node.clients):
            node.destroy_client(client)
        for guard in list(node.guards):
            node.destroy_guard_condition(guard)
        node.create_timer(0.02, finished.set, group)

    node.create_timer(0.0, destroy_all)
    node.create_timer(0.001, lambda: ran.append("timer"))
    node.create_client(AddTwoInts, "add")
    guard = node.create_guard_condition(lambda: ran.append("guard"))
    numbers_into(node, lambda _: ran.append("message"), 3)
    executor.add_node(node)
    spinning = Spinning(executor)
    assert finished.wait(30)
    before = len(ran)
    with pytest.raises(InvalidHandle):
        guard.trigger()
    finished.clear()
    assert finished.wait(30)
    assert len(ran) == before
    executor.shutdown(10)
    assert spinning.join() is None


def test_callback_can_destroy_its_own_node(node: Node, executor: Executor) -> None:
    done = threading.Event()

    def end() -> None:
        node.destroy_node()
        done.set()

    node.create_timer(0.0, end)
    executor.add_node(node)
    spinning = Spinning(executor)
    assert done.wait(30)
    wait_until(lambda: executor.get_nodes() == [])
    executor.shutdown(10)
    assert spinning.join() is None


def test_callback_can_remove_its_node_and_another_can_add_it(
    make_node: Callable[..., Node], executor: Executor
) -> None:
    leaving, staying = make_node("leaving"), make_node("staying")
    calls = 0

    def leave() -> None:
        nonlocal calls
        calls += 1
        executor.remove_node(leaving)

    def bring_back() -> None:
        if leaving not in executor.get_nodes():
            with suppress(ShutdownException):
                executor.add_node(leaving)

    leaving.create_timer(0.001, leave)
    staying.create_timer(0.001, bring_back)
    executor.add_node(leaving)
    executor.add_node(staying)
    spinning = Spinning(executor)
    wait_until(lambda: calls >= 3)
    executor.shutdown(10)
    assert spinning.join() is None


def test_callback_error_is_raised_by_spin_and_messages_are_kept(node: Node, executor: Executor) -> None:
    heard: list[int] = []

    def callback(msg: Int32) -> None:
        heard.append(msg.data)
        if msg.data % 2:
            raise KeyError(msg.data)

    numbers_into(node, callback, 4)
    executor.add_node(node)
    errors = [Spinning(executor).join() for _ in range(2)]
    assert [type(error) for error in errors] == [KeyError, KeyError]
    assert [error.args for error in errors] == [(1,), (3,)]
    assert heard == [0, 1, 2, 3]
    assert executor.get_nodes() == [node]


def test_coroutine_error_is_raised_by_spin(node: Node, executor: Executor) -> None:
    gate: Future[None] = Future(executor=executor)

    async def callback() -> None:
        timer.cancel()
        await gate
        raise ValueError("after the wait")

    timer = node.create_timer(0.0, callback)
    node.create_guard_condition(lambda: gate.set_result(None), ReentrantCallbackGroup()).trigger()
    executor.add_node(node)
    error = Spinning(executor).join()
    assert isinstance(error, ValueError)
    assert error.args == ("after the wait",)


def test_coroutine_calls_a_service_with_a_coroutine_callback(node: Node, executor: Executor) -> None:
    """A timer's coroutine awaits a call of the same node; the server's coroutine awaits a future."""
    asked: Future[None] = Future(executor=executor)
    answers: list[int] = []

    async def serve(request: Any, response: Any) -> Any:
        await asked
        response.sum = request.a + request.b
        return response

    async def call() -> None:
        timer.cancel()
        future = client.call_async(AddTwoInts.Request(a=2, b=3))
        asked.set_result(None)
        answers.append((await future).sum)

    node.create_service(AddTwoInts, "add", serve, callback_group=MutuallyExclusiveCallbackGroup())
    client = node.create_client(AddTwoInts, "add")
    executor.add_node(node)
    assert client.wait_for_service(20)
    timer = node.create_timer(0.0, call)
    spinning = Spinning(executor)
    wait_until(lambda: answers)
    executor.shutdown(10)
    assert spinning.join() is None
    assert answers == [5]


def test_any_thread_can_spin_until_a_future_completes(node: Node, executor: Executor) -> None:
    future: Future[int] = Future()
    numbers_into(node, lambda msg: future.set_result(msg.data), 1)
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin_until_future_complete, args=(future, 20))
    thread.start()
    thread.join(30)
    assert future.result() == 0


def test_done_callbacks_run_in_order_also_on_cancellation(node: Node, executor: Executor) -> None:
    order: list[str] = []
    first, second = executor.create_future(), Future(executor=executor)
    for future, name in ((first, "first"), (second, "second")):
        for number in range(2):
            future.add_done_callback(lambda _, text=f"{name} {number}": order.append(text))
    executor.add_node(node)
    first.set_result(1)
    second.cancel()
    assert order == []
    end = time.monotonic() + 10
    while len(order) < 4 and time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)
    assert sorted(order) == ["first 0", "first 1", "second 0", "second 1"]
    if not isinstance(executor, MultiThreadedExecutor):
        assert order == sorted(order)
    assert second.cancelled()


def test_cancelled_task_does_not_continue(executor: Executor) -> None:
    gate: Future[None] = Future(executor=executor)
    steps: list[str] = []

    async def work() -> None:
        steps.append("begun")
        try:
            await gate
            steps.append("went on")
        finally:
            steps.append("closed")

    task = executor.create_task(work)
    while not steps:
        executor.spin_once(timeout_sec=1)
    task.cancel()
    gate.set_result(None)
    executor.spin_once(timeout_sec=0.01)
    assert steps == ["begun", "closed"]
    assert task.cancelled()
    assert not task.done()


def test_callback_can_spin_its_own_executor(node: Node, executor: Executor) -> None:
    """On one thread, a nested spin runs other callbacks; on a thread of the pool, the spin around it does."""
    future: Future[None] = Future()
    outcome: list[str] = []

    def outer() -> None:
        timer.cancel()
        executor.spin_until_future_complete(future, timeout_sec=10)
        outcome.append("done" if future.done() else "timeout")

    timer = node.create_timer(0.0, outer)
    node.create_timer(0.001, lambda: future.set_result(None), MutuallyExclusiveCallbackGroup())
    executor.add_node(node)
    spinning = Spinning(executor)
    wait_until(lambda: outcome)
    executor.shutdown(10)
    assert spinning.join() is None
    assert outcome == ["done"]


def test_callback_can_spin_its_own_node_by_rclpy_functions(node: Node, context: Context) -> None:
    futures = [Future[None](), Future[None]()]
    with SingleThreadedExecutor(context=context) as executor:

        def outer() -> None:
            timer.cancel()
            node.create_timer(0.0, lambda: futures[0].set_result(None), ReentrantCallbackGroup())
            rclpy.spin_until_future_complete(node, futures[0], executor, timeout_sec=10)
            node.create_timer(0.0, lambda: futures[1].set_result(None))

        timer = node.create_timer(0.0, outer)
        rclpy.spin_until_future_complete(node, futures[1], executor, timeout_sec=10)
        assert [future.done() for future in futures] == [True, True]
        assert executor.get_nodes() == []
        executor.add_node(node)
        rclpy.spin_once(node, executor=executor, timeout_sec=0)
        assert node.executor is executor


def test_node_returns_to_its_former_executor(node: Node, executor: Executor, context: Context) -> None:
    ticks: list[None] = []
    node.create_timer(0.001, lambda: ticks.append(None))
    executor.add_node(node)
    spinning = Spinning(executor)
    with SingleThreadedExecutor(context=context) as own:
        future: Future[None] = Future()
        wake = threading.Timer(0.01, future.set_result, [None])
        wake.start()
        rclpy.spin_until_future_complete(node, future, own, timeout_sec=10)
        assert future.done()
        assert node.executor is executor
        seen = len(ticks)
        wait_until(lambda: len(ticks) > seen + 2)
        wake.join()
        assert own.get_nodes() == []
    executor.shutdown(10)
    assert spinning.join() is None


def test_node_does_not_return_to_an_ended_executor_or_after_its_destruction(
    make_node: Callable[..., Node], context: Context
) -> None:
    with SingleThreadedExecutor(context=context) as first, SingleThreadedExecutor(context=context) as own:
        destroyed, left = make_node("destroyed"), make_node("left")
        first.add_node(destroyed)
        destroyed.create_timer(0.0, destroyed.destroy_node)
        rclpy.spin_once(destroyed, executor=own, timeout_sec=5)
        assert first.get_nodes() == []
        first.add_node(left)
        left.create_timer(0.0, first.shutdown)
        rclpy.spin_once(left, executor=own, timeout_sec=5)
        assert own.get_nodes() == []
        assert first.get_nodes() == []


class Throttled(CallbackGroup):
    """A custom group: it admits a number of callbacks, and one more after each `refill`."""

    def __init__(self, bucket: int) -> None:
        super().__init__()
        self.bucket = bucket
        self.lock = threading.Lock()

    def refill(self) -> None:
        with self.lock:
            self.bucket += 1

    def can_execute(self, entity: Any) -> bool:
        return self.bucket > 0

    def beginning_execution(self, entity: Any) -> bool:
        with self.lock:
            allowed = self.bucket > 0
            self.bucket -= allowed
            return allowed

    def ending_execution(self, entity: Any) -> None:
        pass


def test_custom_group_can_admit_callbacks_later(node: Node, executor: Executor) -> None:
    group = Throttled(2)
    heard: list[int] = []
    publisher = node.create_publisher(Int32, "numbers", LATCHED)
    node.create_subscription(
        Int32, "numbers", lambda msg: heard.append(msg.data), LATCHED, callback_group=group
    )
    for number in range(4):
        publisher.publish(Int32(data=number))
    executor.add_node(node)
    refill = node.create_guard_condition(group.refill, MutuallyExclusiveCallbackGroup())
    spinning = Spinning(executor)
    wait_until(lambda: len(heard) == 2)
    for count in (3, 4):
        refill.trigger()
        wait_until(lambda count=count: len(heard) == count)
    executor.shutdown(10)
    assert spinning.join() is None
    assert heard == [0, 1, 2, 3]


def test_rate_keeps_its_period_until_shutdown(context: Context, node: Node) -> None:
    with SingleThreadedExecutor(context=context) as executor:
        executor.add_node(node)
        start = time.monotonic()
        rate = node.create_rate(100)
        spinning = Spinning(executor)
        for _ in range(5):
            rate.sleep()
        assert time.monotonic() - start > 0.05
        slow = node.create_rate(0.001)
        threading.Timer(0.02, context.shutdown).start()
        with pytest.raises(ROSInterruptException):
            slow.sleep()
        assert isinstance(spinning.join(), ExternalShutdownException | None)


@pytest.mark.parametrize("end", [rclpy.shutdown, rclpy.try_shutdown], ids=["shutdown", "try_shutdown"])
@pytest.mark.parametrize("spin", ["spin", "spin_once", "spin_until_future_complete"])
def test_rclpy_spin_on_a_thread_returns_when_another_shuts_down(
    spin: str, end: Callable[[], object], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    with own_defaults(Context()):
        rclpy.init()
        node = rclpy.create_node("spun")
        executor = rclpy.get_global_executor()
        executor.add_node(node)
        arguments = [Future[int]()] if spin == "spin_until_future_complete" else []
        spinning = Spinning(executor, spin, *arguments)
        wait_until(lambda: executor._spin_depth)
        end()
        assert spinning.join() is None
        if spin != "spin_once":
            executor.spin_once()
        with pytest.raises(ExternalShutdownException):  # so that a loop of a program ends
            executor.spin_once()


@pytest.mark.parametrize("spin", ["spin", "spin_once", "spin_until_future_complete"])
def test_pool_returns_when_the_context_is_shut_down(context: Context, node: Node, spin: str) -> None:
    with MultiThreadedExecutor(2, context=context) as pool:
        pool.add_node(node)
        arguments = [Future[int]()] if spin == "spin_until_future_complete" else []
        spinning = Spinning(pool, spin, *arguments)
        wait_until(lambda: pool._spin_depth)
        context.shutdown()
        assert spinning.join() is None
        if spin != "spin_once":
            pool.spin_once()
        with pytest.raises(ExternalShutdownException):
            pool.spin_once()


def test_pool_returns_where_a_callback_has_failed_because_of_the_shutdown(
    context: Context, node: Node
) -> None:
    with MultiThreadedExecutor(2, context=context) as pool:
        pool.add_node(node)
        pool._errors.append(RCLError("Failed to publish: publisher's context is invalid"))
        context.try_shutdown()
        pool.spin_once(timeout_sec=1.0)


def test_shutting_the_context_down_ends_a_spin(context: Context, node: Node, executor: Executor) -> None:
    begun = threading.Event()
    node.create_timer(0.0, begun.set)
    executor.add_node(node)
    spinning = Spinning(executor)
    assert begun.wait(30)
    context.shutdown()
    assert isinstance(spinning.join(), ExternalShutdownException | None)


def test_two_contexts_spin_side_by_side(context: Context, make_node: Callable[..., Node]) -> None:
    with Context() as other:
        one, two = make_node("one"), make_node("two", context=other)
        with SingleThreadedExecutor(context=context) as first, EventsExecutor(context=other) as second:
            first.add_node(one)
            second.add_node(two)
            heard: list[int] = []
            two.create_subscription(Int32, "numbers", lambda msg: heard.append(msg.data), LATCHED)
            publisher = one.create_publisher(Int32, "numbers", LATCHED)

            def publish() -> None:
                with suppress(RCLError):  # the context may end in the middle of a callback
                    publisher.publish(Int32(data=1))

            one.create_timer(0.01, publish)
            spins = [Spinning(first), Spinning(second)]
            wait_until(lambda: heard)
            context.shutdown()
            assert isinstance(spins[0].join(), ExternalShutdownException | None)
            assert spins[1].thread.is_alive()
            assert other.ok()
            other.shutdown()
            spins[1].join()


@pytest.mark.timing
def test_idle_node_uses_no_cpu_time(node: Node, executor: Executor) -> None:
    executor.add_node(node)
    node.create_subscription(Int32, "numbers", lambda _: None, 10)
    node.create_timer(100.0, lambda: None)
    executor.spin_once(timeout_sec=0.2)  # discovery of itself
    before = time.process_time()
    executor.spin_until_future_complete(Future(), timeout_sec=0.5)
    assert time.process_time() - before < 0.05


def test_custom_executor_runs_ready_callbacks(node: Node, context: Context) -> None:
    """As in the documentation: the program runs ready callbacks by itself."""
    order: list[tuple[str, Any]] = []

    class Logs(Executor):
        def spin_once(self, timeout_sec: float | None = None) -> None:
            try:
                handler, entity, of = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
            except TimeoutException:
                return
            handler()
            order.append((type(entity).__name__, of))
            if handler.done() and handler.exception() is not None:
                raise handler.exception()

    gate: Future[str] = Future()

    async def callback(msg: Int32) -> None:
        if msg.data == 0:
            await gate
        order.append(("ran", msg.data))

    numbers_into(node, callback, 2)
    with Logs(context=context) as executor:
        gate.set_executor(executor)
        executor.add_node(node)
        end = time.monotonic() + 20
        while ("Subscription", node) not in order:
            executor.spin_once(timeout_sec=0.1)
            assert time.monotonic() < end
        executor.spin_once(timeout_sec=0.01)
        assert order == [("Subscription", node)], "the group is the first callback's until its end"
        gate.set_result("open")
        while ("ran", 1) not in order:
            executor.spin_once(timeout_sec=0.1)
            assert time.monotonic() < end
        assert order[1:3] == [("ran", 0), ("NoneType", None)]
        executor.create_task(lambda: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            executor.spin_once()
        with pytest.raises(TimeoutException):
            executor.wait_for_ready_callbacks(timeout_sec=0.01)


def test_timeout_object_is_read_at_each_wait(executor: Executor) -> None:
    timeout = TimeoutObject(100.0)
    timeout.timeout = 0.01
    start = time.monotonic()
    executor.spin_once_until_future_complete(Future(), timeout)
    assert 0.01 <= time.monotonic() - start < 50
