"""The process at the other end of a call or a goal is ended at each step: this end reports it, and keeps nothing.

One process stops at all steps, each with its own client or server.
"""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psutil
import pytest
from tests.conftest import Program, wait_until

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer, CancelResponse, GoalResponse
from tfloom.node.endpoints.client import NoResponseError
from tfloom.node.executing.callback_groups import ReentrantCallbackGroup
from tfloom.node.executing.executors import MultiThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.rmw.zenoh.services import MAX_WAIT_FOR_END_S

PROGRAMS = Path(__file__).parent / "programs"
Start = Callable[..., Program]
Kill = Callable[[Program], None]

CALL_STEPS = ("gone", "unread", "taken", "responded")
"""Steps of a call at which its server ends: `gone` before the request is sent, `unread` before it is taken."""
GOAL_STEPS = ("gone", "unread", "deciding", "accepted", "executing", "feedback", "succeeded", "finished")
ANSWERED = ("responded", "finished")
"""The steps at which the client has the response or the result, of a server that stops at none."""
CLIENT_CALL_STEPS = ("called", "answered")
CLIENT_GOAL_STEPS = (
    *("goal sent", "goal accepted", "result requested", "feedback received", "cancel requested"),
    "result received",
)
TOLD_S = 20.0 + MAX_WAIT_FOR_END_S
"""Time after the end of a process in which the other is told: the lease of 3 s, on a busy machine, and on Zenoh, whose
router may keep a request that comes while the server's link closes, the limit of the wait for a request's end [s]."""


def kill(program: Program) -> None:
    program.signal(signal.SIGKILL)


def pause_and_kill(program: Program) -> None:
    program.pause()
    program.signal(signal.SIGKILL)


def terminate(program: Program) -> None:
    program.signal(signal.SIGTERM)


ALL_ENDS = [
    kill,
    pytest.param(pause_and_kill, marks=pytest.mark.slow),
    pytest.param(terminate, marks=pytest.mark.slow),
]


class Exchange:
    """A call or a goal with the server that stops at a step, and its end."""

    def __init__(self, step: str, *, is_goal: bool, program: Program, node: Node) -> None:
        self.step, self.is_goal, self.program, self.node = step, is_goal, program, node
        self.feedback: list[object] = []
        self.accepted: list[bool] = []
        self.end: Future[Any] = Future()
        namespace = "never" if step in ANSWERED else step
        self.client: Any = (
            ActionClient(node, Fibonacci, f"/{namespace}/fibonacci")
            if is_goal
            else node.create_client(AddTwoInts, f"/{namespace}/add")
        )

    def wait_for_server(self) -> None:
        ready = self.client.wait_for_server if self.is_goal else self.client.wait_for_service
        assert ready(timeout_sec=30)

    def begin(self) -> None:
        if not self.is_goal:
            self.client.call_async(AddTwoInts.Request(a=1, b=2)).add_done_callback(self._finish)
            return
        self.client.send_goal_async(
            Fibonacci.Goal(order=1), feedback_callback=self.feedback.append
        ).add_done_callback(self._request_result)

    def _request_result(self, goal: Future[Any]) -> None:
        if goal.exception() is not None:
            self._finish(goal)
            return
        self.accepted.append(goal.result().accepted)
        goal.result().get_result_async().add_done_callback(self._finish)

    def _finish(self, future: Future[Any]) -> None:
        if (error := future.exception()) is not None:
            self.end.set_exception(error)
        else:
            self.end.set_result(future.result())

    def is_at_its_step(self) -> bool:
        """Return whether the server has stopped, and what it had sent before was received."""
        if self.step in ANSWERED:
            return self.end.done()
        has_accepted = bool(self.accepted) or self.step not in (
            "accepted",
            "executing",
            "feedback",
            "succeeded",
        )
        has_heard = bool(self.feedback) or self.step not in ("feedback", "succeeded")
        return self.step == "gone" or (f"at {self.step}" in self.program.lines and has_accepted and has_heard)

    def check_end(self, *, may_have_answered: bool) -> None:
        error = self.end.exception()
        is_last = self.step in ANSWERED
        if error is not None:
            assert not is_last, error
            assert isinstance(error, NoResponseError)
            # A server that ends in order may accept a goal at last, whose result then finds no server.
            may_find_none = self.step == "gone" or may_have_answered
            assert "its server left the graph without one" in str(error) or may_find_none, error
        else:
            assert is_last or may_have_answered, self.step
            answer = self.end.result()
            assert list(answer.result.sequence) == [2] if self.is_goal else answer.sum == 3
        if self.is_goal and not may_have_answered:
            # What was known before the end is not forgotten.
            assert self.accepted == [True] * (self.step not in ("gone", "unread", "deciding"))
            assert len(self.feedback) == (self.step in ("feedback", "succeeded", "finished"))

    def check_nothing_is_kept(self) -> None:
        if not self.is_goal:
            assert not self.client._pending
            return
        for client in (self.client._send, self.client._result, self.client._cancel):
            assert not client._pending
        assert not self.client._unanswered
        # The callbacks of the goals that ended last are kept, for feedback that is late.
        assert set(self.client._feedback_callbacks) == set(self.client._ended_ns)

    def destroy(self) -> None:
        if self.is_goal:
            self.client.destroy()
        else:
            self.node.destroy_client(self.client)


