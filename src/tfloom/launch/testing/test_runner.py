"""Launches with tests: brings up a description, runs its tests, and ends it.

The launch runs on the calling thread, because signals are handled there, and its tests on another one.
"""

from __future__ import annotations

import os
import threading
import unittest
from collections.abc import Iterable, Sequence
from typing import Any

from tfloom.launch.core.base_classes import LaunchDescriptionEntity
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.events.event_handlers import OnProcessIO
from tfloom.launch.events.launch_events import Shutdown
from tfloom.launch.events.process import ProcessExited, ProcessStarted
from tfloom.launch.launch_service import LaunchService
from tfloom.launch.testing.actions import TestsCanBegin, Watcher
from tfloom.launch.testing.arguments import parse_launch_arguments
from tfloom.launch.testing.assert_exit_codes import describe_exit_code
from tfloom.launch.testing.assert_output import text_of
from tfloom.launch.testing.io_handler import ActiveIoHandler
from tfloom.launch.testing.loader import TestRun
from tfloom.launch.testing.proc_info_handler import ActiveProcInfoHandler
from tfloom.launch.testing.test_result import FailResult, SkipResult, TestResult

__all__ = ["LaunchTestRunner"]


class LaunchTestRunner:
    """Runs launches one after another, each with its tests.

    Args:
        test_runs: The launches.
        launch_file_arguments: Launch arguments, each as `name:=value`.
        debug: Whether the launch's own log is printed.
    """

    def __init__(
        self, test_runs: Iterable[TestRun], launch_file_arguments: Sequence[str] = (), debug: bool = False
    ) -> None:
        self._test_runs = list(test_runs)
        self._arguments = dict(parse_launch_arguments(launch_file_arguments))
        self._debug = debug

    def generate_preamble(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that are launched before those of each description: none."""
        return []

    def validate(self) -> None:
        """Check that each description can be made.

        Raises:
            DescriptionError: one cannot.
        """
        for run in self._test_runs:
            run.validate()

    def run(self) -> dict[TestRun, unittest.TestResult]:
        """Run all launches, and return the result of each.

        Raises:
            DescriptionError: a description cannot be made.
            KeyboardInterrupt: Ctrl-C ended a launch; its processes have exited.
        """
        results: dict[TestRun, unittest.TestResult] = {}
        for run in self._test_runs:
            if run.skip_reason is not None:
                results[run] = SkipResult(run, run.skip_reason)
                continue
            environment = dict(os.environ)
            try:
                results[run] = _Launch(run, self._arguments, self.generate_preamble(), self._debug).run()
            except unittest.SkipTest as skip:  # raised where the description is made
                results[run] = SkipResult(run, str(skip))
            finally:
                os.environ.clear()  # a description may have changed it
                os.environ.update(environment)
        return results


class _Launch:
    """One launch with its tests."""

    def __init__(
        self, run: TestRun, arguments: dict[str, str], preamble: list[LaunchDescriptionEntity], debug: bool
    ) -> None:
        self._run = run
        self._arguments = arguments
        self._proc_info = ActiveProcInfoHandler()
        self._proc_output = ActiveIoHandler()
        self._service = LaunchService(debug=debug)
        self._can_go_on = threading.Event()
        """Set when the tests can begin, and when the launch has ended before."""
        self._is_ready = False
        self._has_timed_out = False
        self._shutdown: Shutdown | None = None
        self._tests_are_done = False
        self._result: TestResult | None = None
        self._error: BaseException | None = None
        self._preamble = preamble
        self._context: dict[str, Any] = {}

    def run(self) -> unittest.TestResult:
        """Bring up the description, run its tests, and return their results."""
        description, context = self._run.normalized_test_description(self._on_ready)
        self._context = context
        self._service.include_launch_description(self._with_watchers(description))
        self._service.context.launch_configurations.update(self._arguments)
        tests = threading.Thread(target=self._test, name="launch tests", daemon=True)
        tests.start()
        # The launch runs here until its end, which the thread of the tests asks for when they are done. If it ends
        # before, the tests may still wait for a process or for the begin: closing the records and setting the event
        # ends these waits, so that `join` returns.
        code = self._service.run(shutdown_when_idle=not self._run.is_kept_alive)
        has_ended_early = not self._tests_are_done
        self._proc_info.close()
        self._proc_output.close()
        self._can_go_on.set()
        tests.join()
        if self._shutdown is not None and self._shutdown.due_to_sigint:
            raise KeyboardInterrupt
        if self._error is not None:
            raise self._error
        if self._result is None or has_ended_early or code:
            return self._failure(code)
        # All processes have exited, so the tests after the shutdown see complete records, which don't change any more.
        self._result.append(
            self._run_suite(
                self._run.post_shutdown_tests, self._proc_info.recorded, self._proc_output.recorded, {}
            )
        )
        return self._result

    def _with_watchers(self, description: LaunchDescription) -> LaunchDescription:
        """Return a description with what it needs for its tests, and register the handlers that record events."""
        # Before the launch runs, because the first process may start with its first event.
        handlers = [
            Watcher(TestsCanBegin, lambda _: self._on_ready()),
            Watcher(Shutdown, self._on_shutdown),
            Watcher(ProcessStarted, self._on_start),
            Watcher(ProcessExited, self._proc_info.append),
            OnProcessIO(on_stdout=self._proc_output.append, on_stderr=self._proc_output.append),
        ]
        for handler in handlers:
            self._service.context.register_event_handler(handler)
        return LaunchDescription([*self._preamble, description])

    def _on_ready(self) -> None:
        self._is_ready = True
        self._can_go_on.set()

    def _on_start(self, event: ProcessStarted) -> None:
        self._proc_info.append(event)
        self._proc_output.track(event.process_name)

    def _on_shutdown(self, event: Shutdown) -> None:
        self._shutdown = self._shutdown or event

    def _test(self) -> None:
        # `_can_go_on` is set for two reasons: the tests can begin, or the launch has ended before. `_is_ready` tells
        # them apart. Whatever happens here ends the launch, which waits on the other thread.
        try:
            self._has_timed_out = not self._can_go_on.wait(
                min(self._run.ready_timeout_s, threading.TIMEOUT_MAX)
            )
            if self._is_ready:
                self._result = self._run_suite(
                    self._run.pre_shutdown_tests,
                    self._proc_info,
                    self._proc_output,
                    {"launch_service": self._service},
                )
        except BaseException as error:  # it is raised on the thread of the launch
            self._error = error
        finally:
            self._tests_are_done = self._is_ready
            self._service.shutdown()

    def _run_suite(
        self, cases: Iterable[Any], proc_info: Any, proc_output: Any, more: dict[str, Any]
    ) -> TestResult:
        attributes = {"proc_info": proc_info, "proc_output": proc_output, "test_args": self._test_args()}
        suite = self._run.bind(cases, attributes, {**self._context, **attributes, **more})
        runner: Any = unittest.TextTestRunner(verbosity=2, resultclass=TestResult)
        result: TestResult = runner.run(suite)
        return result

    def _test_args(self) -> dict[str, str]:
        """Return the launch arguments, with the defaults of those that were not given."""
        return dict(self._service.context.launch_configurations)

    def _failure(self, code: int) -> FailResult:
        """Return the result of a launch that ended before its tests."""
        if self._has_timed_out:
            message = f"Timed out waiting for processes to start up: no ReadyToTest in {self._run.ready_timeout_s:g} s"
        elif code:
            reason = "" if self._shutdown is None else f": {self._shutdown.reason}"
            message = f"The launch failed with return code {code}{reason}"
        else:
            message = "Processes under test stopped before tests completed"
        details = [*self._exit_lines(), *self._outputs()]
        for case, text in [*getattr(self._result, "failures", ()), *getattr(self._result, "errors", ())]:
            details.append(f"{case}:\n{text}")
        result = FailResult(self._run, message, "\n".join(details))
        print(f"{message}\n{result.details}")
        return result

    def _exit_lines(self) -> list[str]:
        return [
            f"{event.process_name} exited with {describe_exit_code(event.returncode)}"
            for event in self._proc_info
            if isinstance(event, ProcessExited)
        ]

    def _outputs(self) -> list[str]:
        """Return the outputs of the processes that failed."""
        failures = [
            event for event in self._proc_info if isinstance(event, ProcessExited) and event.returncode
        ]
        return [
            f"##### output of {event.process_name} #####\n{text_of(self._proc_output[event.process_name], '')}"
            for event in failures
        ]
