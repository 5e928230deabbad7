"""A turtlesim node and a user's node, in this process, without a network."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tfloom.node.client_library import init
from tfloom.node.context.utilities import try_shutdown
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.turtlesim.node import TurtlesimNode


class Stage:
    """The nodes, spun only while a test waits."""

    def __init__(self, args: list[str]) -> None:
        init(args=args)
        self.turtlesim = TurtlesimNode()
        self.user = Node("user")
        self._nodes: list[Node] = []
        self._executor = SingleThreadedExecutor()
        self.add(self.turtlesim)
        self.add(self.user)

    def add(self, node: Node) -> None:
        self._nodes.append(node)
        self._executor.add_node(node)

    def spin_until(self, condition: Callable[[], object], turns: int = 3000) -> None:
        for _ in range(turns):
            if condition():
                return
            self._executor.spin_once(timeout_sec=0.05)
        pytest.fail("the nodes never got there")

    def end(self) -> None:
        self._executor.shutdown()
        for node in self._nodes:
            node.destroy_node()
        try_shutdown()


@pytest.fixture
def start_stage(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Stage]]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    stages: list[Stage] = []

    def start(*args: str) -> Stage:
        stages.append(Stage(["--ros-args", *args] if args else []))
        return stages[-1]

    yield start
    for stage in stages:
        stage.end()


@pytest.fixture
def stage(start_stage: Callable[..., Any]) -> Any:
    return start_stage()
