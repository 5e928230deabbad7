"""A process with its own process group, whose input and output are pipes or terminals of the launch."""

from __future__ import annotations

import asyncio
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext, suppress
from pathlib import Path
from typing import Any, cast

from tfloom.workspace.index import interpreter_with_space

__all__ = ["LocalProcess"]

Output = Callable[[int, bytes], None]
"""Takes 1 for stdout or 2 for stderr, and what was written."""

IsBehind = Callable[[], bool]
"""Returns whether the output should be left in its pipes for now."""

POLL_S = 0.01
"""Time between two questions whether it still should [s]."""

MAX_PAUSES = 20
"""Pauses after the end of a process, between which the rest of its output is read, in parts."""

START_CPU_S = 0.1
"""What a process has computed by the time that its interpreter has started [s]; Python takes a third of it."""

OUTPUT_S = 0.5
"""Time to wait for the rest of the output after the end: a process that inherited the pipe may hold it open."""


class LocalProcess:
    """A process that was started. Use `start`.

    It leads its own process group, so that a signal reaches what it has started, and Ctrl-C on a terminal reaches
    the launch alone, which passes it on once.
    """

    def __init__(self, output: Output, is_behind: IsBehind) -> None:
        self._flow = _Flow(output, is_behind)
        self._protocol = _Protocol(self._flow)
        self._transport: asyncio.SubprocessTransport | None = None
        self._terminals: list[_Terminal] = []

    @classmethod
    async def start(
        cls,
        cmd: Sequence[str],
        output: Output,
        is_behind: IsBehind = lambda: False,
        *,
        cwd: str | None,
        env: Mapping[str, str],
        shell: bool,
        emulate_tty: bool,
        blocks_signals: bool = False,
    ) -> LocalProcess:
        """Start a process.

        Args:
            cmd: The command line; for a shell, its words are joined with spaces.
            output: Called on the loop's thread with each part of the output.
            is_behind: Called after each part; while it returns True, the process is not read, and waits when its pipes
                are full.
            cwd: The folder to start in; None: the launch's.
            env: Its environment variables.
            shell: Whether a shell runs the command line.
            emulate_tty: Whether its stdout and stderr are terminals.
            blocks_signals: Whether it starts with SIGINT and SIGTERM blocked, where the system can do so.

        Raises:
            OSError: the program can't be started.
        """
        self = cls(output, is_behind)
        loop = asyncio.get_running_loop()
        options: dict[str, Any] = {"cwd": cwd, "env": dict(env), "stdin": subprocess.PIPE, **_own_group()}
        # One terminal each for stdout and stderr, else they could not be told apart; without them, pipes of asyncio.
        ends = self._open_terminals() if emulate_tty and os.name == "posix" else []
        if ends:
            options.update(stdout=ends[0][1], stderr=ends[1][1])
        try:
            with _blocked_signals() if blocks_signals else nullcontext():
                if shell:
                    started = await loop.subprocess_shell(lambda: self._protocol, " ".join(cmd), **options)
                else:
                    words = _executable(cmd, env)
                    started = await loop.subprocess_exec(lambda: self._protocol, *words, **options)
        except BaseException:
            for ours, _ in ends:
                os.close(ours)
            raise
        finally:
            # The process has its own copies. With these open, the launch would never read the end of a terminal.
            for _, theirs in ends:
                os.close(theirs)
        self._transport = started[0]
        for number, (ours, _) in enumerate(ends, start=1):
            terminal = _Terminal(number, self._flow)
            self._terminals.append(terminal)
            await loop.connect_read_pipe(lambda terminal=terminal: terminal, os.fdopen(ours, "rb", 0))  # type: ignore[misc]
        return self

    @staticmethod
    def _open_terminals() -> list[tuple[int, int]]:
        if sys.platform == "win32":
            raise NotImplementedError  # `start` asks for pipes there
        import pty

        return [pty.openpty(), pty.openpty()]

    @property
    def _started(self) -> asyncio.SubprocessTransport:
        if self._transport is None:
            raise RuntimeError("the process has not been started")
        return self._transport

    @property
    def pid(self) -> int:
        """Process id, also that of its group."""
        return self._started.get_pid()

    def is_starting(self) -> bool:
        """Return whether its interpreter may still be starting: it has computed little, and doesn't wait."""
        import psutil

        try:
            process = psutil.Process(self.pid)
            times = process.cpu_times()
            return bool(
                times.user + times.system < START_CPU_S and process.status() != psutil.STATUS_SLEEPING
            )
        except psutil.Error:  # it has ended, or belongs to another user
            return False

    def send_signal(self, number: signal.Signals) -> None:
        """Send a signal to the process and to those of its group.

        Raises:
            ProcessLookupError: all have ended.
        """
        if sys.platform != "win32":
            os.killpg(self.pid, number)
        else:
            self._started.terminate()  # Windows sends no SIGINT to a process of another group

    def write(self, data: bytes) -> None:
        """Write to the process's stdin."""
        pipe = None if self._transport is None else self._transport.get_pipe_transport(0)
        if pipe is not None:
            cast("asyncio.WriteTransport", pipe).write(data)

    async def wait(self) -> int:
        """Wait for the end and for the rest of the output, and return the exit code; minus the number of a signal."""
        # The exit comes first; the pipes may still hold output, and a process that inherited them may write on. Usually
        # all pipes close at once, and the first `asyncio.wait` returns. Else it gives up after OUTPUT_S, unless the
        # reading was paused meanwhile because the launch is behind: then there is more to read when it goes on.
        await self._protocol.exited
        silences = [self._protocol.silent, *(terminal.closed for terminal in self._terminals)]
        for _ in range(MAX_PAUSES):
            await self._flow.flows.wait()
            await asyncio.wait(silences, timeout=OUTPUT_S)
            if self._flow.flows.is_set():
                break
        for terminal in self._terminals:
            terminal.close()
        transport = self._started
        code = transport.get_returncode()
        # To close the pipes earlier would kill those to which it has passed its output on, by SIGPIPE. So this is at
        # once if all is silent, else when they have ended.
        self._protocol.silent.add_done_callback(lambda _, close=transport.close: close())  # type: ignore[misc]
        return code if code is not None else 255


