"""The engine: it visits descriptions, and handles events in order until nothing is left to do.

A launch is a queue of events. To include a description is an event; its handler returns the description, which is a
tree of entities. A visit of an entity does what it stands for and returns the entities to visit next, depth first. An
entity that goes on after its visit, as a process does, has a future, and emits events meanwhile; handlers of these
return more entities. When no event waits and no future is open, the launch is idle, which emits the event Shutdown.

Each action handles Shutdown itself: that of a process sends SIGINT, then SIGTERM, then SIGKILL (see
`actions/execute_local.py`), and a timer ends its wait. Ctrl-C, an error, and the cancellation of the launch's task emit
Shutdown, too. After it has been handled and all is idle again, the launch has ended; processes that its processes have
left behind are ended last.

Read `run_async` first; what it calls follows in that order, and after it what other threads call.
"""

from __future__ import annotations

import asyncio
import logging
import signal
import sys
import threading
import traceback
from collections.abc import Coroutine, Iterable, Iterator
from contextlib import contextmanager
from typing import Any

from tfloom.launch.core.base_classes import (
    LaunchDescriptionEntity,
    normalize_to_list_of_entities,
)
from tfloom.launch.core.error_places import describe_failure
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.launch.core.run_state import HandlesEvents
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.events.event_handlers import OnIncludeLaunchDescription, OnShutdown
from tfloom.launch.events.launch_events import IncludeLaunchDescription, Shutdown
from tfloom.launch.logs.background_writing import background_writing
from tfloom.launch.logs.logging import LOG_FILE_NAME, get_logger, launch_config, log_launch_config
from tfloom.launch.processes.guard import guard_of
from tfloom.launch.utilities.signal_management import AsyncSafeSignalManager
from tfloom.launch.utilities.visits import visit_all_entities
from tfloom.ros_imports.guard import ros_repr

__all__ = ["LaunchService"]

ENDING_SIGNALS = ("SIGTERM", "SIGHUP", "SIGQUIT")
"""Signals that end the launch as Ctrl-C does."""

CLOSE_S = 0.05
"""Time for the rest of the output of processes that were left behind [s]."""


