"""Executors of a program's own, by `wait_for_ready_callbacks`, and callbacks that spin their executor."""

from __future__ import annotations

import gc
import threading
import time
import weakref
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.interfaces.std_srvs.srv import Trigger
from tfloom.node import client_library as rclpy
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer
from tfloom.node.context.context import Context
from tfloom.node.executing.callback_groups import (
    MIN_PURGED,
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.guard_condition import GuardCondition
from tfloom.node.executing.task import Future
from tfloom.node.executing.wait_set import WaitSet
from tfloom.node.executing.waitable import NumberOfEntities, Waitable
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
)

WAIT_S = 20.0


def latched(depth: int) -> QoSProfile:
    return QoSProfile(depth=depth, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class PoolExecutor(Executor):
    """Runs each task on a pool of threads, as programs write it by rclpy's documentation."""

    def __init__(self, context: Context) -> None:
        super().__init__(context=context)
        self.pool = ThreadPoolExecutor(8)
        self.submitted = 0

    def spin_once(self, timeout_sec: float | None = None) -> None:
        try:
            task, _, _ = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
        except (TimeoutException, ShutdownException, ExternalShutdownException):
            return
        self.submitted += 1
        self.pool.submit(task)


@contextmanager
def spinning(executor: Executor, spin: Callable[[], None] | None = None) -> Iterator[list[BaseException]]:
    """Spin on another thread, until the executor is shut down; give what ended that thread otherwise."""
    errors: list[BaseException] = []

    def run() -> None:
        try:
            (spin or executor.spin)()
        except ExternalShutdownException:
            pass
        except BaseException as error:  # noqa: BLE001
            errors.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    try:
        yield errors
    finally:
        executor.shutdown(10)
        thread.join(WAIT_S)
        assert not thread.is_alive()


@pytest.fixture
def executor(context: Context) -> Iterator[SingleThreadedExecutor]:
    with SingleThreadedExecutor(context=context) as executor:
        yield executor


def done(future: Future[Any]) -> Any:
    wait_until(future.done, WAIT_S)
    return future.result()


# Calls in callbacks of a pool


@pytest.fixture
def pool(context: Context) -> Iterator[PoolExecutor]:
    executor = PoolExecutor(context)
    try:
        yield executor
    finally:
        executor.shutdown(10)
        executor.pool.shutdown(wait=True)


def succeed(goal_handle: Any) -> Fibonacci.Result:
    goal_handle.succeed()
    return Fibonacci.Result(sequence=[1])


@pytest.mark.parametrize("waiting", ["call", "goal", "cancel"])
def test_a_callback_on_a_thread_of_a_program_s_own_executor_may_wait(
    node: Node, context: Context, pool: PoolExecutor, waiting: str
) -> None:
    """Only one on the thread that spins would wait for itself."""
    servers = Node("servers", context=context)
    group = ReentrantCallbackGroup()
    servers.create_service(Trigger, "inner", lambda _, response: Trigger.Response(success=True))
    ActionServer(servers, Fibonacci, "count", succeed)
    inner = node.create_client(Trigger, "inner", callback_group=group)
    action = ActionClient(node, Fibonacci, "count", callback_group=group)

    def outer(_: Any, response: Any) -> Any:
        if waiting == "call":
            response.success = inner.call(Trigger.Request()).success
        elif waiting == "goal":
            response.success = list(action.send_goal(Fibonacci.Goal()).result.sequence) == [1]
        else:
            handle = action.wait_for(action.send_goal_async(Fibonacci.Goal()))
            response.success = handle.cancel_goal() is not None
        return response

    node.create_service(Trigger, "outer", outer, callback_group=group)
    client = node.create_client(Trigger, "outer", callback_group=group)
    pool.add_node(node)
    pool.add_node(servers)
    with spinning(pool) as errors:
        assert client.wait_for_service(WAIT_S)
        assert action.wait_for_server(WAIT_S)
        assert inner.wait_for_service(WAIT_S)
        answers = [done(client.call_async(Trigger.Request())).success for _ in range(3)]
    assert answers == [True] * 3
    assert errors == []


class KnowingExecutor(PoolExecutor):
    """As programs write it that know all methods."""

    def spin_once_until_future_complete(self, future: Future[Any], timeout_sec: Any = None) -> None:
        future.add_done_callback(lambda _: self.wake())
        try:
            task, _, _ = self.wait_for_ready_callbacks(timeout_sec, None, future.done)
        except (TimeoutException, ShutdownException, ConditionReachedException, ExternalShutdownException):
            return
        self.pool.submit(task)


@pytest.mark.parametrize("kind", [PoolExecutor, KnowingExecutor])
@pytest.mark.parametrize("timeout_s", [None, WAIT_S])
def test_a_spin_until_a_future_is_done_runs_callbacks_where_the_program_s_class_does(
    node: Node, context: Context, kind: type[PoolExecutor], timeout_s: float | None
) -> None:
    """Where this thread ran the task, nobody would receive what it waits for."""
    executor = kind(context)
    node.create_service(Trigger, "serve", lambda _, r: Trigger.Response(success=True))
    client = node.create_client(Trigger, "serve")
    assert client.wait_for_service(WAIT_S)

    def work() -> bool:
        responded = threading.Event()
        future = client.call_async(Trigger.Request())
        future.add_done_callback(lambda _: responded.set())
        return responded.wait(WAIT_S / 2) and future.result().success

    executor.add_node(node)
    try:
        for _ in range(2):
            task = executor.create_task(work)
            executor.spin_until_future_complete(task, timeout_sec=timeout_s)
            assert task.done()
            assert task.result()
        start = time.monotonic()
        executor.spin_until_future_complete(Future(), timeout_sec=0.02)
        assert time.monotonic() - start < WAIT_S / 2
    finally:
        executor.shutdown(10)
        executor.pool.shutdown(wait=True)


def test_a_call_on_the_thread_that_spins_is_refused(node: Node, executor: Executor) -> None:
    """Where the program's executor runs its tasks in its loop, a call would wait for that loop."""
    client = node.create_client(Trigger, "inner")
    node.create_service(Trigger, "inner", lambda _, response: response)
    assert client.wait_for_service(WAIT_S)
    node.create_guard_condition(lambda: client.call(Trigger.Request())).trigger()
    executor.add_node(node)
    task, entity, _ = executor.wait_for_ready_callbacks(timeout_sec=WAIT_S)
    assert isinstance(entity, GuardCondition)
    task()
    assert isinstance(task.exception(), RuntimeError)
    # The same thread may call when the callback has ended.
    with spinning(executor):
        assert client.call(Trigger.Request(), timeout_sec=WAIT_S) is not None


def test_a_pool_is_not_given_the_same_task_over_and_over(node: Node, pool: PoolExecutor) -> None:
    gate, ran = threading.Event(), threading.Event()
    blocked = [pool.pool.submit(gate.wait) for _ in range(8)]
    node.create_guard_condition(ran.set).trigger()
    pool.add_node(node)
    with spinning(pool):
        wait_until(lambda: pool.submitted > 1)  # it is returned again, because nobody has begun it
        before, start = pool.submitted, time.monotonic()
        wait_until(lambda: pool.submitted > before + 3)
        assert time.monotonic() - start > 0.02
        gate.set()
        assert ran.wait(WAIT_S)
    assert all(future.result(WAIT_S) for future in blocked)


# What is waited for


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        ((WAIT_S, None, lambda: False), ()),
        ((WAIT_S,), ("nodes",)),
        ((), ("timeout_sec", "nodes", "condition")),
    ],
)
def test_arguments_by_position_and_by_name(
    node: Node, executor: Executor, arguments: tuple[Any, ...], named: tuple[str, ...]
) -> None:
    timer = node.create_timer(0.001, lambda: None)
    executor.add_node(node)
    values = {"timeout_sec": WAIT_S, "nodes": [node], "condition": lambda: False}
    task, entity, of = executor.wait_for_ready_callbacks(*arguments, **{name: values[name] for name in named})
    assert (entity, of) == (timer, node)
    task()
    assert task.done()


