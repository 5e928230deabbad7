"""A viewer's side of driving: it passes on what pages want, from any thread, and never waits."""

from __future__ import annotations

import json
import math
import os
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import IO, TYPE_CHECKING, cast

from tfloom.rmw.backends import implementation_identifier
from tfloom.rmw.base import NodeName
from tfloom.rmw.local.wire import LocalParticipant
from tfloom.viewer.driving.driver import TWIST_TYPES, Driver, Wish, run_driver
from tfloom.viewer.page_command import PageError, fault_text

if TYPE_CHECKING:
    from tfloom.rmw.base import Participant

__all__ = ["Driving"]

LINEAR_M_S = 2.0
ANGULAR_RAD_S = 2.0
"""The speeds of a stick at its end, as those of turtlesim's keys."""
MAX_WAITING = 200
"""Number of commands that wait for the driver; of more, the newest are dropped, and silence stops the robot."""
PROGRAM = (
    "import sys; sys.path[:] = [path for path in sys.path if path]; "
    "from tfloom.viewer.driving.process import main; sys.exit(main(sys.argv[1:]))"
)
"""What the process runs: without the current folder among those of modules, which anything may be in."""
MAX_END_S = 3.0
"""How long the process has to stop everything and end [s]."""
MAX_START_S = 10.0
"""How long a process that is started at the end, to stop what a killed one has left, has for that [s]."""
RESTART_S = 1.0
"""Least time between two starts of the process [s]."""
MAX_DRIFT = 1e-3
"""How far two clocks drift apart in a second at most [s]."""
MAX_LEFT_S = 5.0
"""Age above which a wish needs no stop by a new process if the one before is killed [s]: that one has stopped it."""
MAX_TRY_S = 60.0
"""How long a process that can't be started, or that ends at once, is tried again to stop what was driven [s]."""


