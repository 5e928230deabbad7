"""Nodes of a test that are spun only while the test waits."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

import pytest
from tests.conftest import TIMEOUT_S, wait_until

from tfloom.node import client_library as rclpy
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter


class SpunNode:
    """A node with its own context."""

    def __init__(self, name: str, domain_id: int) -> None:
        self.context = Context()
        self.context.init(args=[], domain_id=domain_id)
        self.node = Node(name, context=self.context)
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)

    def received(self, message_type: Any, topic: str) -> list[Any]:
        """Return a list to which messages on a topic are added."""
        messages: list[Any] = []
        self.node.create_subscription(message_type, topic, messages.append, 10)
        return messages

    def spin_until(
        self, condition: Callable[[], object], what: str = "", timeout_s: float = TIMEOUT_S
    ) -> None:
        def is_met() -> object:
            self.executor.spin_once(timeout_sec=0.01)
            return condition()

        wait_until(is_met, timeout_s, what)

    def parameters_of(self, node: str) -> AsyncParameterClient:
        """Return a client of another node's parameters, as soon as its services are there."""
        client = AsyncParameterClient(self.node, node)
        self.spin_until(client.services_are_ready, f"the services of {node}")
        return client

    def set_parameter(self, node: str, name: str, value: object) -> Any:
        """Set a parameter of another node, as `ros2 param set` does; return its SetParametersResult."""
        answer = self.parameters_of(node).set_parameters([Parameter(name, value=value)])
        self.spin_until(answer.done, f"{name} of {node}")
        return answer.result().results[0]

    def end(self) -> None:
        self.executor.shutdown()
        self.node.destroy_node()
        self.context.try_shutdown()
        self.context.destroy()


Spun = TypeVar("Spun", bound=SpunNode)


@contextmanager
def spun(node: Spun) -> Iterator[Spun]:
    """End a node with the block."""
    try:
        yield node
    finally:
        node.end()


class Stage:
    """Nodes of the default context, initialised with `args`, on the wire inside the process."""

    def __init__(self, args: Sequence[str] = ()) -> None:
        rclpy.init(args=["--ros-args", *args] if args else [])
        self.executor = SingleThreadedExecutor()

    def add(self, node: Any) -> Any:
        self.executor.add_node(node)
        return node

    def run(self) -> None:
        """Run what is ready; all messages of this wire are delivered at once."""
        for _ in range(20):
            self.executor.spin_once(timeout_sec=0.0)

    def spin_until(self, condition: Callable[[], object], turns: int = 3000) -> None:
        for _ in range(turns):
            if condition():
                return
            self.executor.spin_once(timeout_sec=0.05)
        pytest.fail("the nodes never got there")


AnyStage = TypeVar("AnyStage", bound=Stage)


@contextmanager
def staging(make: Callable[..., AnyStage]) -> Iterator[Callable[..., AnyStage]]:
    """Yield a function that makes stages, which are ended with the block, with all nodes of the default context."""
    stages: list[AnyStage] = []

    def start(*words: Any) -> AnyStage:
        stages.append(make(*words))
        return stages[-1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
        try:
            yield start
        finally:
            for stage in stages:
                stage.executor.shutdown()
            rclpy.try_shutdown()
            rclpy.get_default_context().destroy()
