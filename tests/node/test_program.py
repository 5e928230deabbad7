"""Programs that are stopped, at any time and in any way, end without a traceback."""

from __future__ import annotations

import random
import signal
import time
from collections.abc import Callable

import pytest
from tests.conftest import Program

from tfloom.node.client_library import get_default_context
from tfloom.node.program import run_program
from tfloom.node.values.exceptions import RCLError

TALKATIVE = """
import sys
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import run_program

class Talkative(Node):
    def __init__(self):
        super().__init__("talkative")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.create_timer(0.001, self.talk)
        print("up", flush=True)

    def talk(self):
        for _ in range(50):  # so that the program is amid this for most of its time
            self.publisher.publish(String(data="hello"))

sys.exit(run_program([], lambda: spin(Talkative())))
"""


@pytest.mark.parametrize(
    "numbers",
    [[signal.SIGINT], [signal.SIGTERM], [signal.SIGINT, signal.SIGINT], [signal.SIGINT, signal.SIGTERM]],
    ids=["SIGINT", "SIGTERM", "twice", "both"],
)
def test_busy_program_stopped_at_any_time_ends_without_traceback(
    numbers: list[int], start_program: Callable[..., Program]
) -> None:
    program = start_program("python", "-c", TALKATIVE)
    program.wait_for("up")
    time.sleep(random.random() * 0.01)  # the test is about a random time
    for number in numbers:
        program.signal(number)
    assert program.wait() == 0, program.output
    assert program.lines == ["up"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signal_during_interpreter_exit_keeps_the_exit_code(
    number: int, start_program: Callable[..., Program]
) -> None:
    """At exit, the interpreter restores the default action of signals that have handlers."""
    code = f"""
import os
from tfloom.node.program import run_program

class Late:
    def __del__(self):
        os.kill(os.getpid(), {int(number)})

late = Late()
raise SystemExit(run_program([], lambda: 3))
"""
    assert start_program("python", "-c", code).wait() == 3


@pytest.fixture(autouse=True)
def _local(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")


@pytest.mark.parametrize(("result", "code"), [(None, 0), (0, 0), (3, 3)])
def test_body_returns_the_exit_code(result: int | None, code: int) -> None:
    assert run_program([], lambda: result, if_stopped=1) == code


def test_stopped_program_can_have_an_exit_code() -> None:
    def body() -> int:
        raise KeyboardInterrupt

    assert run_program([], body, if_stopped=1) == 1


def test_only_consequences_of_a_signal_are_suppressed() -> None:
    def refuse() -> int:
        raise RCLError("refused")

    def refuse_after_a_signal() -> int:
        get_default_context().interrupt()
        return refuse()

    def fail_after_a_signal() -> int:
        get_default_context().interrupt()
        raise ValueError("a mistake")

    with pytest.raises(RCLError, match="refused"):
        run_program([], refuse)
    assert run_program([], refuse_after_a_signal) == 0
    with pytest.raises(ValueError, match="a mistake"):
        run_program([], fail_after_a_signal)
    assert not get_default_context().ok()