class Driving:
    """Drives robots for pages, by a separate process.

    It is a thread where no other process can be: on the wire within one process, and in a frozen program, which has no
    Python. One thread calls `drive` and `forget`, any thread the others; they share queues, and a table that is
    exchanged as a whole.

    Args:
        participant: The participant of the viewer.
        node: Its node, which was added to the participant.
        now_ns: Returns the time of stamps [ns since epoch]; any thread may call it.
    """

    def __init__(self, participant: Participant, node: NodeName, now_ns: Callable[[], int]) -> None:
        self._participant = participant
        self._node = node
        self._now_ns = now_ns
        self._commands: queue.SimpleQueue[Wish | str | None] = queue.SimpleQueue()
        self._types: dict[str, str] = {}
        """The type of each topic of `topics`."""
        self.on_refusal: Callable[[str, str], None] = lambda *_: None
        """Called with a page (or an empty text) and the reason why it can't drive, on another thread."""
        self._clocks: dict[str, _PageClock] = {}
        """By page; of the thread that calls `drive` and `forget`."""
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None
        """The driver, or what passes commands to it; started under `_lock`."""
        self._process: _Process | None = None
        self._is_closed = False
        # As of now, because a program may change its environment.
        self._environment = {**os.environ, "RMW_IMPLEMENTATION": implementation_identifier()}

    def open(self) -> None:
        """Start the driver, if none runs: the robot's subscriptions are found before a page drives.

        Raises:
            PageError: the system has no thread left.
        """
        with self._lock:
            if self._is_closed or (self._thread is not None and self._thread.is_alive()):
                return
            is_here = isinstance(self._participant, LocalParticipant) or getattr(sys, "frozen", False)
            thread = threading.Thread(
                target=self._drive_here if is_here else self._drive_there,
                name="tfloom_view_driving",
                daemon=True,
            )
            try:
                thread.start()
            except RuntimeError as error:
                raise PageError(f"driving needs a thread: {error}") from None
            self._thread = thread

    def topics(self) -> list[str]:
        """Return the topics of velocities that somebody subscribes to; from then on, pages drive on these."""
        types: dict[str, str] = {}
        for end in self._participant.graph.endpoints():
            # Where both types are subscribed to, the one without a stamp, which is the first of the two.
            name = end.topic.name
            if not end.is_writer and end.topic.type_name in TWIST_TYPES:
                types[name] = min(end.topic.type_name, types.get(name, end.topic.type_name))
        self._types = types
        return sorted(types)

    def drive(
        self, page: str, topic: str, ahead: float, left: float, said: tuple[float, float] | None = None
    ) -> None:
        """Publish a velocity, for at most `SILENCE_S` since the page has said so; on the thread of `forget`.

        Args:
            page: The page that wants it.
            topic: One of `topics`.
            ahead: From -1 to 1, of `LINEAR_M_S`.
            left: From -1 to 1, of `ANGULAR_RAD_S`.
            said: When the page has said so: the number of its clock, and the time on it [s]; None: now.

        Raises:
            PageError: nobody subscribes to the topic, or the system has no thread left.
        """
        self.open()
        if self._is_closed:
            raise PageError("the viewer has ended")
        if (type_name := self._types.get(topic)) is None:
            raise PageError(f"nobody subscribes to velocities on {topic!r}")
        if self._commands.qsize() < MAX_WAITING:
            linear = LINEAR_M_S * min(max(ahead, -1.0), 1.0)
            angular = ANGULAR_RAD_S * min(max(left, -1.0), 1.0)
            delay_s = 0.0 if said is None else self._clocks.setdefault(page, _PageClock()).delay_s(*said)
            told_s = time.monotonic() - delay_s
            self._commands.put(Wish(page, topic, type_name, linear, angular, told_s, self._now_ns()))

    def forget(self, page: str) -> None:
        """Stop what a page drives, because it was closed."""
        self._clocks.pop(page, None)
        self._commands.put(page)

    def close(self) -> None:
        """Stop what is driven, and end the driver. Closing again does nothing."""
        with self._lock:
            self._is_closed = True
        self._commands.put(None)
        if self._thread is None:
            return
        self._thread.join(MAX_END_S + 1.0)
        if self._process is not None and self._process.is_started_to_stop:
            self._thread.join(MAX_START_S)
        if self._thread.is_alive() and self._process is not None:
            self._process.kill()  # a driver that takes no commands

    def _drive_here(self) -> None:
        try:
            run_driver(Driver(self._participant, self._node, self._tell_refusal), self._commands)
        except Exception as error:  # it has stopped what it drove
            self._tell_refusal("", f"driving has ended, until a page is opened: {fault_text(error)}")

    def _drive_there(self) -> None:
        """Pass commands to the process, which is started again where it has ended."""
        arguments = [str(self._participant.domain_id), f"{self._node.name}_drive"]
        process = self._process = _Process(
            arguments, self._environment, self._tell_refusal, lambda: self._commands.put("")
        )
        try:
            process.start()
            while True:
                try:
                    command = self._commands.get(timeout=process.wait_s())
                except queue.Empty:
                    command = ""  # nobody's end
                if command is None:
                    return
                process.send(command)
        finally:
            process.close()

    def _tell_refusal(self, page: str, reason: str) -> None:
        self.on_refusal(page, reason)


class _PageClock:
    """How late words of a page arrive, by what its clock said then: nothing is known of that clock but how it runs."""

    def __init__(self) -> None:
        self._number = math.nan
        self._least_s = math.inf
        """The least difference of our clock from the page's so far: that of a word that didn't wait [s]."""
        self._last_s = 0.0

    def delay_s(self, number: float, at_s: float) -> float:
        """Return how much later a word has come than the quickest one [s].

        Args:
            number: Another one than before is another clock.
            at_s: When the page has said it [s].
        """
        now_s = time.monotonic()
        difference_s = now_s - at_s
        if number == self._number:
            self._least_s += MAX_DRIFT * (now_s - self._last_s)
        else:
            self._least_s = math.inf
        self._number, self._last_s = number, now_s
        self._least_s = min(difference_s, self._least_s)
        return difference_s - self._least_s


