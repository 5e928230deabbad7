"""A server and a client of an action on one executor: what has run when a future is complete; on both wires."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer, ServerGoalHandle
from tfloom.node.context.context import Context
from tfloom.node.executing.callback_groups import ReentrantCallbackGroup
from tfloom.node.executing.events_executor import EventsExecutor
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node


@pytest.fixture
def context(context_on_each_wire: Context) -> Context:
    return context_on_each_wire


@pytest.fixture(params=[SingleThreadedExecutor, EventsExecutor])
def executor(request: pytest.FixtureRequest, context: Context, node: Node) -> Iterator[Executor]:
    with request.param(context=context) as executor:
        executor.add_node(node)
        yield executor


@pytest.fixture
def client(node: Node) -> ActionClient:
    return ActionClient(node, Fibonacci, "count")


def finish(executor: Executor, future: Future[Any]) -> Any:
    executor.spin_until_future_complete(future, timeout_sec=30)
    assert future.done()
    return future.result()


def succeed(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
    goal_handle.succeed()
    return Fibonacci.Result(sequence=[1])


def test_the_goal_is_executed_when_its_future_is_complete(
    executor: Executor, node: Node, client: ActionClient
) -> None:
    ran: list[str] = []

    def handle_accepted(goal_handle: ServerGoalHandle) -> None:
        ran.append("accepted")
        goal_handle.execute()

    def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        ran.append("executed")
        return succeed(goal_handle)

    ActionServer(node, Fibonacci, "count", execute, handle_accepted_callback=handle_accepted)
    assert client.wait_for_server(30)
    for _ in range(10):
        finish(executor, client.send_goal_async(Fibonacci.Goal()))
        assert ran == ["accepted", "executed"]
        ran.clear()


def test_a_coroutine_has_run_to_its_first_wait(executor: Executor, node: Node, client: ActionClient) -> None:
    gate: Future[None] = Future(executor=executor)
    ran: list[str] = []

    async def handle_accepted(goal_handle: ServerGoalHandle) -> None:
        ran.append("accepted")
        goal_handle.execute()

    async def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        ran.append("begun")
        await gate
        ran.append("ended")
        return succeed(goal_handle)

    ActionServer(node, Fibonacci, "count", execute, handle_accepted_callback=handle_accepted)
    assert client.wait_for_server(30)
    handle = finish(executor, client.send_goal_async(Fibonacci.Goal()))
    assert ran == ["accepted", "begun"]
    gate.set_result(None)
    assert list(finish(executor, handle.get_result_async()).result.sequence) == [1]
    assert ran == ["accepted", "begun", "ended"]


def test_all_feedback_comes_before_the_result_and_none_after(
    executor: Executor, node: Node, client: ActionClient
) -> None:
    """The server publishes one more after the goal's end."""
    heard: list[int] = []

    def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        for number in range(5):
            goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[number]))
        return succeed(goal_handle)

    def publish_late() -> None:
        late.cancel()
        goals[0].publish_feedback(Fibonacci.Feedback(sequence=[99]))

    goals: list[ServerGoalHandle] = []

    def handle_accepted(goal_handle: ServerGoalHandle) -> None:
        goals.append(goal_handle)
        goal_handle.execute()

    ActionServer(node, Fibonacci, "count", execute, handle_accepted_callback=handle_accepted)
    assert client.wait_for_server(30)
    sent = client.send_goal_async(
        Fibonacci.Goal(), feedback_callback=lambda message: heard.append(message.feedback.sequence[0])
    )
    handle = finish(executor, sent)
    finish(executor, handle.get_result_async())
    assert heard == [0, 1, 2, 3, 4]
    taken: Future[None] = Future(executor=executor)
    client._feedback.callback = _then(client._feedback.callback, lambda: taken.set_result(None))
    late = node.create_timer(0.0, publish_late)
    finish(executor, taken)
    assert heard == [0, 1, 2, 3, 4]


def _then(callback: Callable[..., Any], follow: Callable[[], None]) -> Callable[[Any, Any], Any]:
    def both(message: Any, info: Any) -> Any:
        callback(message, info)
        follow()

    return both


