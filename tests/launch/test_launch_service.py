"""The engine: the order of visits and events, idleness, errors, and the end."""

from __future__ import annotations

import asyncio
import os
import signal
import threading
from collections.abc import Callable

import pytest

from tfloom.launch.actions.event_actions import (
    EmitEvent,
    RegisterEventHandler,
    Shutdown,
    UnregisterEventHandler,
)
from tfloom.launch.actions.opaque import OpaqueCoroutine, OpaqueFunction
from tfloom.launch.actions.timer_action import TimerAction
from tfloom.launch.core.base_classes import Condition
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import EventHandler
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.events.event_handlers import OnExecutionComplete, OnShutdown, event_named
from tfloom.launch.launch_service import LaunchService

Launch = Callable[..., tuple]


class Bell(Event):
    name = "test.Bell"


class Note(Action):
    """Writes its text down when it is executed, and returns entities."""

    def __init__(self, written: list[str], text: str, *following: Action, **options: object) -> None:
        super().__init__(**options)
        self.written, self.text, self.following = written, text, list(following)

    def execute(self, context: LaunchContext) -> list[Action]:
        self.written.append(self.text)
        return self.following


def test_entities_are_visited_depth_first_in_their_order(launch: Launch) -> None:
    written: list[str] = []
    inner = LaunchDescription([Note(written, "2"), Note(written, "3", Note(written, "4"))])
    assert launch(Note(written, "1"), inner, Note(written, "5")).code == 0
    assert written == ["1", "2", "3", "4", "5"]


def test_events_are_handled_after_the_visit_that_emitted_them_in_their_order(launch: Launch) -> None:
    written: list[str] = []
    handlers = [
        EventHandler(matcher=event_named("test.Bell"), entities=Note(written, text))
        for text in ("old", "new")
    ]
    launch(
        *[RegisterEventHandler(handler) for handler in handlers],
        EmitEvent(event=Bell()),
        Note(written, "visited"),
        EmitEvent(event=Bell()),
        TimerAction(period=0.05, actions=[UnregisterEventHandler(handlers[0]), EmitEvent(event=Bell())]),
    )
    assert written == ["visited", "new", "old", "new", "old", "new"]


def test_a_handler_that_handles_once_leaves(launch: Launch) -> None:
    written: list[str] = []
    handler = EventHandler(
        matcher=event_named("test.Bell"), entities=[Note(written, "once")], handle_once=True
    )
    launch(RegisterEventHandler(handler), EmitEvent(event=Bell()), EmitEvent(event=Bell()))
    assert written == ["once"]


def test_an_action_whose_condition_is_false_is_not_executed(launch: Launch) -> None:
    written: list[str] = []
    no, yes = Condition(), Condition(predicate=lambda _: True)
    launch(Note(written, "no", condition=no), Note(written, "yes", condition=yes))
    assert written == ["yes"]


def test_completion_of_an_action_is_an_event(launch: Launch) -> None:
    written: list[str] = []

    async def sleep() -> None:
        await asyncio.sleep(0.02)
        written.append("slept")

    at_once, later = Note(written, "done"), OpaqueCoroutine(coroutine=sleep, ignore_context=True)
    launch(
        RegisterEventHandler(OnExecutionComplete(target_action=at_once, on_completion=[Note(written, "1")])),
        RegisterEventHandler(
            OnExecutionComplete(
                target_action=later, on_completion=lambda event, context: [Note(written, "2")]
            )
        ),
        at_once,
        later,
    )
    assert written == ["done", "1", "slept", "2"]


def test_an_exception_ends_the_launch_with_its_text(launch: Launch) -> None:
    written: list[str] = []

    def fail(_: LaunchContext) -> None:
        raise ValueError("no such wheel")

    ran = launch(
        RegisterEventHandler(OnShutdown(on_shutdown=Note(written, "shut down"))),
        OpaqueFunction(function=fail),
        Note(written, "never visited"),
    )
    assert ran.code == 1
    (line,) = ran.lines
    assert line.startswith(
        f"[ERROR] [launch]: Caught exception in launch (see debug for traceback): {__file__}:"
    )
    assert line.endswith(": ValueError: no such wheel")
    assert written == ["shut down"]