class _Process:
    """The process of a driver. One thread may use it.

    Args:
        arguments: Those of its `main`.
        environment: Its environment variables.
        refuse: Called with a page and the reason why its wish is not done; on another thread.
        wake: Called when the process has ended; on another thread.
    """

    def __init__(
        self,
        arguments: list[str],
        environment: dict[str, str],
        refuse: Callable[[str, str], None],
        wake: Callable[[], None],
    ) -> None:
        self._command = [sys.executable, "-c", PROGRAM, *arguments]
        self._environment = environment
        self._refuse = refuse
        self._wake = wake
        self._process: subprocess.Popen[bytes] | None = None
        self._next_start_s = 0.0
        self.is_started_to_stop = False
        """Whether `close` has started the process, because the one before was killed."""
        self._driven: dict[tuple[str, str], Wish] = {}
        """By page and topic: the wishes of late that moved a robot, which the next process stops if this one is killed,
        also those that this one was told to end: it may not have done that."""

    def start(self) -> None:
        """Start the process. A page hears why that can't be done."""
        self._next_start_s = time.monotonic() + RESTART_S
        self._close_pipes()
        self._process = None
        try:
            # In a separate session, because a robot has to be stopped also after Ctrl-C or Ctrl-Z on the terminal.
            self._process = subprocess.Popen(
                self._command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env=self._environment,
                start_new_session=True,
            )
            threading.Thread(
                target=self._read, args=(self._process,), name="tfloom_view_driving_words", daemon=True
            ).start()
        except (OSError, RuntimeError) as error:
            if self._process is not None:
                self._process.communicate()  # which closes its stdin
                self._process = None
            reason = error.strerror if isinstance(error, OSError) else None
            self._refuse(
                "", f"driving needs a process and a thread, which can't be started: {reason or error}"
            )

    def wait_s(self) -> float | None:
        """Return how long nothing is to be done without a command [s]; None: always."""
        if not self._driven:
            return None
        if self._is_running():
            return MAX_LEFT_S
        return max(0.0, self._next_start_s - time.monotonic())

    def send(self, command: Wish | str) -> None:
        """Let the process do a command: a wish, or the end of a page."""
        since_s = time.monotonic() - (MAX_LEFT_S if self._is_running() else MAX_TRY_S)
        self._driven = {key: wish for key, wish in self._driven.items() if wish.told_s > since_s}
        if isinstance(command, Wish) and command.moves:
            self._driven[command.page, command.topic] = command
        if not self._is_running():
            self._replace()
        self._write(command)

    def _is_running(self) -> bool:
        return self._process is not None and self._process.poll() is None

    def _replace(self) -> None:
        """Start another process after one that has ended, and let it stop what that one has left."""
        if not self._driven or time.monotonic() < self._next_start_s:
            return
        self.start()
        # Where it can't be started, that is tried again: until then nothing else stops the robots. What stays in
        # `_driven` is stopped by yet another process, if this one is killed before it has done so.
        for wish in self._driven.values():
            self._write(wish.stopped())
            self._write(wish.page)  # which may be closed; if not, it says how it wants to go on

    def _write(self, command: Wish | str) -> None:
        if self._process is not None and self._process.stdin is not None:
            with suppress(OSError, ValueError):  # it has ended
                self._process.stdin.write(json.dumps(command).encode() + b"\n")
                self._process.stdin.flush()

    def _read(self, process: subprocess.Popen[bytes]) -> None:
        """Pass on what the process says, until it has ended."""
        try:
            with cast("IO[bytes]", process.stdout) as lines:  # it is a pipe
                for line in lines:
                    try:
                        page, reason = json.loads(line)
                    except (ValueError, TypeError):
                        continue  # a library of the process has written it, such as Cyclone DDS's trace
                    self._refuse(page, reason)
        finally:  # or nobody would stop what a process drives that is killed
            process.wait()
            self._wake()

    def _close_pipes(self) -> None:
        if self._process is not None and self._process.stdin is not None:
            with suppress(OSError):  # what was not written is of no use any more
                self._process.stdin.close()

    def close(self) -> None:
        """Let the process stop everything and end; if it was killed, another one does that."""
        self._end(MAX_END_S)
        if self._driven and (self._process is None or self._process.returncode < 0):
            self._next_start_s, self.is_started_to_stop = 0.0, True
            self._replace()
            self._end(MAX_START_S + MAX_END_S)

    def _end(self, limit_s: float) -> None:
        self._close_pipes()
        if self._process is not None:
            try:
                self._process.wait(limit_s)
            except subprocess.TimeoutExpired:
                self.kill()

    def kill(self) -> None:
        """End a process that takes no commands; any thread may call it."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
