"""The older way to test a launch: actions that have to succeed, and output that has to come."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from tfloom.launch.actions.event_actions import EmitEvent, RegisterEventHandler
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.events.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO
from tfloom.launch.events.launch_events import Shutdown
from tfloom.launch.events.process import ProcessExited, ProcessIO
from tfloom.launch.launch_service import LaunchService

__all__ = ["LaunchTestService"]

_ARMED, _SUCCEEDED, _FAILED = "armed", "success", "failure"


class LaunchTestService:
    """Keeps the state of each test of a launch, and ends the launch when all have succeeded or one has failed."""

    def __init__(self) -> None:
        self._tests: dict[str, dict[str, Any]] = {}

    def add_fixture_action(
        self,
        launch_description: LaunchDescription,
        action: ExecuteProcess,
        exit_allowed: bool | Iterable[int] = (0,),
    ) -> ExecuteProcess:
        """Add a process that the tests need; the launch fails if it exits otherwise than allowed.

        Args:
            launch_description: Gets the action.
            action: The process.
            exit_allowed: Its exit codes, or whether it may exit before the tests have ended.

        Returns:
            The action.
        """

        def on_exit(event: ProcessExited, _: LaunchContext) -> EmitEvent | None:
            allowed = (
                exit_allowed if isinstance(exit_allowed, bool) else event.returncode in set(exit_allowed)
            )
            if allowed or not self._armed_tests():
                return None
            name = f"fixture_{event.process_name}"
            return self._end_test(name, _FAILED, f"{event.process_name} exited with {event.returncode}")

        launch_description.add_action(action)
        handler = OnProcessExit(target_action=action, on_exit=on_exit)
        launch_description.add_action(RegisterEventHandler(handler))
        return action

    def add_test_action(self, launch_description: LaunchDescription, action: Action) -> Action:
        """Add an action that is a test: a process that has to exit with 0, or another one that has to complete.

        Returns:
            The action.
        """
        name = self._arm_test("test", action)
        handler: Any
        if isinstance(action, ExecuteProcess):

            def on_exit(event: ProcessExited, _: LaunchContext) -> EmitEvent | None:
                state = _FAILED if event.returncode else _SUCCEEDED
                return self._end_test(name, state, f"{event.process_name} exited with {event.returncode}")

            handler = OnProcessExit(target_action=action, on_exit=on_exit)
        else:
            handler = OnExecutionComplete(
                target_action=action, on_completion=lambda *_: self._end_test(name, _SUCCEEDED, "")
            )
        launch_description.add_action(action)
        launch_description.add_action(RegisterEventHandler(handler))
        return action

    def add_output_test(
        self,
        launch_description: LaunchDescription,
        action: ExecuteProcess,
        output_test: tuple[Callable[[str], None], Any] | Callable[[str], None],
        test_suffix: str = "output",
        output_filter: Callable[[str], str] | None = None,
        side_effect: str | None = None,
    ) -> None:
        """Add a test of what a process prints.

        Args:
            launch_description: Has the process.
            action: The process.
            output_test: Takes all output so far, and raises AssertionError until it will do; also as the first of a
                tuple, as `create_output_lines_test` returns it.
            test_suffix: Part of the test's name.
            output_filter: Takes the output, and returns what counts of it.
            side_effect: `shutdown` to end the launch when the output will do.
        """
        check = output_test[0] if isinstance(output_test, tuple) else output_test
        name = self._arm_test(test_suffix, action)
        text: list[str] = []

        def on_output(event: ProcessIO) -> EmitEvent | None:
            if self._tests[name]["state"] != _ARMED:
                return None
            text.append(event.text.decode("utf-8", "replace"))
            output = "".join(text)
            try:
                check(output if output_filter is None else output_filter(output))
            except AssertionError as error:
                self._tests[name]["details"] = str(error)
                return None
            ended = self._end_test(name, _SUCCEEDED, "")
            return ended or (self._shutdown(name) if side_effect == "shutdown" else None)

        def on_exit(event: ProcessExited, _: LaunchContext) -> EmitEvent | None:
            if self._tests[name]["state"] != _ARMED:
                return None
            return self._end_test(
                name, _FAILED, f"{event.process_name} has exited: {self._tests[name]['details']}"
            )

        handlers = [
            OnProcessIO(target_action=action, on_stdout=on_output, on_stderr=on_output),
            OnProcessExit(target_action=action, on_exit=on_exit),
        ]
        for handler in handlers:
            launch_description.add_action(RegisterEventHandler(handler))

    def run(self, launch_service: LaunchService, *args: Any, **kwargs: Any) -> int:
        """Run a launch, and return its exit code, or 1 if a test failed or did not end.

        Args:
            launch_service: Has the description.
            args: Those of `LaunchService.run`.
            kwargs: The same, by name.
        """
        code = launch_service.run(*args, **kwargs)
        failed = {name: test for name, test in self._tests.items() if test["state"] != _SUCCEEDED}
        for name, test in failed.items():
            print(f"{name}: {test['state']}: {test['details']}")
        return code or int(bool(failed))

    def _arm_test(self, kind: str, action: object) -> str:
        name = f"{type(action).__name__}_{len(self._tests)}_{kind}"
        self._tests[name] = {"state": _ARMED, "details": "it did not end"}
        return name

    def _armed_tests(self) -> list[str]:
        return [name for name, test in self._tests.items() if test["state"] == _ARMED]

    def _end_test(self, name: str, state: str, details: str) -> EmitEvent | None:
        """Set the state of a test, and return the end of the launch if it is the last one or has failed."""
        self._tests[name] = {"state": state, "details": details}
        return self._shutdown(name) if state == _FAILED or not self._armed_tests() else None

    def _shutdown(self, name: str) -> EmitEvent:
        return EmitEvent(event=Shutdown(reason=f"{name} has ended: {self._tests[name]['state']}"))
