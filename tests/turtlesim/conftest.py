"""A turtlesim node and a user's node, in this process, without a network; and the terminal of a teleop."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests import spun

from tfloom.node.node import Node
from tfloom.turtlesim.node import TurtlesimNode


class Stage(spun.Stage):
    """The nodes, spun only while a test waits."""

    def __init__(self, *args: str) -> None:
        super().__init__(args)
        self.turtlesim = self.add(TurtlesimNode())
        self.user = self.add(Node("user"))

    def call(self, service: Any, where: str, /, **fields: Any) -> Any:
        """Call a service, and return its response."""
        client = self.user.create_client(service, where)
        self.spin_until(client.service_is_ready)
        answer = client.call_async(service.Request(**fields))
        self.spin_until(answer.done)
        self.user.destroy_client(client)
        return answer.result()

    def heard(self, message_type: Any, topic: str) -> list[Any]:
        """Return a list to which messages on a topic are added."""
        messages: list[Any] = []
        self.user.create_subscription(message_type, topic, messages.append, 7)
        return messages


@pytest.fixture
def start_stage() -> Iterator[Callable[..., Stage]]:
    with spun.staging(Stage) as start:
        yield start


@pytest.fixture
def stage(start_stage: Callable[..., Any]) -> Any:
    return start_stage()


@pytest.fixture
def terminal() -> Iterator[tuple[int, int]]:
    """Return the ends of a pseudo-terminal: of its user, and of its program."""
    import pty

    ours, theirs = pty.openpty()
    yield ours, theirs
    os.close(ours)
    os.close(theirs)


@pytest.fixture
def press(terminal: tuple[int, int]) -> Callable[[bytes], int]:
    """Press keys in the terminal."""
    return lambda keys: os.write(terminal[0], keys)


@pytest.fixture
def start_teleop(start_program: Callable[..., Any], terminal: tuple[int, int]) -> Callable[..., Any]:
    """Start turtle_teleop_key in the terminal, and wait until it reads keys."""

    def start(*words: str) -> Any:
        program = start_program("tfloom", "run", "turtlesim", "turtle_teleop_key", *words, stdin=terminal[1])
        program.wait_for("'Q' to quit.")
        return program

    return start
