"""What programs ask of actions and of the launch service, beside the recorded answers."""

from __future__ import annotations

import asyncio
import re
import sys
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any
from unittest.mock import NonCallableMock

import pytest

from tfloom.launch.actions.event_actions import RegisterEventHandler, Shutdown
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription
from tfloom.launch.actions.launch_configurations import SetLaunchConfiguration
from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.events.event_handlers import OnProcessExit, OnProcessStart, OnShutdown
from tfloom.launch.events.launch_events import Shutdown as ShutdownEvent
from tfloom.launch.launch_service import LaunchService
from tfloom.launch.testing.actions import KeepAliveProc

Launch = Callable[..., Any]
IS_TERMINAL = "import sys; print(sys.stdout.isatty())"


def python(code: str, **kwargs: Any) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-S", "-c", code], name="program", output="screen", **kwargs)


@pytest.mark.parametrize(
    ("configuration", "argument", "is_terminal"),
    [
        (None, True, True),
        (None, False, False),
        ("true", False, True),
        ("False", True, False),
        ("1", False, True),
    ],
)
def test_the_configuration_emulate_tty_overrides_the_argument(
    launch: Launch, configuration: str | None, argument: bool, is_terminal: bool
) -> None:
    before = [] if configuration is None else [SetLaunchConfiguration("emulate_tty", configuration)]
    ran = launch(*before, python(IS_TERMINAL, emulate_tty=argument))
    assert f"[program-1] {is_terminal}" in ran.lines


def test_a_configuration_emulate_tty_that_is_no_truth_value_ends_the_launch(launch: Launch) -> None:
    ran = launch(SetLaunchConfiguration("emulate_tty", "maybe"), python(IS_TERMINAL))
    assert ran.code == 1
    assert any("invalid condition expression" in line and "'maybe'" in line for line in ran.lines)


def test_numbers_of_processes_count_on_within_a_program(launch: Launch) -> None:
    first, second = launch(python("")), launch(python(""))
    assert any("[program-1]" in line for line in first.lines)
    assert any("[program-2]" in line for line in second.lines)


def test_the_event_loop_of_before_is_there_after_a_launch(launch: Launch) -> None:
    loop = asyncio.new_event_loop()
    try:
        asyncio.set_event_loop(loop)
        launch(python(""))
        assert asyncio.get_event_loop() is loop
    finally:
        asyncio.set_event_loop(None)
        loop.close()


def test_a_loop_that_is_left_is_cleaned_up(launch: Launch) -> None:
    cancelled: list[str] = []

    async def stay() -> None:
        try:
            await asyncio.Event().wait()
        except asyncio.CancelledError:
            cancelled.append("task")
            raise

    tasks = []

    def begin(context: LaunchContext) -> None:
        assert context.asyncio_loop is not None
        tasks.append(context.asyncio_loop.create_task(stay()))

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert launch(OpaqueFunction(function=begin), python("")).code == 0
    assert cancelled == ["task"]


def test_an_idle_service_has_nothing_to_do() -> None:
    service = LaunchService()
    assert service._is_idle()
    service.include_launch_description(LaunchDescription([]))
    assert not service._is_idle()


def test_an_action_does_nothing_by_itself(launch: Launch) -> None:
    assert Action().execute(LaunchContext()) is None
    assert launch(Action()).code == 0


@pytest.mark.parametrize("entities", ["x", ["x"], [[Action()], 7], 7])
def test_what_is_no_entity_is_refused_by_handlers(entities: Any) -> None:
    with pytest.raises(TypeError, match="expected all items in 'on_event' iterable to be of type"):
        OnProcessStart(on_start=entities)


def test_an_entity_that_is_none_ends_the_launch_with_its_type(launch: Launch) -> None:
    ran = launch(OnceReturning(["x"]))
    assert ran.code == 1, ran.lines


class OnceReturning(Action):
    """Returns what it is given as what is to be visited next."""

    def __init__(self, following: Any) -> None:
        super().__init__()
        self._following = following

    def execute(self, context: LaunchContext) -> Any:
        return self._following


def test_a_mock_of_an_action_is_a_target() -> None:
    mock = NonCallableMock(spec=ExecuteProcess)
    handler = OnProcessExit(target_action=mock, on_exit=[])
    assert handler.matcher_description == "event == ProcessExited and ExecuteLocal(event.action)"
    with pytest.raises(TypeError, match="action_matcher must be an 'ExecuteLocal' instance or a callable"):
        OnProcessExit(target_action=NonCallableMock(spec=Action), on_exit=[])


def test_locals_can_only_be_read(context: LaunchContext) -> None:
    context.extend_locals({"foo": 1})
    with pytest.raises(AttributeError, match="can't set attribute 'foo', locals are read-only"):
        context.locals.foo = 2
    with pytest.raises(AttributeError, match=re.escape("'bar', it contains: [foo]")):
        _ = context.locals.bar


def test_a_process_that_keeps_a_launch_alive_ends_with_0_at_any_time(launch: Launch) -> None:
    codes: list[int] = []
    for _ in range(5):
        keeper = KeepAliveProc()
        end = OnProcessStart(target_action=keeper, on_start=[Shutdown(reason="at once")])
        note = OnProcessExit(target_action=keeper, on_exit=lambda event, _: codes.append(event.returncode))
        assert launch(RegisterEventHandler(end), RegisterEventHandler(note), keeper).code == 0
    assert codes == [0] * 5


def test_emitted_events_and_handlers_are_counted(context: LaunchContext) -> None:
    context.emit_event_sync(ShutdownEvent(reason="first"))
    asyncio.run(context.emit_event(ShutdownEvent(reason="second")))
    assert context._event_queue.qsize() == 2
    assert context._event_queue.get_nowait().reason == "first"
    context.register_event_handler(OnShutdown(on_shutdown=[]))
    assert len(context._event_handlers) == 1


def test_a_shutdown_handler_takes_entities_or_a_function() -> None:
    with pytest.raises(TypeError, match="expected all items in 'on_shutdown' iterable"):
        OnShutdown(on_shutdown=7)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("text", "is_on"), [("true", True), ("0", False), ("$(var on)", True), ("$(var off)", False)]
)
def test_a_launch_file_may_give_flags_as_substitutions(
    launch: Launch, tmp_path: Path, text: str, is_on: bool
) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_text(
        '<launch><let name="on" value="yes"/><let name="off" value="no"/>'
        f'<executable cmd="echo a;echo b" name="program" output="screen" shell="{text}"/></launch>',
        "utf-8",
    )
    ran = launch(IncludeLaunchDescription(str(path)))
    assert ("[program-1] b" in ran.lines) == is_on


def test_a_flag_that_is_no_truth_value_ends_the_launch(launch: Launch) -> None:
    ran = launch(python("", shell="maybe"))
    assert ran.code == 1
    assert any("Cannot convert value 'maybe' to '<class 'bool'>'" in line for line in ran.lines)


def test_a_launch_is_not_run_while_a_loop_runs() -> None:
    async def run() -> None:
        with pytest.raises(RuntimeError, match=r"while an asyncio loop runs: await run_async\(\)"):
            LaunchService().run()
        assert await LaunchService().run_async() == 0

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        asyncio.run(run())