def test_an_exception_of_a_coroutine_ends_the_launch(launch: Launch) -> None:
    async def fail(_: LaunchContext, text: str, *, end: str) -> None:
        await asyncio.sleep(0)
        raise RuntimeError(text + end)

    ran = launch(
        OpaqueCoroutine(coroutine=fail, args=["la"], kwargs={"end": "te"}),
        TimerAction(period=60.0, actions=[]),
    )
    assert ran.code == 1
    (line,) = ran.lines
    assert line.startswith("[ERROR] [launch]: Caught exception in launch (see debug for traceback): ")
    assert line.endswith(": RuntimeError: late")


@pytest.mark.parametrize("count", [1, 2])
def test_coroutines_that_fail_end_the_launch_once(launch: Launch, count: int) -> None:
    """The launch is idle when the last one fails, which must not be a second reason for the end; nor must the other."""
    reasons: list[str] = []

    async def fail(_context: LaunchContext) -> None:
        await asyncio.sleep(0)
        raise ValueError("of the last coroutine")

    def note(event: Event, _context: LaunchContext) -> None:
        reasons.append(event.reason)  # type: ignore[attr-defined]

    coroutines = [OpaqueCoroutine(coroutine=fail) for _ in range(count)]
    launch(*coroutines, RegisterEventHandler(OnShutdown(on_shutdown=note)))
    assert len(reasons) == 1
    assert "of the last coroutine" in reasons[0]


def test_the_traceback_is_there_with_debug(launch: Launch) -> None:
    def fail(_: LaunchContext) -> None:
        raise ValueError("no such wheel")

    lines = launch(OpaqueFunction(function=fail), debug=True).lines
    assert any("in fail" in line for line in lines)


@pytest.mark.parametrize("wait", ["timer", "coroutine"])
def test_shutdown_ends_what_waits(launch: Launch, wait: str) -> None:
    written: list[str] = []

    async def sleep() -> None:
        await asyncio.sleep(600)

    waiting = {
        "timer": TimerAction(period=600.0, actions=[Note(written, "never")]),
        "coroutine": OpaqueCoroutine(coroutine=sleep, ignore_context=True),
    }[wait]
    ran = launch(waiting, TimerAction(period=0.05, actions=[Shutdown(reason="enough")]))
    assert (ran.code, ran.lines, written) == (0, [], [])


def test_a_timer_can_be_cancelled(launch: Launch) -> None:
    written: list[str] = []
    timer = TimerAction(period=0.2, actions=[Note(written, "never")])
    launch(timer, OpaqueFunction(function=lambda _: timer.cancel()), Note(written, "at once"))
    assert written == ["at once"]


def test_a_service_that_waits_for_events_is_ended_from_another_thread() -> None:
    service = LaunchService()
    started = threading.Event()
    service.include_launch_description(LaunchDescription([OpaqueFunction(function=lambda _: started.set())]))
    codes: list[int] = []
    thread = threading.Thread(target=lambda: codes.append(service.run(shutdown_when_idle=False)))
    thread.start()
    assert started.wait(30)
    written: list[str] = []
    done = threading.Event()
    service.include_launch_description(
        LaunchDescription([Note(written, "later"), OpaqueFunction(function=lambda _: done.set())])
    )
    assert done.wait(30)
    service.shutdown()
    thread.join(30)
    assert codes == [0]
    assert written == ["later"]


def test_a_service_runs_again(launch: Launch) -> None:
    ran = launch()
    written: list[str] = []
    ran.service.include_launch_description(LaunchDescription([Note(written, "again")]))
    assert ran.service.run() == 0
    assert written == ["again"]