class LaunchService(HasPrivateNames):
    """Launches descriptions.

    Args:
        argv: The arguments of the command line, for `context.argv`.
        noninteractive: Whether the launch has no terminal.
        debug: Whether everything is logged, and asyncio checks the use of its loop.
        log_file_name: Name of the launch's own log file in its log folder.

    Raises:
        ValueError: `log_file_name` is not the name of a file, because it is empty or has a folder.
    """

    def __init__(
        self,
        *,
        argv: Iterable[str] | None = None,
        noninteractive: bool = False,
        debug: bool = False,
        log_file_name: str = LOG_FILE_NAME,
    ) -> None:
        launch_config.log_file_name = log_file_name
        if debug:
            launch_config.level = logging.DEBUG
        self._debug = debug
        self._logger = get_logger("launch")
        self._context = LaunchContext(argv=argv, noninteractive=noninteractive)
        self._state = self._context.run_state
        self._has_begun_shutdown = False
        """Whether a Shutdown event was emitted, or is being handled, or was."""
        self._context.register_event_handler(OnIncludeLaunchDescription())
        self._context.register_event_handler(OnShutdown(on_shutdown=self._on_shutdown))
        self._open: list[tuple[LaunchDescriptionEntity, asyncio.Future[Any]]] = []
        """Entities that go on, each with its future."""
        self._return_code = 0
        self._lock = threading.Lock()
        """Guards the members below, which other threads read."""
        self._loop: asyncio.AbstractEventLoop | None = None
        self._task: asyncio.Task[Any] | None = None
        self._thread: int | None = None

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def context(self) -> LaunchContext:
        """State of the launch."""
        return self._context

    @property
    def event_loop(self) -> asyncio.AbstractEventLoop | None:
        """Loop that runs the launch; None while it doesn't run."""
        return self._loop

    @property
    def task(self) -> asyncio.Task[Any] | None:
        """Task that runs the launch; None while it doesn't run."""
        return self._task

    # The run

    def run(self, *, shutdown_when_idle: bool = True) -> int:
        """Run the launch until its end; return 0, or 1 if an error ended it.

        Args:
            shutdown_when_idle: Whether the launch ends when nothing is left to do; else it waits for events.

        Raises:
            RuntimeError: the launch runs already, or this thread runs an asyncio loop.
        """
        if _is_in_event_loop():
            raise RuntimeError(
                "LaunchService.run() can't be called while an asyncio loop runs: await run_async()"
            )
        return _run(self.run_async(shutdown_when_idle=shutdown_when_idle), debug=self._debug)

    async def run_async(self, *, shutdown_when_idle: bool = True) -> int:
        """Run the launch until its end, as `run` does."""
        with self._running(asyncio.get_running_loop()) as loop, self._signal_handlers(loop):
            async with background_writing.running(self._warn_of_dropped_lines):
                log_launch_config(logger=self._logger)
                await self._run_to_its_end(shutdown_when_idle=shutdown_when_idle)
        return self._return_code

    async def _run_to_its_end(self, *, shutdown_when_idle: bool) -> None:
        try:
            await self._handle_events(shutdown_when_idle=shutdown_when_idle)
        except asyncio.CancelledError:
            # The processes still run. They end as at any shutdown: the events of their end are handled here, before
            # the task is cancelled for good. A second cancellation ends this wait, and the guard ends what is left.
            self._shut_down("the launch's task was cancelled")
            await self._handle_events(shutdown_when_idle=True)
            raise
        finally:
            left = guard_of(self._context).close()
            if left:
                # They may have held the pipes of the processes that had started them: the loop reads what is in there.
                await asyncio.sleep(CLOSE_S)
                self._logger.warning("ended processes that others had started and left: %s", ", ".join(left))

    async def _handle_events(self, *, shutdown_when_idle: bool) -> None:
        """Handle events in order, until the launch is idle after its shutdown."""
        # `_wake` is cleared at the end of each round, and all conditions are checked after that without an `await`
        # between. So a wake-up can come too early, which costs one round, but none is lost.
        state = self._state
        while True:
            if not state.events.empty():
                self._handle(state.events.get_nowait())
                await asyncio.sleep(0)  # processes and timers go on between events
            elif not self._is_idle():
                await self._wake.wait()
            elif state.is_shutdown:
                return
            elif shutdown_when_idle and not self._has_begun_shutdown:
                # Idle, but the end is not reached: handlers of Shutdown may return entities that go on.
                self._has_begun_shutdown = True
                await self._context.emit_event(Shutdown(reason="idle"))
            else:
                await self._wake.wait()
            self._wake.clear()

    def _handle(self, event: Event) -> None:
        """Visit what the handlers of an event return."""
        self._logger.debug("processing event: '%s'", event)
        if isinstance(event, Shutdown):
            self._has_begun_shutdown = True  # before its handlers: an error in one must not emit another
        # A copy, because a handler may register others, which are asked from the next event on.
        for handler in tuple(self._state.handlers):
            try:
                self._handle_by(handler, event)
            except Exception as error:  # of a user's description
                # The other handlers are called: at the shutdown, those that end the processes and the launch itself.
                self._fail(error)

    def _handle_by(self, handler: HandlesEvents, event: Event) -> None:
        if not handler.matches(event):
            return
        self._logger.debug("processing event: '%s' ✓ '%s'", event, handler)
        returned = handler.handle(event, self._context)
        for entity in normalize_to_list_of_entities([returned] if returned is not None else []):
            self._visit(entity)

    def _visit(self, entity: LaunchDescriptionEntity) -> None:
        # The visit is a generator. If an entity raises, the processes that were started before it are already in
        # `_open`, so that the launch waits for their end.
        for entity_and_future in visit_all_entities(entity, self._context):
            self._open.append(entity_and_future)
            entity_and_future[1].add_done_callback(lambda _: self._wake.set())

    def _has_open_futures(self) -> bool:
        """Drop the futures that are done, end the launch if one failed, and return whether any is open."""
        for _, future in self._open:
            if future.done() and not future.cancelled() and (error := future.exception()) is not None:
                self._fail(error)
        self._open = [pair for pair in self._open if not pair[1].done()]
        return bool(self._open) or self._state.has_open_futures()

    def _is_idle(self) -> bool:
        """Return whether no event waits, and no entity goes on."""
        return self._state.events.empty() and not self._has_open_futures()

    # Its end

    def _on_shutdown(self, event: Shutdown, context: LaunchContext) -> None:
        self._state.is_shutdown = True

    def _shut_down(self, reason: str, *, due_to_sigint: bool = False) -> None:
        # Other errors and signals, before the event is handled and after, must not begin another shutdown: its handlers
        # would run twice.
        if not self._has_begun_shutdown:
            self._has_begun_shutdown = True
            self._context.emit_event_sync(Shutdown(reason=reason, due_to_sigint=due_to_sigint))

    def _fail(self, error: BaseException) -> None:
        """Log an error, and end the launch."""
        self._logger.debug("%s", "".join(traceback.format_exception(error)))
        text = describe_failure(error)
        self._logger.error("Caught exception in launch (see debug for traceback): %s", text)
        self._return_code = 1
        self._shut_down(f"Caught exception in launch: {text}")

    def _warn_of_dropped_lines(self, destination: str, count: int) -> None:
        self._logger.warning("%d lines are lost: %s did not take them in time", count, destination)

    def _on_interrupt(self, _: int) -> None:
        background_writing.hurry()
        text = "user interrupted with ctrl-c (SIGINT)"
        if self._state.is_shutdown:
            self._logger.warning("%s again, ignoring...", text)
            return
        self._logger.warning("%s", text)
        self._shut_down(text, due_to_sigint=True)

    def _on_ending_signal(self, number: int) -> None:
        background_writing.hurry()
        text = f"{signal.Signals(number).name} received"
        self._logger.warning("%s, ending all processes", text)
        self._shut_down(text)

    # Around the run

    @contextmanager
    def _running(self, loop: asyncio.AbstractEventLoop) -> Iterator[asyncio.AbstractEventLoop]:
        # Whether it runs is checked and noted under one lock, because two threads may call `run`.
        with self._lock:
            if self._loop is not None:
                raise RuntimeError("LaunchService is already running")
            self._loop, self._thread, self._task = loop, threading.get_ident(), asyncio.current_task()
        self._wake = asyncio.Event()
        self._has_begun_shutdown = False
        self._state.start(loop, self._wake.set, self._fail)
        try:
            yield loop
        finally:
            self._state.stop()
            with self._lock:
                self._loop = self._thread = self._task = None

    @contextmanager
    def _signal_handlers(self, loop: asyncio.AbstractEventLoop) -> Iterator[None]:
        signals = AsyncSafeSignalManager(loop)
        signals.handle(signal.SIGINT, self._on_interrupt)
        for name in ENDING_SIGNALS:
            if hasattr(signal, name):
                signals.handle(getattr(signal, name), self._on_ending_signal)
        with signals:
            yield

    # From any thread

    def include_launch_description(self, launch_description: LaunchDescription) -> None:
        """Add a description to the launch, before it runs or while it does."""
        self.emit_event(IncludeLaunchDescription(launch_description))

    def emit_event(self, event: Event) -> None:
        """Add an event to those that are handled, before the launch runs or while it does."""
        with self._lock:
            loop, is_own = self._loop, self._thread in (None, threading.get_ident())
        if loop is None or is_own:
            self._context.emit_event_sync(event)
        else:
            # The queue and the asyncio.Event that wakes its reader belong to the loop's thread.
            loop.call_soon_threadsafe(self._context.emit_event_sync, event)

    def shutdown(self, force_sync: bool = False) -> Coroutine[Any, Any, None] | None:
        """End the launch, and all its processes. `run` returns after their end.

        Args:
            force_sync: Whether nothing is returned, also on the launch's own thread.

        Returns:
            On the launch's own thread, a coroutine that emits the event when it is awaited; else None, it has been
            emitted.
        """
        event = Shutdown(reason="LaunchService.shutdown() called")
        if self._loop is None or self._state.is_shutdown:
            return None
        if not force_sync and self._thread == threading.get_ident():
            return self._context.emit_event(event)
        self.emit_event(event)
        return None


def _is_in_event_loop() -> bool:
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return False
    return True


def _run(main: Coroutine[Any, Any, int], *, debug: bool) -> int:
    """Run a coroutine as `asyncio.run` does, on a loop that is not set as that of the thread.

    `asyncio.run` would leave the thread without a loop, and a program that calls `asyncio.get_event_loop()` after a
    launch would get an error in place of the loop that it had before.
    """
    if sys.version_info >= (3, 11):
        with asyncio.Runner(debug=debug, loop_factory=asyncio.new_event_loop) as runner:
            return runner.run(main)
    loop = asyncio.new_event_loop()
    try:
        loop.set_debug(debug)
        return loop.run_until_complete(main)
    finally:
        tasks = asyncio.all_tasks(loop)
        for task in tasks:
            task.cancel()
        if tasks:
            loop.run_until_complete(asyncio.wait(tasks))
        loop.run_until_complete(loop.shutdown_asyncgens())
        loop.run_until_complete(loop.shutdown_default_executor())
        loop.close()
