"""Nodes on DDS: one side in the test, the other in separate programs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import Program
from tests.zenoh_ports import NEEDS_ZENOH, leave_out, use_port_of

from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.log import log_output
from tfloom.node.node import Node

PROGRAMS = Path(__file__).parent / "programs"


WIRES = ["rmw_cyclonedds_cpp", pytest.param("rmw_zenoh_cpp", marks=NEEDS_ZENOH)]


ONLY_DDS = {
    "test_server_that_is_discovered_is_ready_at_the_first_question": "delays DDS's discovery",
    "test_restarted_server_is_called_at_once": "delays DDS's discovery",
    "test_client_of_another_vendor_is_ignored_with_one_log_line": "vendors are DDS's",
    "test_server_of_another_vendor_is_not_called_with_one_log_line": "vendors are DDS's",
    "test_full_domain_gives_one_error_message": "Zenoh has room for any number of programs",
    "test_different_type_hash_is_received_if_decodable": "a hash is a part of Zenoh's keys",
    "test_killed_publisher_is_not_alive_after_its_lease": "Zenoh tells of its end at once, as of any other end",
    "test_a_child_and_a_grandchild_may_start_anew": "Zenoh can't be opened again in a child",
}
"""The tests of this folder that run on DDS alone, and why; tests/rmw/test_zenoh_wire.py has others for most."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Leave out `ONLY_DDS` on Zenoh."""
    leave_out(items, PROGRAMS.parent, ONLY_DDS)


@pytest.fixture(autouse=True, params=WIRES)
def local_wire(
    request: pytest.FixtureRequest, domain_id: int, monkeypatch: pytest.MonkeyPatch
) -> Iterator[str]:
    """Replace the in-process wire with DDS, and with Zenoh in turn; return its name."""
    monkeypatch.setenv("RMW_IMPLEMENTATION", request.param)
    with use_port_of(domain_id):
        yield request.param
    log_output.reset_levels()
    log_output.configure(file=None, console=True)


@pytest.fixture(scope="module", params=WIRES)
def wire_of_module(request: pytest.FixtureRequest, module_domain_id: int) -> Iterator[str]:
    """Select DDS, and Zenoh in turn, for a module whose tests share a program; return its name.

    Such a module replaces `local_wire` by it, and `domain_id` by `module_domain_id`.
    """
    with pytest.MonkeyPatch.context() as patch, use_port_of(module_domain_id):
        patch.setenv("RMW_IMPLEMENTATION", request.param)
        yield request.param


@pytest.fixture
def context(domain_id: int) -> Iterator[Context]:
    context = Context()
    context.init(["program"], domain_id=domain_id)
    yield context
    context.destroy()


@pytest.fixture
def node(make_node: Callable[..., Node], executor: SingleThreadedExecutor) -> Node:
    """Yield a node, /tester, that the executor spins."""
    node = make_node()
    executor.add_node(node)
    return node


@pytest.fixture
def finish(executor: SingleThreadedExecutor) -> Callable[..., Any]:
    """Spin until a future is done and return its result."""

    def wait(future: Future[Any], timeout_s: float = 20.0) -> Any:
        executor.spin_until_future_complete(future, timeout_sec=timeout_s)
        assert future.done(), f"no result after {timeout_s} s"
        return future.result()

    return wait


@pytest.fixture
def start(start_program: Callable[..., Program]) -> Callable[..., Program]:
    """Start one of the programs next to this file, and wait until it prints `ready`."""

    def run(name: str, *arguments: object) -> Program:
        program = start_program("python", PROGRAMS / f"{name}.py", *(str(argument) for argument in arguments))
        program.wait_for("ready")
        return program

    return run