def test_nodes_that_are_not_waited_for_keep_what_they_have(
    make_node: Callable[..., Node], executor: Executor
) -> None:
    ran: list[str] = []
    nodes = [make_node(name) for name in ("one", "two")]
    for node in nodes:
        node.create_guard_condition(partial(ran.append, node.get_name())).trigger()
        executor.add_node(node)
    for node in reversed(nodes):
        task, _, of = executor.wait_for_ready_callbacks(WAIT_S, [node])
        assert of is node
        del task
        with pytest.raises(TimeoutException):
            executor.wait_for_ready_callbacks(0.0, [])
        executor.wait_for_ready_callbacks(WAIT_S, [node])[0]()
    assert ran == ["two", "one"]
    # A spin of another kind serves all.
    for guard in [guard for node in nodes for guard in node.guards]:
        guard.trigger()
    with pytest.raises(TimeoutException):
        executor.wait_for_ready_callbacks(0.0, [])
    for _ in nodes:
        executor.spin_once(timeout_sec=WAIT_S)
    assert sorted(ran[2:]) == ["one", "two"]


def test_a_node_that_was_not_added_is_waited_for(context: Context, node: Node, executor: Executor) -> None:
    """It returns to its executor."""
    ran: list[int] = []
    guard = node.create_guard_condition(lambda: ran.append(1))
    with SingleThreadedExecutor(context=context) as home:
        home.add_node(node)
        guard.trigger()
        task, entity, of = executor.wait_for_ready_callbacks(WAIT_S, [node])
        assert (entity, of) == (guard, node)
        assert executor.get_nodes() == []
        assert home.get_nodes() == [node]
        task()
        guard.trigger()
        home.spin_once(timeout_sec=WAIT_S)
    assert ran == [1, 1]