def test_a_service_runs_in_a_loop_of_the_program() -> None:
    written: list[str] = []

    async def main() -> int:
        service = LaunchService()
        service.include_launch_description(LaunchDescription([Note(written, "visited")]))
        task = asyncio.ensure_future(service.run_async(shutdown_when_idle=False))
        while not written:  # noqa: ASYNC110  # of the launch
            await asyncio.sleep(0)
        assert service.task is task
        assert service.event_loop is asyncio.get_running_loop()
        with pytest.raises(RuntimeError, match="already running"):
            await service.run_async()
        ending = service.shutdown()
        assert ending is not None
        await ending
        return await task

    assert asyncio.run(main()) == 0


@pytest.mark.parametrize(
    ("number", "line"),
    [
        (signal.SIGINT, "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)"),
        (signal.SIGTERM, "[WARNING] [launch]: SIGTERM received, ending all processes"),
    ],
)
def test_a_signal_ends_the_launch(launch: Launch, number: int, line: str) -> None:
    before = signal.getsignal(number)
    events: list[bool] = []
    ran = launch(
        RegisterEventHandler(OnShutdown(on_shutdown=lambda event, _: events.append(event.due_to_sigint))),
        TimerAction(period=600.0, actions=[]),
        OpaqueFunction(function=lambda _: os.kill(os.getpid(), number)),
    )
    assert ran.lines == [line]
    assert ran.code == 0
    assert events == [number == signal.SIGINT]
    assert signal.getsignal(number) is before


def test_idleness_is_a_reason_of_the_shutdown(launch: Launch) -> None:
    reasons: list[str] = []
    launch(RegisterEventHandler(OnShutdown(on_shutdown=lambda event, _: reasons.append(event.reason))))
    assert reasons == ["idle"]


def test_the_context_keeps_the_launch_running_for_a_future(launch: Launch) -> None:
    written: list[str] = []

    def wait(context: LaunchContext) -> None:
        future = context.asyncio_loop.create_future()
        context.add_completion_future(future)
        context.asyncio_loop.call_later(0.05, lambda: (written.append("done"), future.set_result(None)))

    launch(OpaqueFunction(function=wait))
    assert written == ["done"]


def test_arguments_of_the_command_line_are_in_the_context(launch: Launch) -> None:
    argument_lists: list[list[str]] = []
    launch(OpaqueFunction(function=lambda context: argument_lists.append(context.argv)), argv=("a:=b",))
    assert argument_lists == [["a:=b"]]


@pytest.mark.skipif(os.name == "nt", reason="the signals are of POSIX")
def test_a_second_signal_emits_no_second_shutdown(launch: Launch) -> None:
    reasons: list[str] = []

    def on_shutdown(event: Event, _: LaunchContext) -> None:
        reasons.append(event.reason)
        if len(reasons) == 1:
            os.kill(os.getpid(), signal.SIGTERM)

    launch(
        RegisterEventHandler(OnShutdown(on_shutdown=on_shutdown)),
        TimerAction(period=0.3, actions=[], cancel_on_shutdown=False),
        OpaqueFunction(function=lambda _: os.kill(os.getpid(), signal.SIGTERM)),
    )
    assert reasons == ["SIGTERM received"]


def test_a_cancelled_task_ends_what_waits_in_order() -> None:
    written: list[str] = []

    async def main() -> None:
        service = LaunchService()
        ended = RegisterEventHandler(OnShutdown(on_shutdown=[Note(written, "ended")]))
        waits = TimerAction(period=600.0, actions=[])
        service.include_launch_description(LaunchDescription([ended, waits, Note(written, "visited")]))
        task = asyncio.ensure_future(service.run_async())
        while not written:  # noqa: ASYNC110  # of the launch
            await asyncio.sleep(0.01)
        task.cancel()
        await asyncio.wait([task], timeout=8.0)
        assert task.cancelled()

    asyncio.run(asyncio.wait_for(main(), 60.0))
    assert written == ["visited", "ended"]