def test_a_nested_spin_in_the_clients_group_gets_its_result(
    executor: Executor, node: Node, client: ActionClient
) -> None:
    """The feedback's callback can't run meanwhile: its group is that of the callback that spins."""
    group = ReentrantCallbackGroup()
    heard: list[int] = []
    done: Future[None] = Future(executor=executor)

    def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        return succeed(goal_handle)

    def send() -> None:
        timer.cancel()
        sent = client.send_goal_async(
            Fibonacci.Goal(), feedback_callback=lambda message: heard.append(message.feedback.sequence[0])
        )
        finish(executor, finish(executor, sent).get_result_async())
        done.set_result(None)

    ActionServer(node, Fibonacci, "count", execute, callback_group=group)
    assert client.wait_for_server(30)
    timer = node.create_timer(0.0, send)
    finish(executor, done)


@pytest.mark.parametrize("group", [None, ReentrantCallbackGroup], ids=["exclusive", "reentrant"])
def test_threads_deliver_all_feedback_before_the_result(
    context: Context, node: Node, group: type[ReentrantCallbackGroup] | None
) -> None:
    """Goal after goal, while other callbacks keep the threads busy."""
    heard: dict[int, list[int]] = {}
    at_end: dict[int, list[int]] = {}

    def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        for number in range(5):
            goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[number]))
        return succeed(goal_handle)

    client = ActionClient(node, Fibonacci, "count", callback_group=group() if group else None)
    ActionServer(node, Fibonacci, "count", execute, callback_group=ReentrantCallbackGroup())
    node.create_timer(0.001, lambda: sum(range(1000)), ReentrantCallbackGroup())
    with MultiThreadedExecutor(3, context=context) as executor:
        executor.add_node(node)
        assert client.wait_for_server(30)
        for goal in range(40):
            heard[goal] = []

            def hear(message: Any, goal: int = goal) -> None:
                heard[goal].append(message.feedback.sequence[0])

            noted: Future[None] = Future(executor=executor)

            def note(_: Any, goal: int = goal, noted: Future[None] = noted) -> None:
                at_end[goal] = sorted(heard[goal])
                noted.set_result(None)

            handle = finish(executor, client.send_goal_async(Fibonacci.Goal(), feedback_callback=hear))
            result = handle.get_result_async()
            result.add_done_callback(note)
            assert list(finish(executor, result).result.sequence) == [1]
            assert sorted(heard[goal]) == [0, 1, 2, 3, 4]
            finish(executor, noted)  # another thread may run it after this one has found the result
    assert at_end == {goal: [0, 1, 2, 3, 4] for goal in range(40)}


