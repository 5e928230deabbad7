"""Executors: order and fairness, tasks, threads, errors and shutdown."""

from __future__ import annotations

import gc
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import Any

import pytest

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.node import client_library
from tfloom.node.context.context import Context
from tfloom.node.executing import executors, work_queue
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.values.exceptions import ExternalShutdownException, ShutdownException

SpinUntil = Callable[..., None]


def test_busy_topic_does_not_starve_the_others(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    order: list[str] = []
    busy = node.create_publisher(Int32, "busy", 1000)
    quiet = node.create_publisher(Int32, "quiet", 10)
    node.create_subscription(Int32, "busy", lambda msg: order.append("busy"), 1000)
    node.create_subscription(Int32, "quiet", lambda msg: order.append("quiet"), 10)
    executor.add_node(node)
    for number in range(100):
        busy.publish(Int32(data=number))
    quiet.publish(Int32())
    spin_until(lambda: len(order) == 101)
    assert order.index("quiet") <= 2


def test_a_timer_runs_between_messages(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    publisher = node.create_publisher(Int32, "loop", 10)
    node.create_subscription(Int32, "loop", publisher.publish, 10)
    ticks: list[float] = []
    node.create_timer(0.001, lambda: ticks.append(time.monotonic()))
    executor.add_node(node)
    publisher.publish(Int32())
    spin_until(lambda: len(ticks) == 5)


def test_entities_can_be_added_and_removed_during_a_spin(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    publisher = node.create_publisher(Int32, "numbers", 10)
    executor.add_node(node)
    first: list[int] = []
    second: list[int] = []

    def replace(msg: Int32) -> None:
        first.append(msg.data)
        node.destroy_subscription(subscription)
        node.create_subscription(Int32, "numbers", lambda msg: second.append(msg.data), 10)
        publisher.publish(Int32(data=3))

    subscription = node.create_subscription(Int32, "numbers", replace, 10)
    publisher.publish(Int32(data=1))
    publisher.publish(Int32(data=2))
    spin_until(lambda: second)
    assert (first, second) == ([1], [3])


def test_entities_can_be_removed_on_another_thread(context: Context, make_node: Callable[..., Node]) -> None:
    node = make_node()
    publisher = node.create_publisher(Int32, "numbers", 10)
    with SingleThreadedExecutor(context=context) as executor:
        executor.add_node(node)
        errors: list[BaseException] = []

        def spin() -> None:
            try:
                executor.spin()
            except ExternalShutdownException:
                pass
            except BaseException as error:  # noqa: BLE001
                errors.append(error)

        thread = threading.Thread(target=spin)
        thread.start()
        for _ in range(200):
            subscription = node.create_subscription(Int32, "numbers", lambda msg: None, 10)
            timer = node.create_timer(0.0001, lambda: None)
            publisher.publish(Int32())
            node.destroy_subscription(subscription)
            node.destroy_timer(timer)
        context.shutdown()
        thread.join(10)
    assert not thread.is_alive()
    assert not errors


def test_spin_once_returns_after_its_timeout(node: Node, executor: SingleThreadedExecutor) -> None:
    executor.add_node(node)
    start = time.monotonic()
    executor.spin_once(timeout_sec=0.05)
    assert 0.05 <= time.monotonic() - start < 5.0


def test_completed_future_ends_a_spin(node: Node, executor: SingleThreadedExecutor) -> None:
    future: Future[int] = Future()
    node.create_timer(0.001, lambda: future.set_result(5))
    executor.add_node(node)
    executor.spin_until_future_complete(future, timeout_sec=10)
    assert future.result() == 5
    executor.spin_until_future_complete(Future(), timeout_sec=0.01)


def test_future_completed_on_another_thread_ends_a_spin(node: Node, executor: SingleThreadedExecutor) -> None:
    future: Future[str] = Future()
    executor.add_node(node)
    threading.Timer(0.01, lambda: future.set_result("x")).start()
    executor.spin_until_future_complete(future, timeout_sec=10)
    assert future.result() == "x"


def test_waiting_coroutines_do_not_block_the_executor(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    future: Future[int] = Future(executor=executor)
    steps: list[str] = []

    async def waits() -> int:
        steps.append("waits")
        return await future or 0

    async def outer() -> int:
        return await waits() + 1

    task = executor.create_task(outer)
    executor.create_task(lambda: steps.append("other"))
    spin_until(lambda: len(steps) == 2)
    assert not task.done()
    future.set_result(41)
    spin_until(task.done)
    assert task.result() == 42


def test_async_callback_occupies_its_group_until_completion(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    gate: Future[None] = Future(executor=executor)
    begun: list[int] = []
    ended: list[int] = []

    async def callback(msg: Int32) -> None:
        begun.append(msg.data)
        await gate
        ended.append(msg.data)

    publisher = node.create_publisher(Int32, "numbers", 10)
    node.create_subscription(Int32, "numbers", callback, 10)
    executor.add_node(node)
    for number in range(3):
        publisher.publish(Int32(data=number))
    spin_until(lambda: begun)
    for _ in range(5):
        executor.spin_once(timeout_sec=0)
    assert (begun, ended) == ([0], [])
    gate.set_result(None)
    spin_until(lambda: len(ended) == 3)
    assert ended == [0, 1, 2]


def test_async_callbacks_of_a_reentrant_group_overlap(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    gate: Future[None] = Future(executor=executor)
    begun: list[int] = []

    async def callback(msg: Int32) -> None:
        begun.append(msg.data)
        await gate

    publisher = node.create_publisher(Int32, "numbers", 10)
    node.create_subscription(Int32, "numbers", callback, 10, callback_group=ReentrantCallbackGroup())
    executor.add_node(node)
    for number in range(3):
        publisher.publish(Int32(data=number))
    spin_until(lambda: len(begun) == 3)
    gate.set_result(None)


@pytest.mark.timing
def test_waiting_coroutine_uses_no_cpu_time(node: Node, executor: SingleThreadedExecutor) -> None:
    gate: Future[None] = Future(executor=executor)

    async def waits() -> None:
        await gate

    executor.add_node(node)
    executor.create_task(waits)
    before = time.process_time()
    executor.spin_until_future_complete(Future(), timeout_sec=0.2)
    assert time.process_time() - before < 0.05
    gate.set_result(None)


def test_task_error_is_raised_by_spin(executor: SingleThreadedExecutor) -> None:
    def fails() -> None:
        raise ValueError("mine")

    task = executor.create_task(fails)
    with pytest.raises(ValueError, match="mine"):
        executor.spin_once(timeout_sec=1)
    assert isinstance(task.exception(), ValueError)


def test_shutdown_in_a_callback_ends_the_spin_without_error(
    context: Context, node: Node, executor: SingleThreadedExecutor
) -> None:
    node.create_timer(0.0, context.shutdown)
    executor.add_node(node)
    executor.spin()
    assert not context.ok()


def test_executor_rejects_nodes_after_shutdown(context: Context, node: Node) -> None:
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    assert executor.shutdown()
    assert executor.get_nodes() == []
    executor.spin()
    with pytest.raises(ShutdownException):
        executor.add_node(node)


def test_node_moves_between_executors(context: Context, node: Node) -> None:
    with SingleThreadedExecutor(context=context) as one, SingleThreadedExecutor(context=context) as two:
        assert one.add_node(node)
        assert not one.add_node(node)
        assert two.add_node(node)
        assert one.get_nodes() == []
        assert two.get_nodes() == [node]
        assert node.executor is two
        two.remove_node(node)
        assert two.get_nodes() == []
        assert node.executor is two


def test_two_threads_cannot_spin_one_executor(context: Context, node: Node) -> None:
    with SingleThreadedExecutor(context=context) as executor:
        executor.add_node(node)
        spinning = threading.Event()
        node.create_timer(0.001, spinning.set)

        def spin() -> None:
            with pytest.raises(ExternalShutdownException):
                executor.spin_until_future_complete(Future())

        thread = threading.Thread(target=spin)
        thread.start()
        assert spinning.wait(30)
        with pytest.raises(RuntimeError, match="already spinning"):  # noqa: PT012
            while True:
                executor.spin_once(timeout_sec=0)
        context.shutdown()
        thread.join(10)


def test_threads_run_callbacks_that_groups_admit(context: Context, node: Node) -> None:
    together = threading.Barrier(2)
    done = [Future(), Future()]
    for future in done:

        def callback(future: Future[bool] = future) -> None:
            together.wait(30)
            future.set_result(True)

        node.create_timer(0.001, callback, MutuallyExclusiveCallbackGroup())
    with MultiThreadedExecutor(2, context=context) as executor:
        executor.add_node(node)
        for future in done:
            executor.spin_until_future_complete(future, timeout_sec=10)
            assert future.done()
        together.abort()
        executor.shutdown()


def test_threads_keep_a_group_exclusive(context: Context, node: Node) -> None:
    running = 0
    most = 0
    calls = 0
    finished: Future[None] = Future()

    def callback(msg: Int32) -> None:
        nonlocal running, most, calls
        running += 1
        most = max(most, running)
        time.sleep(0.0005)
        running -= 1
        calls += 1
        if calls == 60:
            finished.set_result(None)

    publisher = node.create_publisher(Int32, "numbers", 100)
    group = MutuallyExclusiveCallbackGroup()
    for _ in range(3):
        node.create_subscription(Int32, "numbers", callback, 100, callback_group=group)
    with MultiThreadedExecutor(4, context=context) as executor:
        executor.add_node(node)
        for number in range(20):
            publisher.publish(Int32(data=number))
        executor.spin_until_future_complete(finished, timeout_sec=10)
    assert (calls, most) == (60, 1)


@pytest.fixture
def long_batches(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no time end what a thread of a pool runs without returning to the thread that spins."""
    monkeypatch.setattr(executors, "BATCH_NS", 30_000_000_000)


@pytest.fixture
def pool(long_batches: None, context: Context, node: Node) -> Iterator[MultiThreadedExecutor]:
    """Yield an executor of two threads that has the node."""
    with MultiThreadedExecutor(2, context=context) as pool:
        pool.add_node(node)
        yield pool


class Numbers:
    """Ten messages that wait for a subscription, whose callback does something at the third."""

    def __init__(self, node: Node, at_the_third: Callable[[], object]) -> None:
        self.heard: list[int] = []
        self._at_the_third = at_the_third
        node.create_subscription(Int32, "numbers", self._hear, 10)
        publisher = node.create_publisher(Int32, "numbers", 10)
        for number in range(10):
            publisher.publish(Int32(data=number))

    def _hear(self, msg: Int32) -> None:
        self.heard.append(msg.data)
        if msg.data == 2:
            self._at_the_third()

    def hear_the_rest(self, executor: MultiThreadedExecutor) -> None:
        end = time.monotonic() + 30
        while len(self.heard) < 10 and time.monotonic() < end:
            executor.spin_once(timeout_sec=0.02)
        assert self.heard == list(range(10))


def test_each_reason_alone_keeps_a_thread_from_continuing(
    pool: MultiThreadedExecutor, context: Context, node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The tests below meet some of them together, in an order that the system's scheduling decides."""
    numbers = node.create_subscription(Int32, "numbers", print, 10)
    is_over: Future[None] = Future()

    def may_continue() -> bool:
        return pool._may_continue(numbers, None, time.monotonic_ns() + 30_000_000_000)

    assert not may_continue()  # nobody spins
    monkeypatch.setattr(pool, "_is_in_long_spin", True)
    monkeypatch.setattr(pool, "_awaited", is_over)
    assert may_continue()
    for name, value in (("_errors", [KeyError()]), ("_is_shutdown", True)):
        with monkeypatch.context() as patch:
            patch.setattr(pool, name, value)
            assert not may_continue(), name
    is_over.set_result(None)
    assert not may_continue()
    monkeypatch.setattr(pool, "_awaited", None)
    assert may_continue()
    context.shutdown()
    assert not may_continue()


def test_no_thread_continues_after_the_awaited_future_is_complete(
    pool: MultiThreadedExecutor, node: Node
) -> None:
    future: Future[None] = Future()
    numbers = Numbers(node, lambda: future.set_result(None))
    pool.spin_until_future_complete(future, timeout_sec=30)
    assert pool._running.wait(30)
    assert numbers.heard == [0, 1, 2]
    assert pool._awaited is None
    numbers.hear_the_rest(pool)


def test_no_thread_continues_after_an_error(pool: MultiThreadedExecutor, node: Node) -> None:
    def fail() -> None:
        raise KeyError("third")

    numbers = Numbers(node, fail)
    with pytest.raises(KeyError, match="third"):
        pool.spin()
    assert pool._running.wait(30)
    assert numbers.heard == [0, 1, 2]
    numbers.hear_the_rest(pool)


def test_no_thread_continues_after_a_shutdown(pool: MultiThreadedExecutor, node: Node) -> None:
    is_third = threading.Event()

    def wait_for_shutdown() -> None:
        is_third.set()
        while not pool._is_shutdown:
            time.sleep(0.001)

    numbers = Numbers(node, wait_for_shutdown)
    thread = threading.Thread(target=pool.spin)
    thread.start()
    assert is_third.wait(30)
    assert pool.shutdown(30)
    thread.join(30)
    assert numbers.heard == [0, 1, 2]


def test_no_thread_continues_with_a_removed_node(pool: MultiThreadedExecutor, node: Node) -> None:
    removed: Future[None] = Future()

    def remove() -> None:
        pool.remove_node(node)
        pool.create_task(removed.set_result, None)

    numbers = Numbers(node, remove)
    pool.spin_until_future_complete(removed, timeout_sec=30)
    assert numbers.heard == [0, 1, 2]
    pool.add_node(node)
    numbers.hear_the_rest(pool)


def test_spin_once_on_a_pool_runs_one_callback(pool: MultiThreadedExecutor, node: Node) -> None:
    numbers = Numbers(node, lambda: None)
    end = time.monotonic() + 30
    while not numbers.heard and time.monotonic() < end:
        pool.spin_once(timeout_sec=0.02)
    pool.spin_once(timeout_sec=0.02)
    assert pool._running.wait(30)
    assert len(numbers.heard) <= 2


def test_a_busy_topic_on_a_pool_lets_its_group_run_the_others(
    pool: MultiThreadedExecutor, node: Node
) -> None:
    order: list[str] = []
    finished: Future[None] = Future()

    def hear_busy(_: Int32) -> None:
        while not order and not node.default_callback_group.has_parked(quiet):
            time.sleep(0.001)
        order.append("busy")
        if order.count("busy") == 10:
            finished.set_result(None)

    node.create_subscription(Int32, "busy", hear_busy, 10)
    quiet = node.create_subscription(Int32, "quiet", lambda _: order.append("quiet"), 1)
    for topic, count in (("busy", 10), ("quiet", 1)):
        publisher = node.create_publisher(Int32, topic, 10)
        for _ in range(count):
            publisher.publish(Int32())
    pool.spin_until_future_complete(finished, timeout_sec=30)
    assert order == ["busy", "quiet", *["busy"] * 9]


def test_a_group_of_the_program_admits_each_callback_on_a_pool(
    pool: MultiThreadedExecutor, node: Node
) -> None:
    class Counting(MutuallyExclusiveCallbackGroup):
        begun = 0

        def beginning_execution(self, entity: Any) -> bool:
            begins = super().beginning_execution(entity)
            self.begun += begins
            return begins

    group = Counting()
    finished: Future[None] = Future()

    def hear(msg: Int32) -> None:
        if msg.data == 9:
            finished.set_result(None)

    node.create_subscription(Int32, "numbers", hear, 10, callback_group=group)
    publisher = node.create_publisher(Int32, "numbers", 10)
    for number in range(10):
        publisher.publish(Int32(data=number))
    pool.spin_until_future_complete(finished, timeout_sec=30)
    assert finished.done()
    assert group.begun == 10


def test_five_hundred_topics_in_one_node(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    heard: set[int] = set()
    publishers = [node.create_publisher(Int32, f"t{index}", 1) for index in range(500)]
    for index in range(500):
        node.create_subscription(Int32, f"t{index}", lambda msg: heard.add(msg.data), 1)
    executor.add_node(node)
    for index, publisher in enumerate(publishers):
        publisher.publish(Int32(data=index))
    spin_until(lambda: len(heard) == 500)


@pytest.mark.parametrize("kind", [SingleThreadedExecutor, MultiThreadedExecutor])
def test_callback_that_begins_at_a_shutdown_does_not_keep_its_group(
    kind: type[SingleThreadedExecutor | MultiThreadedExecutor], context: Context, node: Node
) -> None:
    ticks: list[int] = []
    group = MutuallyExclusiveCallbackGroup()
    node.create_timer(0.0, lambda: ticks.append(1), callback_group=group)
    executor = kind(context=context)
    executor.add_node(node)
    work = executor._wait_for_work(None, None)
    assert executor.shutdown(30)
    if isinstance(executor, MultiThreadedExecutor):
        executor._submit(work)
        assert executor._busy == 0
    else:
        executor._run(work)
    assert ticks == []
    with SingleThreadedExecutor(context=context) as other:
        other.add_node(node)
        other.spin_once(timeout_sec=30)
    assert ticks == [1]


def test_callback_that_completes_while_another_is_parked_lets_it_run(
    node: Node, executor: SingleThreadedExecutor, monkeypatch: pytest.MonkeyPatch
) -> None:
    group = MutuallyExclusiveCallbackGroup()
    ran: list[int] = []
    running = node.create_guard_condition(lambda: None, callback_group=group)
    waiting = node.create_guard_condition(lambda: ran.append(1), callback_group=group)
    executor.add_node(node)
    assert group.beginning_execution(running)  # as on another thread
    park = group.park

    def complete_and_park(entity: Any, post_again: Callable[[], None]) -> None:
        group.ending_execution(running)
        group.release_parked()
        park(entity, post_again)

    monkeypatch.setattr(group, "park", complete_and_park)
    waiting.trigger()
    executor.spin_once(timeout_sec=30)
    assert ran == [1]


def test_many_responses_at_once_are_all_taken(
    context: Context, make_node: Callable[..., Node], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(work_queue, "MAX_BATCH_SIZE", 2)
    asking, answering = make_node("asking"), make_node("answering")
    client = asking.create_client(AddTwoInts, "add")
    answering.create_service(AddTwoInts, "add", lambda _, response: response)
    with (
        SingleThreadedExecutor(context=context) as executor,
        SingleThreadedExecutor(context=context) as there,
    ):
        executor.add_node(asking)
        there.add_node(answering)
        # The arrival of the server, which looks for all responses, is over.
        executor.spin_once(timeout_sec=0.0)
        futures = [client.call_async(AddTwoInts.Request()) for _ in range(7)]
        for _ in futures:
            there.spin_once(timeout_sec=30)
        for _ in futures:
            executor.spin_once(timeout_sec=1)
        assert all(future.done() for future in futures)


def test_future_completed_on_another_thread_ends_a_single_wait(
    executor: SingleThreadedExecutor, monkeypatch: pytest.MonkeyPatch
) -> None:
    future: Future[int] = Future()
    waits = threading.Event()
    collect = executor._collect

    def begin_wait(*args: Any, **options: Any) -> None:
        waits.set()
        collect(*args, **options)

    monkeypatch.setattr(executor, "_collect", begin_wait)
    spin = executor.spin_once_until_future_complete
    thread = threading.Thread(target=spin, args=(future, 60.0))
    thread.start()
    assert waits.wait(30)
    future.set_result(1)
    thread.join(30)
    assert not thread.is_alive()


def test_shutdown_in_a_callback_does_not_wait_for_it(context: Context, node: Node) -> None:
    for kind in (SingleThreadedExecutor, MultiThreadedExecutor):
        executor = kind(context=context)
        ended: list[bool] = []
        timer = node.create_timer(0.0, lambda ended=ended, end=executor.shutdown: ended.append(end(60)))
        executor.add_node(node)
        thread = threading.Thread(target=executor.spin, daemon=True)
        thread.start()
        thread.join(30)
        assert not thread.is_alive()
        assert executor._running.wait(30)
        assert ended == [True]
        node.destroy_timer(timer)


def test_shutdown_waits_for_a_callback_on_another_thread(context: Context, node: Node) -> None:
    executor = SingleThreadedExecutor(context=context)
    begun, may_end = threading.Event(), threading.Event()

    def wait() -> None:
        begun.set()
        assert may_end.wait(30)

    node.create_timer(0.0, wait)
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin)
    spinning.start()
    assert begun.wait(30)
    assert not executor.shutdown(0.0)
    ended: list[bool] = []
    ending = threading.Thread(target=lambda: ended.append(executor.shutdown(60)), daemon=True)
    ending.start()
    while not executor._running._waiters:
        time.sleep(0.001)
    may_end.set()
    ending.join(30)
    assert ended == [True]
    spinning.join(30)


def test_shutdown_closes_what_it_leaves(context: Context, node: Node) -> None:
    executor = SingleThreadedExecutor(context=context)
    closed: list[bool] = []

    async def wait_in_vain() -> None:
        try:
            await Future()
        finally:
            closed.append(True)

    task = executor.create_task(wait_in_vain)
    executor.spin_once(timeout_sec=30)
    guard = node.create_guard_condition(lambda: None)
    executor.add_entity(guard)  # without its node
    assert closed == []
    executor.shutdown()
    assert closed == [True]
    assert not task.done()
    queue = executor._queue
    queue.wait(0)
    guard.trigger()
    context.shutdown()
    assert queue.wait(0) == []


def test_no_thread_continues_after_the_context_ends(
    pool: MultiThreadedExecutor, context: Context, node: Node
) -> None:
    numbers = Numbers(node, context.shutdown)
    with suppress(ExternalShutdownException):
        pool.spin()
    assert pool._running.wait(30)
    assert numbers.heard == [0, 1, 2]


def test_a_spin_inside_a_long_one_is_over_with_itself(node: Node, executor: SingleThreadedExecutor) -> None:
    long: list[bool] = []
    done, end = Future[None](), Future[None]()
    done.set_result(None)

    def spin_inside() -> None:
        executor.spin_until_future_complete(done)
        long.append(executor._is_in_long_spin)
        end.set_result(None)

    node.create_timer(0.0, spin_inside)
    executor.add_node(node)
    executor.spin_until_future_complete(end, timeout_sec=30)
    assert long == [True]
    assert not executor._is_in_long_spin


def test_hint_is_timed_from_the_present_wait(node: Node, executor: SingleThreadedExecutor) -> None:
    group = MutuallyExclusiveCallbackGroup()
    running, waiting = (node.create_guard_condition(lambda: None, callback_group=group) for _ in range(2))
    executor.add_node(node)
    hints_ns: list[int] = []
    with executor._running:
        for _ in range(2):
            assert group.beginning_execution(running)
            group.park(waiting, lambda: None)
            hint_ns = executor._end_of_nested_wait(None, has_end=False)
            assert hint_ns is not None
            hints_ns.append(hint_ns)
            group.ending_execution(running)
            group.release_parked()
            assert executor._end_of_nested_wait(None, has_end=False) is None
    assert hints_ns[0] < hints_ns[1]


def test_guard_condition_that_was_triggered_before_runs(node: Node, executor: SingleThreadedExecutor) -> None:
    ran: list[int] = []
    node.create_guard_condition(lambda: ran.append(1)).trigger()
    executor.add_node(node)
    executor.spin_once(timeout_sec=1)
    assert ran == [1]


def test_group_is_free_only_when_its_own_callback_ends(node: Node) -> None:
    group = MutuallyExclusiveCallbackGroup()
    running, other = (node.create_guard_condition(lambda: None, callback_group=group) for _ in range(2))
    assert group.beginning_execution(running)
    group.ending_execution(other)
    assert not group.can_execute(other)
    group.park(other, lambda: None)
    assert group.has_parked(other)
    assert not group.has_parked(running)
    assert group.has_parked_another(running)
    assert not group.has_parked_another(other)
    group.ending_execution(running)
    assert group.can_execute(other)


def test_global_executor_of_a_former_context_is_shut_down(ros_domain: int) -> None:
    kept: list[executors.Executor] = []
    for _ in range(2):
        client_library.init(args=[], domain_id=ros_domain)
        kept.append(executors.get_global_executor())
        assert executors.get_global_executor() is kept[-1]
        client_library.shutdown()
    former, _ = kept
    assert former._is_shutdown


def test_future_wakes_each_waiter_once(capfd: pytest.CaptureFixture[str]) -> None:
    woken: list[int] = []
    future: Future[int] = Future()
    wake = lambda: woken.append(1)  # noqa: E731
    future.when_complete(wake)
    future.when_complete(wake)
    future.set_result(1)
    assert woken == [1]
    late: Future[int] = Future()
    assert late.exception() is None
    late.set_exception(KeyError("nobody asked again"))
    del late
    gc.collect()
    assert "never retrieved: 'nobody asked again'" in capfd.readouterr().err
