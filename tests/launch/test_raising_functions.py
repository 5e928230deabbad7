"""Each function of a launch description raises: the launch says so once, ends with 1, and leaves no process."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from typing import Any

import psutil
import pytest
from tests.launch.conftest import Ran

from tfloom.interfaces.lifecycle_msgs.msg import TransitionEvent
from tfloom.launch.actions.event_actions import EmitEvent, RegisterEventHandler, Shutdown
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.for_loop import ForEach, ForLoop
from tfloom.launch.actions.log import LogInfo
from tfloom.launch.actions.opaque import OpaqueCoroutine, OpaqueFunction
from tfloom.launch.core.base_classes import Condition
from tfloom.launch.core.event import Event
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import EventHandler
from tfloom.launch.events.event_handlers import (
    OnActionEventBase,
    OnExecutionComplete,
    OnProcessExit,
    OnProcessIO,
    OnProcessStart,
    OnShutdown,
)
from tfloom.launch.events.process import ProcessExited, SignalProcess
from tfloom.launch.ros.actions.lifecycle_transition import OnStateTransition
from tfloom.launch.ros.lifecycle_events import StateTransition

Launch = Callable[..., Ran]
TEXT = "of a user's function"


calls: list[None] = []
"""The calls of `fail` in this test."""


def fail(*_: Any, **__: Any) -> Any:
    """Raise at the first call; then match nothing, and return no entities."""
    calls.append(None)
    if len(calls) == 1:
        raise ValueError(TEXT)


async def fail_later(*_: Any) -> None:
    fail()


class Bell(Event):
    name = "test.Bell"


def program(code: str) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", code])


def short() -> ExecuteProcess:
    return program("print('out'); import sys; print('err', file=sys.stderr)")


def on(handler: Any, *entities: Action) -> list[Action]:
    return [RegisterEventHandler(handler), *(entities or (short(),))]


def named(**options: Any) -> OnStateTransition:
    return OnStateTransition(entities=[LogInfo(msg="changed")], **options)


ROWS: dict[str, Callable[[], list[Action]]] = {
    "opaque function": lambda: [OpaqueFunction(function=fail)],
    "opaque coroutine": lambda: [OpaqueCoroutine(coroutine=fail_later)],
    "condition": lambda: [LogInfo(msg="x", condition=Condition(predicate=fail))],
    "for loop": lambda: [ForLoop("2", function=fail)],
    "for each": lambda: [ForEach("{a: '1'}", function=fail)],
    "matcher": lambda: on(EventHandler(matcher=fail, entities=[]), EmitEvent(event=Bell())),
    "matcher of actions": lambda: on(
        OnActionEventBase(
            action_matcher=fail, on_event=[], target_event_cls=ProcessExited, target_action_cls=ExecuteProcess
        )
    ),
    "event of actions": lambda: on(
        OnActionEventBase(
            action_matcher=None,
            on_event=fail,
            target_event_cls=ProcessExited,
            target_action_cls=ExecuteProcess,
        )
    ),
    "completion": lambda: on(OnExecutionComplete(on_completion=fail), LogInfo(msg="x")),
    "target of completion": lambda: on(
        OnExecutionComplete(target_action=fail, on_completion=[]), LogInfo(msg="x")
    ),
    "exit": lambda: on(OnProcessExit(on_exit=fail)),
    "target of exit": lambda: on(OnProcessExit(target_action=fail, on_exit=[])),
    "own exit": lambda: [ExecuteProcess(cmd=[sys.executable, "-c", ""], on_exit=fail)],
    "start": lambda: on(OnProcessStart(on_start=fail)),
    "target of start": lambda: on(OnProcessStart(target_action=fail, on_start=[])),
    "stdout": lambda: on(OnProcessIO(on_stdout=fail)),
    "stderr": lambda: on(OnProcessIO(on_stderr=fail)),
    "target of output": lambda: on(OnProcessIO(target_action=fail, on_stdout=lambda _: None)),
    "shutdown": lambda: on(OnShutdown(on_shutdown=fail), Shutdown(reason="the test")),
    "signal": lambda: [EmitEvent(event=SignalProcess(signal_number="SIGINT", process_matcher=fail))],
    "state transition": lambda: on(
        named(matcher=fail), EmitEvent(event=StateTransition(action=short(), msg=TransitionEvent()))
    ),
}


@pytest.mark.parametrize("name", ROWS)
def test_function_raises(name: str, launch: Launch) -> None:
    before = {child.pid for child in psutil.Process().children(recursive=True)}
    calls.clear()
    # The launch holds a program that does not end by itself; it is started before the function is called.
    waits = program("print('started', flush=True); import time; time.sleep(600)")
    done: list[bool] = []

    def begin(event: Any) -> list[Action] | None:
        if b"started" not in event.text or done:
            return None
        done.append(True)
        return ROWS[name]()

    ran = launch(RegisterEventHandler(OnProcessIO(target_action=waits, on_stdout=begin)), waits)
    errors = [line for line in ran.lines if "Caught exception in launch" in line]
    assert (ran.code, len(errors)) == (1, 1), ran.lines
    assert re.search(TEXT, errors[0])
    assert {child.pid for child in psutil.Process().children(recursive=True)} <= before