def end_servers(end: Kill, start: Start, node: Node) -> None:
    """End the server of a call and of a goal at each step, and check what its client reports and keeps."""
    steps = [step for step in dict.fromkeys(CALL_STEPS + GOAL_STEPS) if step not in ("gone", *ANSWERED)]
    gone, stopping = start("stopping_server", "gone"), start("stopping_server", *steps, "never")
    exchanges = [
        Exchange(step, is_goal=is_goal, program=gone if step == "gone" else stopping, node=node)
        for is_goal, steps in ((False, CALL_STEPS), (True, GOAL_STEPS))
        for step in steps
    ]
    for exchange in exchanges:
        exchange.wait_for_server()
    end(gone)
    for exchange in exchanges:
        exchange.begin()
    for exchange in exchanges:
        spin_until(node, exchange.is_at_its_step, f"the step {exchange.step!r} is not reached")
    end(stopping)
    for exchange in exchanges:
        spin_until(node, exchange.end.done, f"a client waits for the server that ended at {exchange.step!r}")
        exchange.program.wait()
        exchange.check_end(may_have_answered=end is terminate)
        exchange.check_nothing_is_kept()
        exchange.destroy()


def spin_until(node: Node, condition: Callable[[], object], what: str) -> None:
    stop_s = time.monotonic() + TOLD_S
    while not condition():
        assert time.monotonic() < stop_s, what
        assert node.executor is not None
        node.executor.spin_once(timeout_sec=0.05)


@pytest.mark.parametrize("end", ALL_ENDS)
def test_the_server_of_a_call_and_a_goal_ends_at_each_step(
    short_lease: float, start: Start, node: Node, end: Kill
) -> None:
    end_servers(end, start, node)


@pytest.mark.parametrize("end", ALL_ENDS)
def test_goals_whose_results_nobody_requests_are_forgotten_with_their_server(
    short_lease: float, start: Start, node: Node, end: Kill
) -> None:
    client = ActionClient(node, Fibonacci, "/feedback/fibonacci")
    for server in (start("stopping_server", "feedback") for _ in range(2)):
        assert client.wait_for_server(timeout_sec=30)
        heard: list[object] = []
        goal = client.send_goal_async(Fibonacci.Goal(), feedback_callback=heard.append)
        spin_until(node, lambda heard=heard: heard, "no feedback")
        assert goal.result().accepted
        assert len(client._feedback_callbacks) - len(client._ended_ns) == 1
        end(server)
        server.wait()
        wait_until(lambda: not client._send.wire_endpoint.connected_servers())
    assert len(client._servers) == len(client._feedback_callbacks) == 2
    assert len(client._ended_ns) == 1


class Server:
    """Serves what a client that stops at a step uses; calls and goals last until that client has ended."""

    def __init__(self, step: str, node: Node) -> None:
        self.step = step
        self.has_ended = threading.Event()
        self.finished: list[str] = []
        group = ReentrantCallbackGroup()
        namespace = step.replace(" ", "_")
        self.service = node.create_service(AddTwoInts, f"/{namespace}/add", self._add, callback_group=group)
        self.action = ActionServer(
            node,
            Fibonacci,
            f"/{namespace}/fibonacci",
            self._execute,
            goal_callback=self._judge,
            cancel_callback=self._judge_cancel,
            callback_group=group,
            result_timeout=0,
        )

    def _wait_at(self, *steps: str) -> None:
        if self.step in steps:
            assert self.has_ended.wait(60.0)

    def _add(self, request: Any, response: Any) -> Any:
        self._wait_at("called")
        response.sum = request.a + request.b
        self.finished.append("call")
        return response

    def _judge(self, _: Any) -> GoalResponse:
        self._wait_at("goal sent")
        return GoalResponse.ACCEPT

    def _judge_cancel(self, _: Any) -> CancelResponse:
        self._wait_at("cancel requested")
        return CancelResponse.ACCEPT

    def _execute(self, handle: Any) -> Any:
        handle.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        self._wait_at("goal accepted", "result requested", "feedback received", "cancel requested")
        handle.publish_feedback(Fibonacci.Feedback(sequence=[2]))
        if self.step == "result received":
            while not handle.is_cancel_requested:
                time.sleep(0.01)
            handle.canceled()
        else:
            handle.succeed()
        self.finished.append("goal")
        return Fibonacci.Result(sequence=[3])

    def destroy(self, node: Node) -> None:
        self.action.destroy()
        node.destroy_service(self.service)


