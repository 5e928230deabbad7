"""Actions between processes: all outcomes of a goal, and processes killed during one."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import Program, wait_until
from tests.node.wire.conftest import PROGRAMS

from tfloom.interfaces.action_msgs.msg import GoalStatus, GoalStatusArray
from tfloom.interfaces.action_msgs.srv import CancelGoal
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.node.action.client import ActionClient
from tfloom.node.endpoints.client import NoResponseError
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.qos.qos import qos_profile_action_status_default
from tfloom.rmw.typed_names import new_goal_id

Start = Callable[..., Program]
Finish = Callable[..., Any]
SpinUntil = Callable[..., None]

WAITS = 100  # a goal that waits until it is cancelled


@pytest.fixture(autouse=True)
def local_wire(wire_of_module: str) -> str:
    return wire_of_module


@pytest.fixture
def domain_id(module_domain_id: int, start_program: Start) -> int:
    """Return the module's domain. The test's node ends before its programs; see `domain_id` of tests/conftest.py."""
    return module_domain_id


@pytest.fixture(scope="module")
def server(wire_of_module: str, start_module_program: Start) -> Iterator[Program]:
    """Return the server that most tests share."""
    program = start_module_program("python", PROGRAMS / "action_server.py", "fibonacci", "900")
    program.wait_for("ready")
    yield program
    program.end()


def connected(node: Node, name: str) -> ActionClient:
    client = ActionClient(node, Fibonacci, name)
    assert client.wait_for_server(timeout_sec=20)
    return client


@pytest.fixture
def client(node: Node, server: Program) -> ActionClient:
    return connected(node, "fibonacci")


def test_server_that_is_discovered_is_ready_at_the_first_question(node: Node, server: Program) -> None:
    client = ActionClient(node, Fibonacci, "fibonacci")
    services = [
        service_client.wire_endpoint for service_client in (client._send, client._result, client._cancel)
    ]
    topics = [client._feedback, client._status]
    wait_until(
        lambda: (
            all(service._servers._is_matched() for service in services)
            and all(topic.get_publisher_count() for topic in topics)
        )
    )
    assert client.server_is_ready()
    assert send(client, 2) is not None


def send(client: ActionClient, order: int, **options: Any) -> Future[Any]:
    return client.send_goal_async(Fibonacci.Goal(order=order), **options)


def test_goal_is_accepted_gives_feedback_and_succeeds(
    client: ActionClient, finish: Finish, spin_until: SpinUntil
) -> None:
    feedback: list[list[int]] = []
    sent = send(client, 5, feedback_callback=lambda message: feedback.append(list(message.feedback.sequence)))
    handle = finish(sent)
    assert handle.accepted
    assert handle.stamp.sec > 0
    for _ in range(2):  # the result is kept
        response = finish(handle.get_result_async())
        assert response.status == handle.status == GoalStatus.STATUS_SUCCEEDED
        assert list(response.result.sequence) == [0, 1, 1, 2, 3, 5]
    spin_until(lambda: len(feedback) == 4)
    assert feedback[-1] == [0, 1, 1, 2, 3, 5]


def test_single_goal_is_cancelled(client: ActionClient, finish: Finish, spin_until: SpinUntil) -> None:
    handle = finish(send(client, WAITS))
    spin_until(lambda: handle.status == GoalStatus.STATUS_EXECUTING)
    response = finish(handle.cancel_goal_async())
    assert response.return_code == CancelGoal.Response.ERROR_NONE
    assert [goal_info.goal_id for goal_info in response.goals_canceling] == [handle.goal_id]
    assert finish(handle.get_result_async()).status == GoalStatus.STATUS_CANCELED
    again = finish(handle.cancel_goal_async())
    assert again.return_code == CancelGoal.Response.ERROR_GOAL_TERMINATED
    unknown = finish(client.cancel(new_goal_id()))
    assert unknown.return_code == CancelGoal.Response.ERROR_UNKNOWN_GOAL_ID


def test_several_goals_of_several_clients_run_at_once(
    client: ActionClient, make_node: Callable[..., Node], executor: SingleThreadedExecutor, finish: Finish
) -> None:
    other_node = make_node("other")
    executor.add_node(other_node)
    other = connected(other_node, "fibonacci")
    waiting = finish(send(client, WAITS))
    handles = [
        finish(future) for order in (3, 5, 7) for future in (send(client, order), send(other, order + 1))
    ]
    results = [handle.get_result_async() for handle in handles]
    lengths = [len(finish(result).result.sequence) for result in results]
    assert lengths == [4, 5, 6, 7, 8, 9]
    assert waiting.status == GoalStatus.STATUS_EXECUTING
    finish(waiting.cancel_goal_async())


def test_late_client_receives_the_states_of_all_goals(
    client: ActionClient, node: Node, finish: Finish, spin_until: SpinUntil
) -> None:
    done, waiting = (finish(send(client, order)) for order in (2, WAITS))
    finish(done.get_result_async())
    spin_until(lambda: waiting.status == GoalStatus.STATUS_EXECUTING)
    told: list[GoalStatusArray] = []
    qos = qos_profile_action_status_default
    node.create_subscription(GoalStatusArray, "fibonacci/_action/status", told.append, qos)
    spin_until(lambda: told)
    states = {
        bytes(goal_status.goal_info.goal_id.uuid): goal_status.status for goal_status in told[0].status_list
    }
    assert states[bytes(done.goal_id.uuid)] == GoalStatus.STATUS_SUCCEEDED
    assert states[bytes(waiting.goal_id.uuid)] == GoalStatus.STATUS_EXECUTING
    finish(waiting.cancel_goal_async())


def test_results_are_kept_for_the_timeout_of_the_server(
    node: Node, start: Start, finish: Finish, spin_until: SpinUntil
) -> None:
    start("action_server", "forgetful", 0.3)
    client = connected(node, "forgetful")
    handle = finish(send(client, 2))
    assert finish(handle.get_result_async()).status == GoalStatus.STATUS_SUCCEEDED
    spin_until(lambda: finish(handle.get_result_async()).status == GoalStatus.STATUS_UNKNOWN)
    assert finish(client.cancel(handle.goal_id)).return_code == CancelGoal.Response.ERROR_UNKNOWN_GOAL_ID


def test_server_can_be_destroyed_during_a_goal_and_recreated(
    client: ActionClient, server: Program, finish: Finish, executor: SingleThreadedExecutor
) -> None:
    finish(send(client, 70))
    server.wait_for("destroyed False 0")

    def is_answered() -> bool:
        """Send a goal; one sent before the old server has left the graph gets no response."""
        assert client.wait_for_server(timeout_sec=20)
        sent.append(send(client, 4))
        executor.spin_until_future_complete(sent[-1], timeout_sec=1.0)
        return sent[-1].done() and sent[-1].exception() is None

    sent: list[Future[Any]] = []
    wait_until(is_answered)
    response = finish(sent[-1].result().get_result_async())
    assert response.status == GoalStatus.STATUS_SUCCEEDED
    assert "Traceback" not in server.output


def test_server_continues_after_a_client_is_killed_during_a_goal(
    client: ActionClient, server: Program, start: Start, finish: Finish
) -> None:
    begun = server.lines.count("executing 100")
    other = start("action_client")
    assert other.lines == ["accepted ready"]
    wait_until(lambda: server.lines.count("executing 100") > begun)
    other.signal(signal.SIGKILL)
    other.wait()
    assert finish(finish(send(client, 3)).get_result_async()).status == GoalStatus.STATUS_SUCCEEDED
    response = finish(client._cancel.call_async(CancelGoal.Request()))
    assert len(response.goals_canceling) == 1
    assert finish(finish(send(client, 4)).get_result_async()).status == GoalStatus.STATUS_SUCCEEDED


def test_restarted_server_accepts_goals_after_a_kill(
    short_lease: float, node: Node, start: Start, finish: Finish, executor: SingleThreadedExecutor
) -> None:
    server = start("action_server", "restarted", 900)
    client = connected(node, "restarted")
    handle = finish(send(client, WAITS))
    result = handle.get_result_async()
    server.wait_for("executing 100")
    server.signal(signal.SIGKILL)
    server.wait()
    wait_until(lambda: not client.server_is_ready())
    assert not client.wait_for_server(timeout_sec=0.0)
    executor.spin_until_future_complete(result, timeout_sec=20)
    assert isinstance(result.exception(), NoResponseError)
    start("action_server", "restarted", 900)
    assert client.wait_for_server(timeout_sec=20)
    assert finish(finish(send(client, 4)).get_result_async()).status == GoalStatus.STATUS_SUCCEEDED
    assert (
        finish(handle.get_result_async()).status == GoalStatus.STATUS_UNKNOWN
    )  # the new server doesn't have that goal