def test_the_wait_ends(node: Node, executor: Executor) -> None:
    executor.add_node(node)
    with pytest.raises(TimeoutException):
        executor.wait_for_ready_callbacks(0.0)
    with pytest.raises(ConditionReachedException):
        executor.wait_for_ready_callbacks(condition=lambda: True)
    with pytest.raises(TypeError, match="wait_for_ready_callbacks"):
        executor.wait_for_ready_callbacks(0.0, [1])
    executor.shutdown()
    with pytest.raises(ShutdownException):
        executor.wait_for_ready_callbacks(0.0)


# A task that is not run


def published(node: Node, callback: Callable[[Any], Any], depth: int, numbers: range) -> Any:
    """Return a subscription to which `numbers` were published, and its publisher."""
    publisher = node.create_publisher(Int32, "numbers", latched(100))
    subscription = node.create_subscription(Int32, "numbers", callback, latched(depth))
    wait_until(subscription.get_publisher_count)
    for number in numbers:
        publisher.publish(Int32(data=number))
    return subscription, publisher


def task_of(executor: Executor, entity: Any) -> Any:
    while True:
        task, found, _ = executor.wait_for_ready_callbacks(WAIT_S)
        if found is entity:
            return task
        task()


@pytest.mark.parametrize("how", ["dropped", "kept", "spun", "moved", "by the handle"])
def test_a_task_that_is_not_run_has_taken_no_message(context_on_each_wire: Context, how: str) -> None:
    heard: list[int] = []
    node = Node("tester", context=context_on_each_wire)
    subscription, _ = published(node, lambda msg: heard.append(msg.data), 10, range(3))
    executors = [SingleThreadedExecutor(context=context_on_each_wire) for _ in range(2)]
    executors[0].add_node(node)
    task = task_of(executors[0], subscription)
    assert heard == []
    if how == "dropped":
        del task
        task_of(executors[0], subscription)()
    elif how == "kept":
        assert task_of(executors[0], subscription) is task
        task()
        assert task.done()
    elif how == "spun":
        wait_until(lambda: executors[0].spin_once(timeout_sec=0.01) or heard)
    elif how == "moved":
        executors[1].add_node(node)
        wait_until(lambda: executors[1].spin_once(timeout_sec=0.01) or heard)
        task()  # the next message, or nothing
    else:
        assert subscription.handle.take_message(Int32, raw=False)[0].data == 0
        heard.append(0)
        task()
    assert heard[0] == 0
    wait_until(lambda: executors[how == "moved"].spin_once(timeout_sec=0.01) or len(heard) == 3)
    assert heard == [0, 1, 2]
    for executor in executors:
        executor.shutdown()