def _executable(cmd: Sequence[str], env: Mapping[str, str]) -> Sequence[str]:
    """Return a command line; for a script whose interpreter has a space in its path, one that begins with that."""
    path = shutil.which(cmd[0], path=env.get("PATH"))
    interpreter = [] if path is None else interpreter_with_space(Path(path))
    return [*interpreter, str(path), *cmd[1:]] if interpreter else cmd


@contextmanager
def _blocked_signals() -> Iterator[None]:
    """Block the signals of the end in this thread, because a new process inherits what is blocked."""
    if sys.platform == "win32":
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT, signal.SIGTERM])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _own_group() -> dict[str, Any]:
    if sys.platform == "win32":
        return {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}
    return {"process_group": 0} if sys.version_info >= (3, 11) else {"start_new_session": True}


class _Flow:
    """Passes the output on, and pauses the reading of all pipes of a process while it is not wanted."""

    def __init__(self, output: Output, is_behind: IsBehind) -> None:
        self._output = output
        self._is_behind = is_behind
        self._pipes: list[asyncio.ReadTransport] = []
        self.flows = asyncio.Event()
        """Set while the pipes are read."""
        self.flows.set()

    def add(self, pipe: asyncio.BaseTransport) -> None:
        self._pipes.append(cast("asyncio.ReadTransport", pipe))

    def receive(self, fd: int, data: bytes) -> None:
        self._output(fd, data)
        # A pause of the reading fills the pipe, which holds the process up in its next `write`. The end of the
        # pause is polled for, because most of what is behind is written by other threads, which don't know this loop.
        if self.flows.is_set() and self._is_behind():
            self.flows.clear()
            self._call_on_open_pipes("pause_reading")
            self._poll()

    def _poll(self) -> None:
        if self._is_behind():
            asyncio.get_running_loop().call_later(POLL_S, self._poll)
        else:
            self.flows.set()
            self._call_on_open_pipes("resume_reading")

    def _call_on_open_pipes(self, method: str) -> None:
        for pipe in self._pipes:
            if not pipe.is_closing():
                getattr(pipe, method)()


class _Protocol(asyncio.SubprocessProtocol):
    """Receives what happens to the process."""

    def __init__(self, flow: _Flow) -> None:
        loop = asyncio.get_running_loop()
        self.exited: asyncio.Future[None] = loop.create_future()
        self.silent: asyncio.Future[None] = loop.create_future()
        """Done when the pipes of stdout and stderr are closed."""
        self._flow = flow
        self._open = 0

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        pipes = [cast("asyncio.SubprocessTransport", transport).get_pipe_transport(fd) for fd in (1, 2)]
        for pipe in pipes:
            if pipe is not None:  # there is none for a terminal
                self._open += 1
                self._flow.add(pipe)
        self._finish()

    def pipe_data_received(self, fd: int, data: bytes) -> None:
        self._flow.receive(fd, data)

    def pipe_connection_lost(self, fd: int, exc: Exception | None) -> None:
        if fd != 0:
            self._open -= 1
            self._finish()

    def process_exited(self) -> None:
        _complete(self.exited)

    def _finish(self) -> None:
        if self._open <= 0:
            _complete(self.silent)


class _Terminal(asyncio.Protocol):
    """Receives what the process writes to a terminal."""

    def __init__(self, number: int, flow: _Flow) -> None:
        self.closed: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        self._number = number
        self._flow = flow

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self._transport = transport
        self._flow.add(transport)

    def close(self) -> None:
        self._transport.close()

    def data_received(self, data: bytes) -> None:
        self._flow.receive(self._number, data.replace(b"\r\n", b"\n"))

    def connection_lost(self, exc: Exception | None) -> None:
        _complete(self.closed)


def _complete(future: asyncio.Future[None]) -> None:
    with suppress(asyncio.InvalidStateError):
        future.set_result(None)
