"""The demonstration's programs as separate processes, which communicate over DDS on this machine alone."""

from __future__ import annotations

import contextlib
import os
import random
import signal
import socket
import subprocess
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterator, Mapping

from tfloom.demos.program_group import END_GRACE_S, LOG_LINES, ShowError, StartProgram

DOMAINS = range(1, 101)
"""Domains whose ports, by DDS's formula, are outside the system's range of ephemeral ports."""
MAX_TRIES = 5
"""Number of domains that are looked at."""


ENVIRONMENT: Mapping[str, str | None] = {
    "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
    "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp",
    "CYCLONEDDS_URI": None,
}
"""Variables of the programs, which meet on this machine alone; None: it isn't set."""


@contextlib.contextmanager
def environment_set(variables: Mapping[str, str | None]) -> Iterator[None]:
    """Set variables of this process's environment for the block; None: it isn't set."""
    before = {name: os.environ.get(name) for name in variables}
    _set_variables(variables)
    try:
        yield
    finally:
        _set_variables(before)


def _set_variables(variables: Mapping[str, str | None]) -> None:
    for name, value in variables.items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value


@contextlib.contextmanager
def own_domain(is_free: Callable[[int], bool]) -> Iterator[int]:
    """Reserve, for the block, a DDS domain that no other demonstration on this machine uses; a TCP port is the lock.

    Args:
        is_free: Whether nobody else is on a domain.

    Raises:
        ShowError: there is none.
    """
    tries = MAX_TRIES
    for domain in random.sample(DOMAINS, len(DOMAINS)):
        lock = socket.socket()
        try:
            lock.bind(("127.0.0.1", 7400 + 250 * domain))
        except OSError:
            lock.close()
            continue
        with lock:
            if is_free(domain):
                yield domain
                return
        tries -= 1
        if not tries:
            raise ShowError(
                f"others are on each of {MAX_TRIES} DDS domains: set ROS_DOMAIN_ID, and add --here"
            )
    raise ShowError("all DDS domains from 1 to 100 are in use")


def process_starter(domain_id: int) -> StartProgram:
    """Return a function that starts a program as a process on a DDS domain, on the loopback interface alone."""
    variables = {**os.environ, **ENVIRONMENT, "ROS_DOMAIN_ID": str(domain_id)}
    environment = {name: value for name, value in variables.items() if value is not None}
    return lambda command, on_line: ProcessProgram(command, environment, on_line)


class ProcessProgram:
    """A program as a process; see `program_group.Program`.

    Args:
        command: `module:function` or a file, and arguments.
        environment: Its environment variables.
        on_line: Called with each printed line, on a separate thread; `log` keeps the last lines, too.
    """

    def __init__(
        self,
        command: list[str],
        environment: Mapping[str, str],
        on_line: Callable[[str], object] | None = None,
    ) -> None:
        self.log: deque[str] = deque(maxlen=LOG_LINES)
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tfloom.demos.child", *command],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env=environment,
            start_new_session=True,  # a Ctrl-C reaches this process alone, which then ends the others
        )
        self._reader = threading.Thread(target=self._read, args=(on_line,), daemon=True)
        try:
            self._reader.start()
        except RuntimeError:
            self._process.kill()  # nobody would read what it prints, or end it
            self._process.wait()
            raise

    def _read(self, on_line: Callable[[str], object] | None) -> None:
        for line in self._process.stdout or ():
            self.log.append(line.rstrip("\n"))
            if on_line is not None:
                on_line(self.log[-1])

    def exit_code(self) -> int | None:
        """Return its exit code; None while it runs."""
        code = self._process.poll()
        if code is not None:
            self._reader.join(END_GRACE_S)
        return code

    def request_end(self) -> None:
        """Send the signal of Ctrl-C."""
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGINT if os.name == "posix" else signal.SIGTERM)

    def end(self, grace_s: float) -> None:
        """Wait for its end, and kill it after `grace_s`."""
        try:
            self._process.wait(grace_s)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join(END_GRACE_S)
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                pipe.close()