@contextmanager
def spinning(node: Node) -> Iterator[None]:
    """Spin a node by as many threads as clients stop at once."""
    executor = MultiThreadedExecutor(len(CLIENT_CALL_STEPS + CLIENT_GOAL_STEPS) + 4, context=node.context)
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin)
    thread.start()
    try:
        yield
    finally:
        executor.shutdown()
        thread.join(30)


@pytest.mark.parametrize("end", ALL_ENDS)
def test_the_client_of_a_call_or_a_goal_ends_at_each_step(
    short_lease: float, start_program: Start, make_node: Callable[..., Node], end: Kill
) -> None:
    """The servers finish what they do, serve others, and keep nothing of the client."""
    node = make_node("server")
    path = PROGRAMS / "stopping_client.py"
    with spinning(node):
        servers = [Server(step, node) for step in CLIENT_CALL_STEPS + CLIENT_GOAL_STEPS]
        client = start_program("python", path, *(server.step for server in servers))
        for server in servers:
            client.wait_for(f"at {server.step}")
        end(client)
        client.wait()
        for server in servers:
            server.has_ended.set()
            kind = "call" if server.step in CLIENT_CALL_STEPS else "goal"
            wait_until(
                lambda server=server, kind=kind: server.finished == [kind], what=f"the {server.step} to end"
            )
            # With a result timeout of zero, a goal is dropped with its end.
            wait_until(
                lambda server=server: not server.action._goal_handles,
                what=f"the goal of {server.step!r} to go",
            )
        names = [f"/{server.step.replace(' ', '_')}" for server in servers]
        wait_until(
            lambda: (
                not any(node.count_clients(f"{name}/add") for name in names)
                and not any(node.count_clients(f"{name}/fibonacci/_action/get_result") for name in names)
            ),
            TOLD_S,
            what="the clients to leave the graph",
        )
        for server, name in zip(servers, names, strict=True):
            check_serves(server, name, node)
        for server in servers:
            server.destroy(node)


def check_serves(server: Server, name: str, node: Node) -> None:
    """Check that a server answers another client."""
    adding = node.create_client(AddTwoInts, f"{name}/add")
    assert adding.wait_for_service(timeout_sec=30)
    assert adding.call(AddTwoInts.Request(a=1, b=2), timeout_sec=30).sum == 3
    node.destroy_client(adding)
    if server.step == "result received":
        return  # its goals end by a cancellation alone
    with ActionClient(node, Fibonacci, f"{name}/fibonacci") as client:
        assert client.wait_for_server(timeout_sec=30)
        answers: list[Any] = []
        client.send_goal_async(Fibonacci.Goal()).add_done_callback(answers.append)
        wait_until(lambda: answers)
        assert answers[0].result().accepted


@pytest.mark.slow
def test_servers_and_clients_that_are_killed_leave_no_descriptor_and_no_thread(
    short_lease: float, start: Start, node: Node
) -> None:
    """What the first round leaves is what the library keeps for good."""
    end_servers(kill, start, node)
    # Zenoh's wire starts this one, for good, when a server first leaves a request unanswered.
    sockets, threads = number_of_sockets(), {*threads_of_node(), "tfloom_zenoh_timers"}
    for _ in range(4):
        end_servers(kill, start, node)
        # The socket of a process that was killed last is closed as soon as the wire has seen its end.
        wait_until(lambda: number_of_sockets() <= sockets, what=f"no more than {sockets} sockets")
        assert threads_of_node() <= threads


def number_of_sockets() -> int:
    """Return how many sockets this process has open."""
    return sum(connection.fd >= 0 for connection in psutil.Process().net_connections())


def threads_of_node() -> set[str]:
    """Return the names of this process's threads, without the test's own, which read the output of its programs."""
    names = [thread.name for thread in threading.enumerate() if "_read" not in thread.name]
    assert len(set(names)) == len(names), names
    return set(names)