@pytest.mark.parametrize("depth", [1, 2])
def test_newer_messages_replace_the_one_whose_task_waits(node: Node, executor: Executor, depth: int) -> None:
    heard: list[int] = []
    subscription, publisher = published(node, lambda msg: heard.append(msg.data), depth, range(1))
    executor.add_node(node)
    task = task_of(executor, subscription)
    for number in (1, 2, 3):
        publisher.publish(Int32(data=number))
    task()
    wait_until(lambda: executor.spin_once(timeout_sec=0.01) or heard[-1:] == [3])
    assert heard == [2, 3][-depth:]


def test_a_timer_s_period_begins_when_its_task_runs(node: Node, executor: Executor) -> None:
    ran: list[int] = []
    timer = node.create_timer(0.001, lambda: ran.append(1))
    executor.add_node(node)
    task = task_of(executor, timer)
    assert timer.is_ready()
    timer.cancel()
    task()
    assert ran == []
    timer.reset()
    task_of(executor, timer)()
    assert ran == [1]


def test_two_tasks_of_one_group_run_one_after_the_other(node: Node, executor: Executor) -> None:
    """The second does nothing while the first runs, and is returned anew."""
    order: list[str] = []
    gate: Future[None] = Future(executor=executor)

    async def first() -> None:
        order.append("first")
        await gate
        order.append("end")

    group = MutuallyExclusiveCallbackGroup()
    guards = [
        node.create_guard_condition(callback, group) for callback in (first, lambda: order.append("second"))
    ]
    for guard in guards:
        guard.trigger()
    executor.add_node(node)
    tasks = [task_of(executor, guard) for guard in guards]
    for task in tasks:
        task()
    assert order == ["first"]
    assert tasks[1].done()
    gate.set_result(None)
    while len(order) < 3:
        executor.wait_for_ready_callbacks(WAIT_S)[0]()
    assert order == ["first", "end", "second"]


def test_a_program_s_task_is_returned_until_it_is_run(executor: Executor) -> None:
    task = executor.create_task(lambda: 5)
    for _ in range(2):
        assert executor.wait_for_ready_callbacks(WAIT_S) == (task, None, None)
    task()
    assert task.result() == 5
    with pytest.raises(TimeoutException):
        executor.wait_for_ready_callbacks(0.0)
    assert executor._offered == {}
    assert executor._tasks == {}


def test_a_task_that_is_cancelled_unbegun_leaves_its_message(node: Node, executor: Executor) -> None:
    heard: list[int] = []
    subscription, _ = published(node, lambda msg: heard.append(msg.data), 10, range(1))
    executor.add_node(node)
    task_of(executor, subscription).cancel()
    task_of(executor, subscription)()
    assert heard == [0]


