"""Fixtures of the tests of the commands."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.conftest import Program

from tfloom.cli.shared.graph import joined_participant
from tfloom.node.context.context import Context
from tfloom.node.node import Node
from tfloom.rmw.base import NodeName
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message
from tfloom.workspace import index

sys.path.append(str(Path(__file__).parent))
pytest.register_assert_rewrite("transcript")

TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node")
SPAWNED = "Spawning turtle [turtle1]"


@pytest.fixture(scope="module")
def turtlesim(module_domain_id: int, start_module_program: Callable[..., Program]) -> None:
    """Start turtlesim for the tests of a module that don't change it."""
    start_module_program(*TURTLESIM).wait_for(SPAWNED)


@pytest.fixture
def turtlesim_to_change(domain_id: int, start_program: Callable[..., Program]) -> Program:
    """Start another turtlesim, on a separate domain."""
    program = start_program(*TURTLESIM)
    program.wait_for(SPAWNED)
    return program


@pytest.fixture
def onlooker(domain_id: int) -> Iterator[Node]:
    """Return a node that sees the graph of the test."""
    context = Context()
    context.init(args=[], domain_id=domain_id)
    yield Node("onlooker", context=context)
    context.destroy()


@pytest.fixture
def publish(domain_id: int) -> Iterator[Callable[..., None]]:
    """Publish from this process: `publish(topic, make_message, rate_hz)`."""
    ended, threads = threading.Event(), list[threading.Thread]()
    with joined_participant() as participant:

        def start(topic: str, make: Callable[[], Message], rate_hz: float = 50.0) -> None:
            writer = participant.create_writer(NodeName("/", "talker"), topic_of(type(make()), topic), QoS())

            def run() -> None:
                while not ended.wait(1 / rate_hz):
                    writer.write(cdr.encode(make()))

            threads.append(threading.Thread(target=run))
            threads[-1].start()

        yield start
        ended.set()
        for thread in threads:
            thread.join()


@pytest.fixture
def prefix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the prefix of a sourced workspace, which has the package `my_pkg`, without a file."""
    monkeypatch.setenv(index.PREFIX_PATH_VARIABLE, str(tmp_path))
    marker = tmp_path / index.RESOURCE_INDEX / "packages" / "my_pkg"
    marker.parent.mkdir(parents=True)
    marker.touch()
    return tmp_path


@pytest.fixture
def run_tf() -> Callable[..., tuple[int, str]]:
    """Run `tf …` to its end in this process; return exit code and output."""
    from transcript import run_here

    def run(*words: str | Path) -> tuple[int, str]:
        answer = run_here("tf", *map(str, words))
        return answer.exit_code, answer.text

    return run
