"""The action that runs a process on this machine."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tfloom.common.seconds import checked_timeout
from tfloom.launch.actions.executable import Executable
from tfloom.launch.actions.process_output import ProcessOutput
from tfloom.launch.core.base_classes import (
    LaunchDescriptionEntity,
    SomeEntitiesType,
    SomeSubstitutionsType,
    normalize_to_list_of_entities,
)
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.conditions import evaluate_condition_expression
from tfloom.launch.entities.event_handler import BaseEventHandler, EventHandler
from tfloom.launch.events.event_handlers import OnProcessExit, OnShutdown
from tfloom.launch.events.process import (
    ProcessExited,
    ProcessStarted,
    ProcessStdin,
    ProcessTargetedEvent,
    ShutdownProcess,
    SignalProcess,
)
from tfloom.launch.logs.logging import OutputConfig, get_logger
from tfloom.launch.substitutions.variables import LaunchConfiguration
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions
from tfloom.launch.utilities.type_utils import (
    coerce_to_type,
    normalize_typed_substitution,
    perform_typed_substitution,
)
from tfloom.ros_imports.interrupted import LAUNCHED

if TYPE_CHECKING:
    import asyncio

    from tfloom.launch.processes.local_process import LocalProcess

# asyncio and psutil are imported when a process runs, because `--show-args` takes less time than their import.

__all__ = ["ExecuteLocal"]

MAX_START_S = 2.0
"""How long SIGINT waits for the start of an interpreter [s]."""

START_POLL_S = 0.02
"""Time between two questions whether it still starts [s]."""

OnExit = SomeEntitiesType | Callable[[Any, LaunchContext], SomeEntitiesType | None]


class ExecuteLocal(Action):
    """Runs a process, and ends it with the launch: by SIGINT, then SIGTERM, then SIGKILL, each to its process group.

    Args:
        process_description: The program.
        shell: Whether a shell runs the command line.
        sigterm_timeout: Time between SIGINT and SIGTERM [s].
        sigkill_timeout: Time between SIGTERM and SIGKILL [s].
        emulate_tty: Whether its stdout and stderr are terminals, so that it writes colors, and each line at once. The
            launch configuration `emulate_tty` overrides it, as in `ros2 launch … emulate_tty:=true`.
        output: Where its output goes: "screen", "log" (and stderr on the screen), "both", "own_log" (its own files),
            "full" (all of them), or a dictionary from "stdout", "stderr", "both" to sets of "screen", "log", "own_log".
            The environment variable OVERRIDE_LAUNCH_PROCESS_OUTPUT overrides it.
        output_format: Format of each line on the screen and in the log, of `line` and `this`, the action.
        cached_output: Whether `get_stdout` and `get_stderr` return everything, in place of the last, incomplete line.
        log_cmd: Whether the command line is logged at the start.
        on_exit: Entities that are visited when it ends, or a function that takes the event and the context and returns
            them. With `respawn`, after each end.
        respawn: Whether it is started again when it ends before the launch.
        respawn_delay: Time before that [s].
        respawn_max_retries: How often; negative: always.
        kwargs: As for Action.
    """

    _blocks_signals = False
    """Whether the process starts with SIGINT and SIGTERM blocked, which it unblocks when it has its handlers."""

    _other_names: ClassVar = {"respawn_delay": "_respawn_delay_s"}

    def __init__(
        self,
        *,
        process_description: Executable,
        shell: bool = False,
        sigterm_timeout: SomeSubstitutionsType = LaunchConfiguration("sigterm_timeout", default=5),
        sigkill_timeout: SomeSubstitutionsType = LaunchConfiguration("sigkill_timeout", default=5),
        emulate_tty: bool = False,
        output: SomeSubstitutionsType | dict[str, Any] = "log",
        output_format: str = "[{this.process_description.final_name}] {line}",
        cached_output: bool = False,
        log_cmd: bool = False,
        on_exit: OnExit | None = None,
        respawn: bool | SomeSubstitutionsType = False,
        respawn_delay: float | None = None,
        respawn_max_retries: int = -1,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self._process_description = process_description
        self._shell = shell
        self._sigterm_timeout = normalize_to_list_of_substitutions(sigterm_timeout)
        self._sigkill_timeout = normalize_to_list_of_substitutions(sigkill_timeout)
        # The attributes have double underscores upstream, too; programs set this one.
        self.__emulate_tty = emulate_tty
        self._has_terminals = self._has_shell = False
        self._max_start_s = MAX_START_S
        destination = os.environ.get("OVERRIDE_LAUNCH_PROCESS_OUTPUT", output)
        self._given_output = (
            destination if isinstance(destination, dict) else normalize_to_list_of_substitutions(destination)
        )
        self._output: ProcessOutput | None = None
        self._output_format = output_format
        self._cached_output = cached_output
        self._log_cmd = log_cmd
        self._on_exit = on_exit
        self._respawn = normalize_typed_substitution(respawn, bool)
        self._respawn_delay_s = (
            0.0 if respawn_delay is None else checked_timeout("respawn_delay", respawn_delay)
        )
        self._respawn_max_retries = respawn_max_retries
        self._respawn_count = 0
        self._process: LocalProcess | None = None
        self._planned: dict[str, Any] | None = None
        """The details that are known before the process has a pid."""
        self._details: dict[str, Any] | None = None
        self._early_output: list[tuple[int, bytes]] = []
        self._completed_future: asyncio.Future[None] | None = None
        self._shutdown_future: asyncio.Future[None] | None = None
        self._handlers: list[BaseEventHandler] = []
        self._escalation: list[asyncio.TimerHandle] = []
        self._return_code: int | None = None
        self._logger = get_logger("launch.execute_local")

    # Properties

    @property
    def process_description(self) -> Executable:
        """Program with its arguments, its folder and its environment."""
        return self._process_description

    @property
    def shell(self) -> bool:
        """Whether a shell runs the command line."""
        return self._shell

    @property
    def emulate_tty(self) -> bool:
        """Whether its stdout and stderr are terminals."""
        return self.__emulate_tty

    @property
    def output(self) -> Any:
        """Where its output goes, as given; in a list of substitutions, or a dictionary."""
        return self._given_output

    @property
    def sigterm_timeout(self) -> Any:
        """Time between SIGINT and SIGTERM [s]."""
        return self._sigterm_timeout

    @property
    def sigkill_timeout(self) -> Any:
        """Time between SIGTERM and SIGKILL [s]."""
        return self._sigkill_timeout

    @property
    def process_details(self) -> dict[str, Any] | None:
        """Arguments of the events of the process: action, name, cmd, cwd, env, and from its start, pid.

        None before the action is executed.
        """
        return self._details or self._planned

    @property
    def return_code(self) -> int | None:
        """Exit code, minus a signal's number if that ended the process; None before its end."""
        return self._return_code

    def get_stdout(self) -> str:
        """Return what the process has written to stdout: see `cached_output`."""
        return "" if self._output is None else self._output.text(1)

    def get_stderr(self) -> str:
        """Return what the process has written to stderr: see `cached_output`."""
        return "" if self._output is None else self._output.text(2)

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that are visited when it ends."""
        if self._on_exit is None or callable(self._on_exit):
            return []
        return normalize_to_list_of_entities([self._on_exit])

    def get_asyncio_future(self) -> asyncio.Future[None] | None:
        """Return a future that is done when the process has ended for good."""
        return self._completed_future

    # The life of the process, from top to bottom

    def prepare(self, context: LaunchContext) -> None:
        """Perform the substitutions of the program."""
        self._process_description.prepare(context, self)

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the process.

        Raises:
            RuntimeError: it was executed before, or no launch runs.
            ValueError: `output` is not an output, a timeout is not a number, or the configuration `emulate_tty`
                is neither true nor false.
        """
        self.prepare(context)
        name = str(self._process_description.final_name)
        if self._completed_future is not None:
            raise RuntimeError(f"ExecuteLocal action '{name}': executed more than once: {self.describe()}")
        if context.is_shutdown:
            return None  # an event of its end has overtaken it
        loop = context.asyncio_loop
        if loop is None:
            raise RuntimeError(f"'{name}' can't be started: no LaunchService runs")
        output: OutputConfig = (
            self._given_output
            if isinstance(self._given_output, dict)
            else perform_substitutions(context, self._given_output)
        )
        executable = self._process_description
        self._planned = {
            "action": self,
            "name": name,
            "cmd": executable.final_cmd or [],
            "cwd": executable.final_cwd,
            "env": executable.final_env,
        }
        self._has_terminals = self._emulates_terminals(context)
        self._has_shell = _flag(context, self._shell)
        self._output = ProcessOutput(self, name, output, self._output_format, is_cached=self._cached_output)
        timeouts = {
            number: _seconds(context, name, text)
            for number, text in (("SIGTERM", self._sigterm_timeout), ("SIGKILL", self._sigkill_timeout))
        }
        # Both before the task's first step: the visit asks for the first one as soon as this returns, and an event of
        # the end may be handled before the process is started.
        self._completed_future = loop.create_future()
        self._shutdown_future = loop.create_future()
        # Now, because the configurations of an enclosing group or include are gone when the process ends.
        respawns = perform_typed_substitution(context, self._respawn, bool)
        self._register_handlers(context, timeouts)
        self._task = loop.create_task(self._run(context, respawns=respawns))
        return None

    def _emulates_terminals(self, context: LaunchContext) -> bool:
        if "emulate_tty" in context.launch_configurations:
            return evaluate_condition_expression(context, [LaunchConfiguration("emulate_tty")])
        return _flag(context, self.__emulate_tty)

    def _register_handlers(self, context: LaunchContext, timeouts: dict[str, tuple[str, float]]) -> None:
        self._handlers = [
            _Targeted(self, ShutdownProcess, lambda _, context: self._shut_down(context, timeouts)),
            _Targeted(self, SignalProcess, lambda event, _: self._send_signal(event.signal)),
            _Targeted(self, ProcessStdin, lambda event, _: self._write(event.text)),
            OnShutdown(on_shutdown=lambda _, context: self._shut_down(context, timeouts)),
        ]
        for handler in self._handlers:
            context.register_event_handler(handler)
        if self._on_exit is not None:
            # It stays, because the event of the process's end is handled after the process is gone.
            context.register_event_handler(OnProcessExit(target_action=self, on_exit=self._on_exit))

    async def _run(self, context: LaunchContext, *, respawns: bool) -> None:
        """Run the process, again as often as `respawn` says."""
        try:
            while await self._run_once(context) and respawns and await self._waits_to_respawn(context):
                self._respawn_count += 1
        finally:
            # After an error, too, which would otherwise leave a future that is never done, and a launch without end.
            self._clean_up(context)

    async def _run_once(self, context: LaunchContext) -> bool:
        """Run the process from its start to its end; return whether it could be started."""
        from tfloom.launch.processes.guard import guard_of
        from tfloom.launch.processes.local_process import LocalProcess

        executable = self._process_description
        name, cmd = str(executable.final_name), executable.final_cmd or []
        logger = get_logger(name)
        environment = {
            "PYTHONUNBUFFERED": "1",  # else a pipe delays what is printed
            **(executable.final_env or {}),
            LAUNCHED: "1",
        }
        if self._log_cmd:
            logger.info("process details: cmd='%s', cwd='%s'", " ".join(cmd), executable.final_cwd)
        guard = guard_of(context)
        # The loop reads the pipes while `start` still waits. Without details, `_receive` keeps what arrives: the events
        # of output follow that of the start, and carry the process id. After a respawn, the old details are wrong.
        self._details = None
        try:
            process = await LocalProcess.start(
                cmd,
                lambda fd, data: self._receive(context, fd, data),
                lambda: self._output is not None and self._output.is_behind(context),
                cwd=executable.final_cwd,
                env=guard.environment(environment),
                shell=self._has_shell,
                emulate_tty=self._has_terminals,
                blocks_signals=self._blocks_signals,
            )
        except (OSError, ValueError) as error:
            logger.error(  # noqa: TRY400  # a traceback says no more
                "process could not be started: %s", _start_error(error, cmd, executable.final_cwd)
            )
            return False
        # At once, in case that the launch is killed: the guardian finds the group even if the process clears its
        # environment, which holds the launch's id.
        guard.add(process.pid)
        self._process = process
        self._started_s = time.monotonic()
        self._details = {**(self._planned or {}), "pid": process.pid}
        logger.info("process started with pid [%d]", process.pid)
        await context.emit_event(ProcessStarted(**self._details))
        for early in self._early_output:
            self._receive(context, *early)
        self._early_output.clear()
        if self._shutdown_future is not None and self._shutdown_future.done():
            # The end was asked for while `start` waited. `_shut_down` had no process then: it has set the timers of
            # SIGTERM and SIGKILL, and left SIGINT to this line.
            self._interrupt()
        code = await process.wait()
        # From here on the system may give the process id to another process. The guard is told, and without
        # `_process` no timer and no event sends a signal.
        guard.ended(process.pid)
        self._return_code = code
        self._process = None
        # A last line without a line end is printed before the line that tells the end. The event of the end comes last,
        # so that its handlers find the return code and all output.
        if self._output is not None:
            self._output.flush()
        if code == 0:
            logger.info("process has finished cleanly [pid %d]", process.pid)
        else:
            logger.error(
                "process has died [pid %d, exit code %d, cmd '%s'].", process.pid, code, " ".join(cmd)
            )
        await context.emit_event(ProcessExited(returncode=code, **self._details))
        return True

    async def _waits_to_respawn(self, context: LaunchContext) -> bool:
        """Wait for `respawn_delay`; return whether the process is to be started again."""
        if context.is_shutdown or self._shutdown_future is None or self._shutdown_future.done():
            return False
        if 0 <= self._respawn_max_retries <= self._respawn_count:
            return False
        if self._respawn_delay_s is None or self._respawn_delay_s > 0.0:
            import asyncio

            # The end of the launch ends the wait, too.
            await asyncio.wait([self._shutdown_future], timeout=self._respawn_delay_s)
        return not self._shutdown_future.done()

    def _clean_up(self, context: LaunchContext) -> None:
        # A timer that is left would find no process; but it would keep this action alive until then.
        for timer in self._escalation:
            timer.cancel()
        for handler in self._handlers:
            context.unregister_event_handler(handler)
        self._handlers.clear()
        if self._completed_future is not None and not self._completed_future.done():
            self._completed_future.set_result(None)

    # Its end

    def _shut_down(self, context: LaunchContext, timeouts: dict[str, tuple[str, float]]) -> None:
        """Send SIGINT, and later the signals that a process can't ignore."""
        # Several events lead here: Shutdown, and ShutdownProcess as often as a user emits it. The first one counts:
        # a second set of timers would send each signal twice.
        future = self._shutdown_future
        if future is None or future.done() or self._completed_future is None or self._completed_future.done():
            return
        # This ends the wait of a respawn, and `_run_once` reads it if the process is just being started.
        future.set_result(None)
        loop = self._completed_future.get_loop()
        # Both timers start now, the second one with the sum of the times. They run also while there is no process yet,
        # and `_clean_up` cancels them after its end.
        end_s, before = 0.0, "SIGINT"
        self._max_start_s = min([MAX_START_S, *(seconds / 2 for _, seconds in timeouts.values())])
        for number, (text, seconds) in timeouts.items():
            end_s += seconds
            self._escalation.append(loop.call_later(end_s, self._escalate, text, before, number))
            before = number
        if self._process is not None:
            self._interrupt()

    def _interrupt(self) -> None:
        """Send SIGINT, once the interpreter of the process has started.

        Python prints `Fatal Python error`, and a traceback of its own modules, when an interrupt reaches it earlier.
        """
        process, completed = self._process, self._completed_future
        if process is None or completed is None:
            return
        if time.monotonic() < self._started_s + self._max_start_s and process.is_starting():
            self._escalation.append(completed.get_loop().call_later(START_POLL_S, self._interrupt))
        else:
            self._send_signal(signal.SIGINT)

    def _escalate(self, seconds: str, before: str, number: str) -> None:
        if self._process is None:
            return
        name = self._process_description.final_name
        get_logger(str(name)).error(
            "process[%s] failed to terminate '%s' seconds after receiving '%s', escalating to '%s'",
            name, seconds, before, number,
        )  # fmt: skip
        self._send_signal(signal.Signals[number])

    def _send_signal(self, number: signal.Signals) -> None:
        name = str(self._process_description.final_name)
        logger = get_logger(name)
        if self._process is None:
            logger.debug("signal '%s' not sent to process[%s], which does not run", number.name, name)
            return
        logger.info("sending signal '%s' to process[%s]", number.name, name)
        try:
            self._process.send_signal(number)
        except ProcessLookupError:
            logger.debug("process[%s] has just ended", name)
        except PermissionError as error:
            logger.error(  # noqa: TRY400
                "signal '%s' can't be sent to process[%s]: %s", number.name, name, error.strerror
            )

    # Its input and output

    def _write(self, text: bytes) -> None:
        if self._process is not None:
            self._process.write(text)

    def _receive(self, context: LaunchContext, fd: int, data: bytes) -> None:
        if self._details is None:
            self._early_output.append((fd, data))  # which arrived before the event of the start
        elif self._output is not None:
            self._output.receive(context, fd, data)