def test_names_by_which_other_projects_cancel_tasks(executor: Executor) -> None:
    async def wait() -> None:
        await Future()

    task = executor.create_task(wait())
    executor.spin_once(timeout_sec=0)
    called: list[Any] = []
    task.add_done_callback(called.append)
    assert task._pending()
    with task._task_lock, task._lock:
        task._handler.close()
        task._cancelled = True
    task._schedule_or_invoke_done_callbacks()
    executor.spin_once(timeout_sec=WAIT_S)
    assert called == [task]
    assert not task._pending()
    assert executor._tasks == {}
    assert Future()._executor() is None
    future = Future()
    future._set_executor(executor)
    assert future._executor() is executor


class Counts(Waitable):
    """Is ready after each trigger of its guard condition."""

    def __init__(self, group: CallbackGroup) -> None:
        super().__init__(group)
        self.guard = GuardCondition(None, None)
        self.data_taken = 0
        self.executed: list[int] = []

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        self.index = wait_set.add_guard_condition(self.guard)

    def get_num_entities(self) -> NumberOfEntities:
        return NumberOfEntities(num_gcs=1)

    def is_ready(self, wait_set: WaitSet) -> bool:
        return wait_set.is_ready("guard_condition", self.index)

    def take_data(self) -> int:
        self.data_taken += 1
        return self.data_taken

    async def execute(self, taken_data: int) -> None:
        self.executed.append(taken_data)


def test_the_data_of_a_waitable_are_taken_when_its_task_runs(node: Node, executor: Executor) -> None:
    waitable = Counts(node.default_callback_group)
    node.add_waitable(waitable)
    executor.add_node(node)
    waitable.guard.trigger()
    task = task_of(executor, waitable)
    assert waitable.data_taken == 0
    task()
    assert waitable.executed == [1]
    with pytest.raises(TimeoutException):
        executor.wait_for_ready_callbacks(0.0)


def test_a_response_ends_the_wait(node: Node, executor: Executor) -> None:
    """A loop over `spin_once` of a program's own executor looks at its future afterwards."""
    node.create_service(Trigger, "serve", lambda _, response: response)
    client = node.create_client(Trigger, "serve")
    assert client.wait_for_service(WAIT_S)
    executor.add_node(node)
    future = client.call_async(Trigger.Request())
    kinds: list[Any] = []
    while not future.done():
        task, entity, _ = executor.wait_for_ready_callbacks()
        task()
        kinds.append(entity)
    assert kinds[-1] is client


# Members of groups


class Asked(CallbackGroup):
    """Admits all, and keeps what it was asked about."""

    def __init__(self) -> None:
        super().__init__()
        self.asked: set[Any] = set()
        self.running: list[Any] = []

    def can_execute(self, entity: Any) -> bool:
        self.asked.add(entity)
        return True

    def beginning_execution(self, entity: Any) -> bool:
        self.running.append(entity)
        return True

    def ending_execution(self, entity: Any) -> None:
        self.running.remove(entity)


def test_a_group_knows_clients_and_actions(node: Node, executor: Executor) -> None:
    group = Asked()
    service = node.create_service(Trigger, "serve", lambda _, response: response, callback_group=group)
    client = node.create_client(Trigger, "serve", callback_group=group)
    server = ActionServer(node, Fibonacci, "count", succeed, callback_group=group)
    action = ActionClient(node, Fibonacci, "count", callback_group=group)
    waitable = Counts(group)
    node.add_waitable(waitable)
    members = {service, client, server, action, waitable}
    assert {member() for member in group.entities} == members
    assert all(group.has_entity(member) for member in members)
    assert client.wait_for_service(WAIT_S)
    assert action.wait_for_server(WAIT_S)
    executor.add_node(node)
    waitable.guard.trigger()
    called, sent = client.call_async(Trigger.Request()), action.send_goal_async(Fibonacci.Goal())
    for future in (called, sent):
        executor.spin_until_future_complete(future, timeout_sec=WAIT_S)
    executor.spin_until_future_complete(sent.result().get_result_async(), timeout_sec=WAIT_S)
    wait_until(lambda: executor.spin_once(timeout_sec=0.01) or waitable.executed)
    assert group.asked == members
    assert action.callback_group is server.callback_group is group
    assert group.running == []


