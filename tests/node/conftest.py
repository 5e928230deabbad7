"""Nodes on the in-process wire, with a separate context for each test."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.zenoh_ports import NEEDS_ZENOH, hold_zenoh_port, leave_out

from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.log import log_output
from tfloom.node.node import Node

WIRES = [
    "tfloom_local",
    pytest.param("rmw_cyclonedds_cpp", marks=pytest.mark.wire),
    pytest.param("rmw_zenoh_cpp", marks=NEEDS_ZENOH),
]

NOT_ON_ZENOH = {
    "test_no_demangle_returns_dds_names": "names have no prefixes there",
    "test_topic_can_avoid_ros_namespace_conventions": "there is no convention to avoid",
}
"""The tests of this folder that don't run on Zenoh, and why; tests/rmw/test_zenoh_wire.py has others for them."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Leave out `NOT_ON_ZENOH` there."""
    leave_out(items, Path(__file__).parent, NOT_ON_ZENOH)


@pytest.fixture(params=WIRES)
def context_on_each_wire(
    request: pytest.FixtureRequest, local_wire: None, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Context]:
    """Return a context on the wire inside the process, and others on DDS and Zenoh in a domain of the test's own."""
    if request.param == "rmw_cyclonedds_cpp":
        request.getfixturevalue("domain_id")
    if request.param == "rmw_zenoh_cpp":
        request.getfixturevalue("zenoh_port")
    monkeypatch.setenv("RMW_IMPLEMENTATION", request.param)
    context = Context()
    context.init(["program"])
    yield context
    context.destroy()


@pytest.fixture
def zenoh_port() -> Iterator[int]:
    with hold_zenoh_port() as port:
        yield port


@pytest.fixture(autouse=True)
def local_wire(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    yield
    log_output.reset_levels()
    log_output.configure(file=None, console=True)


@pytest.fixture
def context() -> Iterator[Context]:
    context = Context()
    context.init(["program"])
    yield context
    context.destroy()


@pytest.fixture
def make_node(context: Context) -> Iterator[Callable[..., Node]]:
    nodes: list[Node] = []

    def make(name: str = "tester", **options: object) -> Node:
        node = Node(name, **{"context": context, **options})
        nodes.append(node)
        return node

    yield make
    for node in nodes:
        node.destroy_node()


@pytest.fixture
def node(make_node: Callable[..., Node]) -> Node:
    return make_node()


@pytest.fixture
def executor(context: Context) -> Iterator[SingleThreadedExecutor]:
    with SingleThreadedExecutor(context=context) as executor:
        yield executor


@pytest.fixture
def spin_until(executor: SingleThreadedExecutor) -> Callable[..., None]:
    """Spin until a condition is true; fail the test if it stays false."""
    import time

    def spin(condition: Callable[[], object], timeout_s: float = 30.0) -> None:
        end = time.monotonic() + timeout_s
        while not condition():
            if time.monotonic() > end:
                pytest.fail(f"gave up spinning after {timeout_s} s")
            executor.spin_once(timeout_sec=0.1)

    return spin


@pytest.fixture
def finish(executor: SingleThreadedExecutor) -> Callable[[Future[Any]], Any]:
    """Return a function that spins until a future is done, and returns its result."""

    def wait(future: Future[Any]) -> Any:
        executor.spin_until_future_complete(future, timeout_sec=5)
        assert future.done()
        return future.result()

    return wait
