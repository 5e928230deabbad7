"""Nodes on DDS: one side in the test, the other in separate programs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import Program

from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.log import log_output
from tfloom.node.node import Node

PROGRAMS = Path(__file__).parent / "programs"


@pytest.fixture(autouse=True)
def local_wire(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[None]:
    """Replace the in-process wire with DDS."""
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    yield
    log_output.reset_levels()
    log_output.configure(file=None, console=True)


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