def test_what_a_group_of_the_program_refused_runs_when_it_is_free(node: Node, pool: PoolExecutor) -> None:
    """On a thread of a pool, whose end wakes nothing else."""

    class OneAtATime(Asked):
        def can_execute(self, entity: Any) -> bool:
            return not self.running

        def beginning_execution(self, entity: Any) -> bool:
            return self.can_execute(entity) and super().beginning_execution(entity)

    group, begun, gate, ran = OneAtATime(), threading.Event(), threading.Event(), threading.Event()

    def first() -> None:
        begun.set()
        assert gate.wait(WAIT_S)

    one, two = (node.create_guard_condition(callback, group) for callback in (first, ran.set))
    pool.add_node(node)
    with spinning(pool):
        one.trigger()
        assert begun.wait(WAIT_S)
        two.trigger()
        wait_until(lambda: len(set(pool._unadmitted)) == 2)  # the first one may have more, too
        gate.set()
        assert ran.wait(WAIT_S)


def test_a_group_forgets_members_that_are_gone(node: Node) -> None:
    group = MutuallyExclusiveCallbackGroup()
    kept = node.create_guard_condition(lambda: None, group)
    for _ in range(5 * MIN_PURGED):
        node.destroy_guard_condition(node.create_guard_condition(lambda: None, group))
    gc.collect()
    node.create_guard_condition(lambda: None, group)
    assert len(group.entities) <= MIN_PURGED + 1
    assert weakref.ref(kept) in group.entities


# Spins inside callbacks of a MultiThreadedExecutor


NESTED_SPINS: dict[str, Callable[[Executor, Node, Future[Any]], None]] = {
    "spin_until_future_complete": lambda executor, _, future: executor.spin_until_future_complete(future, 10),
    "rclpy's": lambda executor, node, future: rclpy.spin_until_future_complete(node, future, executor, 10),
    "spin_once": lambda executor, _, future: [executor.spin_once() for _ in iter(future.done, True)] and None,
    "spin_once with a timeout": lambda executor, _, future: (
        [executor.spin_once(timeout_sec=0.05) for _ in iter(future.done, True)] and None
    ),
}
OUTER_SPINS: dict[str, Callable[[Executor], None]] = {
    "spin": lambda executor: executor.spin(),
    "spin_once": lambda executor: (
        [executor.spin_once(timeout_sec=0.05) for _ in iter(lambda: executor.is_shutdown, True)] and None
    ),
    "spin_once without a timeout": lambda executor: (
        [executor.spin_once() for _ in iter(lambda: executor.is_shutdown, True)] and None
    ),
}


@pytest.mark.parametrize("own", [False, True], ids=["MultiThreadedExecutor", "own executor"])
@pytest.mark.parametrize("outer", OUTER_SPINS)
@pytest.mark.parametrize("nested", NESTED_SPINS)
def test_a_callback_on_a_thread_spins_its_executor(
    context: Context, node: Node, nested: str, outer: str, own: bool
) -> None:
    group = ReentrantCallbackGroup()
    node.create_service(Trigger, "serve", lambda _, r: Trigger.Response(success=True), callback_group=group)
    client = node.create_client(Trigger, "serve", callback_group=group)
    assert client.wait_for_service(WAIT_S)
    executor: Any = PoolExecutor(context) if own else MultiThreadedExecutor(4, context=context)

    def work() -> bool:
        future = client.call_async(Trigger.Request())
        NESTED_SPINS[nested](executor, node, future)
        return bool(future.result().success)

    executor.add_node(node)
    with spinning(executor, lambda: OUTER_SPINS[outer](executor)) as errors:
        assert [done(executor.create_task(work)) for _ in range(5)] == [True] * 5
        # Two at once, and the executor goes on.
        tasks = [executor.create_task(work) for _ in range(2)]
        assert [done(task) for task in tasks] == [True] * 2
    assert errors == []


