"""A child process that ends with this one, and to which signals are passed on."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Mapping, Sequence
from types import FrameType

GRACE_S = 1.0
"""Wait before a signal is passed on to a child that may have received it, too, as a member of the process group
[s]: longer than a node takes to leave the graph."""
PR_SET_PDEATHSIG = 1


def run_child(command: Sequence[str]) -> int:
    """Run a command to its end and return its exit code; -N if signal N ended it.

    A Ctrl-C at the terminal reaches the child directly. Any other SIGINT, SIGTERM or SIGHUP is passed on. If this
    process is killed, so is the child (Linux).

    Raises:
        CommandError: the command can't be started.
    """
    from tfloom.cli.shared.errors import CommandError

    passed_on = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
    waiting: list[threading.Timer] = []
    child: list[subprocess.Popen[bytes]] = []

    def pass_on(number: int, _: FrameType | None) -> None:
        # A Ctrl-C at the terminal goes to the whole foreground group, the child included: passing it on would make it
        # two. For any other signal it is unknown whether the child got it, too; so give it time to end by itself first.
        if child and not (number == signal.SIGINT and _terminal_signals_us()):
            timer = threading.Timer(GRACE_S, _send, (child[0], number))
            timer.daemon = True
            try:
                timer.start()
            except RuntimeError:  # no thread can be started: better twice than not at all
                _send(child[0], number)
            else:
                waiting.append(timer)

    # Install the handlers before the child starts: a signal in between would end this process and leave the child.
    old = {number: signal.signal(number, pass_on) for number in passed_on}
    try:
        child.append(subprocess.Popen(command, preexec_fn=_child_setup(old)))  # noqa: PLW1509
        return child[0].wait()
    except OSError as error:
        raise CommandError(f"can't run {command[0]}: {error.strerror}") from None
    finally:
        for timer in waiting:
            timer.cancel()
        for number, handler in old.items():
            signal.signal(number, handler)


def _send(child: subprocess.Popen[bytes], number: int) -> None:
    if child.poll() is None:
        child.send_signal(number)


def _terminal_signals_us() -> bool:
    """Return whether this is the terminal's foreground process group, so that a Ctrl-C reaches the child, too."""
    if sys.platform == "win32":
        return True
    try:
        terminal = os.open("/dev/tty", os.O_RDONLY | os.O_NOCTTY)
    except OSError:
        return False
    try:
        return os.tcgetpgrp(terminal) == os.getpgrp()
    except OSError:
        return False
    finally:
        os.close(terminal)


def _child_setup(handlers: Mapping[int, object]) -> Callable[[], None] | None:
    """Return the function that the child runs before it executes the program, or None without one."""
    if os.name != "posix":
        return None
    prctl = None
    if sys.platform == "linux":
        import ctypes

        prctl = ctypes.CDLL(None).prctl
    parent = os.getpid()

    def setup() -> None:
        # A handler becomes the default on exec; an ignored signal must stay ignored (nohup).
        for number, handler in handlers.items():
            if handler == signal.SIG_IGN:
                signal.signal(number, signal.SIG_IGN)
        if prctl is not None:
            prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
            if os.getppid() != parent:  # The parent was killed before it was set.
                os._exit(1)

    return setup