def test_a_goal_that_comes_while_its_server_is_created_is_executed(
    context: Context, node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each service answers as soon as it is there, and each part that is created after it comes late."""
    client = ActionClient(node, Fibonacci, "count")
    goals: list[Future[Any]] = []
    create_service = node.create_service

    def create_and_wait_for_a_goal(*args: Any, **options: Any) -> Any:
        service = create_service(*args, **options)
        if service.service_name.endswith("send_goal"):
            assert client._send.wait_for_service(30)
            goals.append(client.send_goal_async(Fibonacci.Goal()))
            wait_until(lambda: goals[0].done() or not spinning.is_alive())
        return service

    monkeypatch.setattr(node, "create_service", create_and_wait_for_a_goal)
    end: Future[None] = Future()
    with MultiThreadedExecutor(3, context=context) as executor:
        executor.add_node(node)
        spinning = threading.Thread(target=executor.spin_until_future_complete, args=(end,))
        spinning.start()
        try:
            ActionServer(node, Fibonacci, "count", succeed, callback_group=ReentrantCallbackGroup())
            result = goals[0].result().get_result_async()
            wait_until(result.done)
        finally:
            end.set_result(None)
            spinning.join()
    assert list(result.result().result.sequence) == [1]


def run_with_threads(
    executor: Executor, node: Node, begin: Callable[[], None], group: Any = None
) -> tuple[Future[None], threading.Thread]:
    """Call a function in a callback of the node; return a future that ends the spin, and the thread that spins."""

    def once() -> None:
        timer.cancel()
        begin()

    timer = node.create_timer(0.0, once, group)
    end: Future[None] = Future()
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin_until_future_complete, args=(end,))
    spinning.start()
    return end, spinning


@pytest.mark.filterwarnings("ignore:MultiThreadedExecutor is used with a single thread")
@pytest.mark.parametrize("case", ["own group", "all threads", "feedback itself"])
def test_a_result_is_not_held_back_by_what_waits_for_it(
    context: Context, node: Node, case: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its feedback can't run: its group is that of the waiting callback, or no thread is free, or it waits itself."""
    monkeypatch.setattr("tfloom.node.executing.executors.MAX_HOLD_NS", 300_000_000)
    group = ReentrantCallbackGroup()
    goals: list[ServerGoalHandle] = []
    results: list[Any] = []
    handles: list[Any] = []

    def handle_accepted(goal_handle: ServerGoalHandle) -> None:
        goals.append(goal_handle)
        if case != "feedback itself":
            goal_handle.execute()

    def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        return succeed(goal_handle)

    server_node = Node("server", context=context)
    client = ActionClient(
        node, Fibonacci, "count", callback_group=None if case == "own group" else ReentrantCallbackGroup()
    )
    ActionServer(
        server_node,
        Fibonacci,
        "count",
        execute,
        handle_accepted_callback=handle_accepted,
        callback_group=group,
    )

    def hear(message: Any) -> None:
        if case == "feedback itself":
            results.append(handles[0].get_result())

    def execute_it(sent: Future[Any]) -> None:
        handles.append(sent.result())
        wait_until(lambda: goals)
        goals[0].execute()

    def send() -> None:
        if case == "feedback itself":
            sent = client.send_goal_async(Fibonacci.Goal(), feedback_callback=hear)
            sent.add_done_callback(execute_it)
        else:
            results.append(client.send_goal(Fibonacci.Goal(), feedback_callback=hear))

    with (
        MultiThreadedExecutor(1 if case == "all threads" else 2, context=context) as executor,
        MultiThreadedExecutor(context=context) as servers,
    ):
        server_end, serving = run_with_threads(servers, server_node, lambda: None)
        assert client.wait_for_server(30)
        end, spinning = run_with_threads(executor, node, send)
        wait_until(lambda: results)
        for future, thread in ((end, spinning), (server_end, serving)):
            future.set_result(None)
            thread.join(30)
    assert list(results[0].result.sequence) == [1]


def test_a_result_of_a_node_that_leaves_its_threads_is_delivered(context: Context, node: Node) -> None:
    """The node is removed while its feedback's callback still runs."""
    begun, gate = threading.Event(), threading.Event()
    done = threading.Event()

    def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        return succeed(goal_handle)

    def hear(_: Any) -> None:
        begun.set()
        gate.wait(30)

    client = ActionClient(node, Fibonacci, "count")
    ActionServer(node, Fibonacci, "count", execute, callback_group=ReentrantCallbackGroup())
    with MultiThreadedExecutor(3, context=context) as executor:

        def send() -> None:
            sent = client.send_goal_async(Fibonacci.Goal(), feedback_callback=hear)
            sent.add_done_callback(lambda sent: sent.result().get_result_async().when_complete(done.set))

        end, spinning = run_with_threads(executor, node, send)
        assert begun.wait(30)
        wait_until(lambda: executor._held)
        assert not done.is_set()
        executor.remove_node(node)
        assert done.wait(30)
        gate.set()
        end.set_result(None)
        spinning.join(30)


def test_threads_that_all_wait_get_their_responses(context: Context, node: Node) -> None:
    """A response isn't kept behind tasks that wait for a free thread."""
    group = ReentrantCallbackGroup()
    node.create_service(
        AddTwoInts,
        "add",
        lambda request, response: AddTwoInts.Response(sum=request.a + request.b),
        callback_group=group,
    )
    adding = node.create_client(AddTwoInts, "add", callback_group=group)
    sums: list[int] = []
    tasks: list[Any] = []

    with MultiThreadedExecutor(2, context=context) as executor:

        def call() -> None:
            timer.cancel()
            tasks.extend(executor.create_task(lambda: None) for _ in range(10))
            sums.append(adding.call(AddTwoInts.Request(a=1, b=2), timeout_sec=30).sum)

        timer = node.create_timer(0.0, call, group)
        executor.add_node(node)
        assert adding.wait_for_service(30)
        end: Future[None] = Future()
        spinning = threading.Thread(target=executor.spin_until_future_complete, args=(end,))
        spinning.start()
        wait_until(lambda: sums == [3] and len(tasks) == 10 and all(task.done() for task in tasks))
        end.set_result(None)
        spinning.join(30)


def test_tasks_run_in_the_order_of_their_creation(
    executor: Executor, deviations: dict[str, dict[str, str]]
) -> None:
    assert "node-task-order" in deviations
    ran: list[int] = []
    tasks = [executor.create_task(ran.append, number) for number in range(5)]
    finish(executor, tasks[-1])
    assert ran == [0, 1, 2, 3, 4]