def test_a_nested_spin_goes_on_when_the_one_around_it_ends(context: Context, node: Node) -> None:
    future, begun, ended = Future[None](), Future[None](), threading.Event()

    def nested() -> None:
        timer.cancel()
        begun.set_result(None)
        executor.spin_until_future_complete(future)
        ended.set()

    timer = node.create_timer(0.0, nested, ReentrantCallbackGroup())
    with MultiThreadedExecutor(2, context=context) as executor:
        executor.add_node(node)
        executor.spin_until_future_complete(begun, timeout_sec=WAIT_S)
        # Nobody else spins from here on.
        node.create_timer(0.01, lambda: future.set_result(None), ReentrantCallbackGroup())
        assert ended.wait(WAIT_S)
        after: Future[None] = Future()
        node.create_timer(0.0, lambda: after.set_result(None), ReentrantCallbackGroup())
        executor.spin_until_future_complete(after, timeout_sec=WAIT_S)
        assert after.done()


def test_an_error_beside_a_nested_spin_ends_the_spin_around_it_alone(context: Context, node: Node) -> None:
    future, nested_results = Future[None](), []
    begun = threading.Event()

    def nested() -> None:
        timer.cancel()
        begun.set()
        try:
            executor.spin_until_future_complete(future, timeout_sec=WAIT_S)
            nested_results.append(future.done())
        except ZeroDivisionError as error:
            nested_results.append(error)

    def fail() -> None:
        failing.cancel()
        assert begun.wait(WAIT_S)
        raise ZeroDivisionError

    timer = node.create_timer(0.0, nested, ReentrantCallbackGroup())
    failing = node.create_timer(0.0, fail, ReentrantCallbackGroup())
    with MultiThreadedExecutor(3, context=context) as executor:
        executor.add_node(node)
        with pytest.raises(ZeroDivisionError):
            executor.spin_until_future_complete(Future[None](), timeout_sec=WAIT_S)
        future.set_result(None)
        wait_until(lambda: nested_results)
    assert nested_results == [True]


@pytest.mark.parametrize("end", ["timeout", "shutdown", "context"])
def test_a_nested_spin_ends(context: Context, node: Node, end: str) -> None:
    ends: list[str] = []
    begun = threading.Event()

    def nested() -> None:
        timer.cancel()
        begun.set()
        try:
            executor.spin_until_future_complete(
                Future[None](), timeout_sec=0.05 if end == "timeout" else None
            )
            ends.append("returned")
        except ExternalShutdownException:
            ends.append("raised")

    timer = node.create_timer(0.0, nested, ReentrantCallbackGroup())
    executor = MultiThreadedExecutor(2, context=context)
    executor.add_node(node)
    with spinning(executor):
        assert begun.wait(WAIT_S)
        if end == "shutdown":
            executor.shutdown(WAIT_S)
        elif end == "context":
            context.shutdown()
        wait_until(lambda: ends)
    assert ends in (["returned"], ["raised"] if end == "context" else ["returned"])


@pytest.mark.parametrize("exists", [False, True])
def test_a_wait_for_a_server_takes_a_duration(node: Node, exists: bool) -> None:
    client, action = node.create_client(Trigger, "serve"), ActionClient(node, Fibonacci, "count")
    wait = Duration(seconds=0.01)
    if exists:
        wait = Duration(seconds=WAIT_S)
        node.create_service(Trigger, "serve", lambda _, response: response)
        ActionServer(node, Fibonacci, "count", succeed)
    assert client.wait_for_service(wait) == action.wait_for_server(wait) == exists


def test_a_single_thread_is_warned_of(context: Context) -> None:
    with pytest.warns(UserWarning, match="MultiThreadedExecutor is used with a single thread."):
        MultiThreadedExecutor(num_threads=1, context=context).shutdown()