class _Targeted(EventHandler):
    """Handles the events of a kind whose matcher accepts an action."""

    def __init__(
        self, action: ExecuteLocal, kind: type[Event], handle: Callable[[Any, LaunchContext], None]
    ) -> None:
        def matches(event: Event) -> bool:
            return (
                isinstance(event, kind)
                and isinstance(event, ProcessTargetedEvent)
                and event.process_matcher(action)
            )

        super().__init__(matcher=matches)
        self._handle = handle

    def handle(self, event: Event, context: LaunchContext) -> None:
        super().handle(event, context)
        self._handle(event, context)


def _flag(context: LaunchContext, value: Any) -> bool:
    """Return whether something is on, which XML and YAML files may give as a text or as substitutions."""
    if isinstance(value, str):
        return bool(coerce_to_type(value, bool))
    return bool(perform_typed_substitution(context, normalize_typed_substitution(value, bool), bool))


def _seconds(context: LaunchContext, name: str, substitutions: Any) -> tuple[str, float]:
    """Return a timeout as its text and as a number."""
    text = perform_substitutions(context, substitutions)
    try:
        seconds = float(text)
    except ValueError:
        raise ValueError(f"the timeout '{text}' of '{name}' is not a number of seconds") from None
    if not 0.0 <= seconds < 1e9:
        raise ValueError(f"the timeout '{text}' of '{name}' is not between 0 and 1e9 seconds")
    return text, seconds


def _start_error(error: Exception, cmd: list[str], cwd: str | None) -> str:
    if isinstance(error, FileNotFoundError):
        if cwd is not None and not Path(cwd).is_dir():
            return f"its folder '{cwd}' does not exist"
        return f"no program '{cmd[0]}' was found"
    if isinstance(error, PermissionError):
        return f"'{cmd[0]}' is not executable: check it with `ls -l`"
    return f"'{cmd[0]}': {error.strerror if isinstance(error, OSError) else error}"
