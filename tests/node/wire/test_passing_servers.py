"""Calls and goals while their servers come and go: each is answered, or its future fails by name."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from tests.conftest import Program

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.rcl_interfaces.srv import GetParameters
from tfloom.node.action.client import ActionClient
from tfloom.node.endpoints.client import NoResponseError
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node

Start = Callable[..., Program]
LEASE_S = 10.0
"""The time after which a process that doesn't run is taken for gone [s]."""
KILLED = 0.05
"""Probability that the servers' process is killed before a batch."""


def follow(goal: Future[Any]) -> Future[Any]:
    """Return the future of a goal's end, or of its first failure."""
    end: Future[Any] = Future()

    def finish(result: Future[Any]) -> None:
        if (error := result.exception()) is not None:
            end.set_exception(error)
        else:
            end.set_result(result.result())

    def on_response(response: Future[Any]) -> None:
        if response.exception() is not None or not response.result().accepted:
            finish(response)
        else:
            response.result().get_result_async().add_done_callback(finish)

    goal.add_done_callback(on_response)
    return end


@contextmanager
def busy_machine(start_program: Callable[..., Program]) -> Iterator[None]:
    """Keep all processors busy, until this process ends at the latest."""
    loop = "import os\nparent = os.getppid()\nwhile os.getppid() == parent: pass"
    busy = [start_program("python", "-c", loop) for _ in range((os.cpu_count() or 1) + 1)]
    try:
        yield
    finally:
        for program in busy:
            program.signal(signal.SIGKILL)
            program.wait()


def count_outcomes(
    number: int, batch: int, start: Start, node: Node, executor: SingleThreadedExecutor, seed: int = 7
) -> Counter[str]:
    """Send `number` calls and goals in batches, and count how they end."""
    source = random.Random(seed)
    servers = start("passing_servers", 0)
    adding = node.create_client(AddTwoInts, "add")
    fibonacci = ActionClient(node, Fibonacci, "fibonacci")
    outcomes: Counter[str] = Counter()
    for begun in range(0, number, 2 * batch):
        if source.random() < KILLED:
            servers.signal(signal.SIGKILL)
            servers.wait()
            servers = start("passing_servers", begun)
        assert fibonacci.wait_for_server(timeout_sec=120), servers.output
        futures = [adding.call_async(AddTwoInts.Request(a=number, b=1)) for number in range(batch)]
        futures += [follow(fibonacci.send_goal_async(Fibonacci.Goal(order=order))) for order in range(batch)]
        for future in futures:
            executor.spin_until_future_complete(future, timeout_sec=30)
        outcomes.update(map(outcome, futures))
    assert not adding._pending
    servers.signal(signal.SIGKILL)
    servers.wait()
    return outcomes


def outcome(future: Future[Any]) -> str:
    if not future.done():
        return "open"
    error = future.exception()
    if error is None:
        return "answered"
    assert isinstance(error, NoResponseError)
    assert "no response from /" in str(error)
    return "failed"


def test_calls_and_goals_are_answered_or_fail_while_servers_come_and_go(
    short_lease: float, start: Start, node: Node, executor: SingleThreadedExecutor
) -> None:
    outcomes = count_outcomes(200, 10, start, node, executor)
    assert outcomes["open"] == 0
    assert outcomes.total() == 200
    assert outcomes["answered"] > 0


@pytest.mark.slow
def test_5000_calls_and_goals_at_first_on_a_busy_machine(
    short_lease: float,
    start: Start,
    start_program: Callable[..., Program],
    node: Node,
    executor: SingleThreadedExecutor,
) -> None:
    with busy_machine(start_program):  # not for all of them, because other tests run at the same time
        outcomes = count_outcomes(400, 50, start, node, executor)
    outcomes += count_outcomes(4600, 50, start, node, executor, seed=8)
    assert outcomes["open"] == 0
    assert outcomes.total() == 5000
    assert outcomes["answered"] > 0
    assert outcomes["failed"] > 0


def test_1500_calls_at_once_are_all_answered(
    start: Start, node: Node, executor: SingleThreadedExecutor
) -> None:
    start("service_server")
    adding = node.create_client(AddTwoInts, "add")
    assert adding.wait_for_service(timeout_sec=20)
    futures = [adding.call_async(AddTwoInts.Request(a=number, b=1)) for number in range(1500)]
    for future in futures:
        executor.spin_until_future_complete(future, timeout_sec=30)
    assert [future.result().sum for future in futures] == list(range(1, 1501))


def spin_until(
    executor: SingleThreadedExecutor, is_over: Callable[[], bool], timeout_s: float = 30.0
) -> None:
    """Spin until a condition is true, or the time is over."""
    end = time.monotonic() + timeout_s
    while not is_over() and time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)


def test_calls_that_a_stopped_server_has_no_room_for_are_all_answered(
    start: Start, node: Node, executor: SingleThreadedExecutor
) -> None:
    """The system drops what a process that doesn't run can't take: its peer sends it again."""
    server = start("service_server")
    asking = node.create_client(GetParameters, "/server/get_parameters")
    assert asking.wait_for_service(timeout_sec=20)
    request = GetParameters.Request(names=["x" * 20_000])  # more in all than any socket keeps
    futures: list[Future[Any]] = []
    server.pause()
    calling = threading.Thread(
        target=lambda: futures.extend(asking.call_async(request) for _ in range(1000)), daemon=True
    )
    calling.start()
    if os.environ["RMW_IMPLEMENTATION"] == "rmw_cyclonedds_cpp":
        calling.join(LEASE_S / 2)
        assert len(futures) == 1000  # no call waits until the server goes on
    else:
        calling.join(
            0.5
        )  # Zenoh keeps little of what the server has not received, and leaves it after some seconds
    server.signal(signal.SIGCONT)
    calling.join(30)
    spin_until(executor, lambda: all(future.done() for future in futures))
    assert Counter(map(outcome, futures)) == {"answered": 1000}


BURST = """
import sys
import rclpy
from rcl_interfaces.srv import GetParameters

rclpy.init()
node = rclpy.create_node("caller")
asking = node.create_client(GetParameters, "/server/get_parameters")
assert asking.wait_for_service(20)
print("ready", flush=True)
sys.stdin.readline()
futures = [asking.call_async(GetParameters.Request(names=["x" * 2000])) for _ in range(1000)]
print("called", flush=True)
rclpy.spin(node)
"""


def test_a_caller_of_a_stopped_server_ends_on_ctrl_c_at_once(start: Start, start_program: Start) -> None:
    server = start("service_server")
    caller = start_program(sys.executable, "-c", BURST, stdin=subprocess.PIPE)
    caller.wait_for("ready")
    server.pause()
    assert caller.process.stdin is not None
    caller.process.stdin.write("\n")
    caller.process.stdin.flush()
    caller.wait_for("called")
    begin_s = time.monotonic()
    caller.signal(signal.SIGINT)
    caller.wait()
    assert time.monotonic() - begin_s < LEASE_S / 2
