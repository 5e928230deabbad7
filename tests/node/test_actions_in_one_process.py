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


def test_an_error_of_the_callback_comes_out_of_spin_after_the_acceptance(
    executor: Executor, node: Node, client: ActionClient
) -> None:
    def handle_accepted(_: ServerGoalHandle) -> None:
        raise KeyError("mine")

    ActionServer(node, Fibonacci, "count", succeed, handle_accepted_callback=handle_accepted)
    assert client.wait_for_server(30)
    future = client.send_goal_async(Fibonacci.Goal())
    with pytest.raises(KeyError, match="mine"):
        executor.spin_until_future_complete(future, timeout_sec=30)
    assert finish(executor, future).accepted


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


def test_an_error_in_feedback_leaves_the_result_complete(
    executor: Executor, node: Node, client: ActionClient
) -> None:
    def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        return succeed(goal_handle)

    def fail(_: Any) -> None:
        raise KeyError("mine")

    goals: list[ServerGoalHandle] = []
    ActionServer(node, Fibonacci, "count", execute, handle_accepted_callback=goals.append)
    assert client.wait_for_server(30)
    sent = client.send_goal_async(Fibonacci.Goal(), feedback_callback=fail)
    result = finish(executor, sent).get_result_async()
    goals[0].execute()
    with pytest.raises(KeyError, match="mine"):
        executor.spin_until_future_complete(result, timeout_sec=30)
    assert list(finish(executor, result).result.sequence) == [1]


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


def test_threads_deliver_feedback_and_result(context: Context, node: Node, client: ActionClient) -> None:
    heard: list[int] = []

    def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        for number in range(5):
            goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[number]))
        return succeed(goal_handle)

    ActionServer(node, Fibonacci, "count", execute)
    with MultiThreadedExecutor(context=context) as executor:
        executor.add_node(node)
        assert client.wait_for_server(30)
        sent = client.send_goal_async(
            Fibonacci.Goal(), feedback_callback=lambda message: heard.append(message.feedback.sequence[0])
        )
        result = finish(executor, finish(executor, sent).get_result_async())
        assert list(result.result.sequence) == [1]
        everything: Future[None] = Future()
        spinning = threading.Thread(target=executor.spin_until_future_complete, args=(everything,))
        spinning.start()
        wait_until(lambda: len(heard) == 5)
        everything.set_result(None)
        spinning.join(30)
    assert heard == [0, 1, 2, 3, 4]


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
