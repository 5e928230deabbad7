"""The launch's side of its guardian, and the end of what its processes have left."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
import uuid
import weakref
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.processes.family import Groups, end, members_of, tagged, untagged

__all__ = ["Guard", "guard_of", "guardian_command"]

LEFTOVERS = {signal.SIGTERM: 1.0}
"""Time that processes have after the end of the process that started them [s], before SIGKILL."""


def guardian_command(launch_id: str, since_s: float) -> list[str]:
    """Return the command line of the guardian of a launch that began at a time [s since epoch].

    Each launch starts one, and few guardians have anything to do. So it begins without `site`, which finds the packages
    and takes a third of Python's start.
    """
    guardian = Path(__file__).with_name("guardian.py")
    return [sys.executable, "-S", str(guardian), launch_id, str(since_s)]


class Guard:
    """The processes of a launch, which are ended with it. Used on the launch's thread alone."""

    def __init__(self) -> None:
        self._launch_id = uuid.uuid4().hex
        self._since_s = time.time()
        self._groups: Groups = {}
        self._has_started = False
        self._folders: list[str] = []
        self._guardian: subprocess.Popen[bytes] | None = None

    def environment(self, environment: Mapping[str, str]) -> dict[str, str]:
        """Return the environment variables for a process that is started next. Before the first, start the guardian."""
        self._start_guardian()
        return tagged(environment, self._launch_id)

    def _start_guardian(self) -> None:
        # The guardian must outlive the launch. Its stdin is a pipe whose other end no other process inherits, so it
        # reads the end of the pipe when the launch has ended, also by SIGKILL. A separate session keeps Ctrl-C of the
        # terminal from it. Its environment names no launch, because an outer one ends all processes with its id.
        #
        # A frozen program has no Python that could run the guardian: its executable is the program itself.
        if self._guardian is not None or getattr(sys, "frozen", False):
            return
        self._guardian = subprocess.Popen(
            guardian_command(self._launch_id, self._since_s),
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            cwd=os.sep,
            env=untagged(os.environ),
            start_new_session=True,
        )
        # For a context that no service ever runs, whose guard nobody closes. Not at the end of Python: then the
        # guardian ends by itself, after what the launch has left.
        self._end_guardian = weakref.finalize(self, _end_at_once, self._guardian)
        self._end_guardian.atexit = False
        for folder in self._folders:  # of an earlier run of the same launch
            self._send_folder(folder)

    def add(self, pid: int) -> None:
        """Add the process group of a process that has started."""
        self._has_started = True
        self._groups[pid] = None
        self._send_line(str(pid))

    def ended(self, pid: int) -> None:
        """Note that a process that was added has ended: its group is kept only for those that it has left there."""
        # A process that is left in the group proves later that it is still the same one: see `Groups`.
        members = members_of(pid)
        if members:
            self._groups[pid] = members
        else:
            # The system may give its id to a group that isn't the launch's.
            self._groups.pop(pid, None)
        self._send_line(" ".join(["ended", str(pid), *(f"{member}:{start!r}" for member, start in members)]))

    def add_folder(self, folder: str) -> None:
        """Add a folder of temporary files, which is removed if the launch is killed.

        To be called before the folder is created: a launch may be killed at any time after that.
        """
        self._start_guardian()
        self._folders.append(folder)
        self._send_folder(folder)

    def _send_folder(self, folder: str) -> None:
        self._send_line(f"remove {folder.encode().hex()}")

    def _send_line(self, line: str) -> None:
        # Each line is flushed, because the launch may be killed after any of them, and its buffers are lost then.
        if self._guardian is not None and self._guardian.stdin is not None:
            with suppress(BrokenPipeError):  # a guardian that was killed
                self._guardian.stdin.write(f"{line}\n".encode())
                self._guardian.stdin.flush()

    def close(self) -> list[str]:
        """End what is left of the launch's processes, and the guardian; return those that were alive, as texts."""
        if self._guardian is None and not self._has_started:
            return []
        # The guardian goes last: if the launch is killed during `end`, it continues there. SIGKILL, because it ignores
        # the other signals, and before its stdin is closed, which it would take for the end of the launch.
        named = end(self._launch_id, self._groups, self._since_s, LEFTOVERS)
        self._groups.clear()
        self._has_started = False
        if self._guardian is not None:
            self._end_guardian()
            self._guardian = None
        return named


def _end_at_once(guardian: subprocess.Popen[bytes]) -> None:
    """End a guardian that has nothing left to do."""
    guardian.kill()
    guardian.communicate()


_guards: weakref.WeakKeyDictionary[LaunchContext, Guard] = weakref.WeakKeyDictionary()


def guard_of(context: LaunchContext) -> Guard:
    """Return the guard of a launch."""
    return _guards.setdefault(context, Guard())
