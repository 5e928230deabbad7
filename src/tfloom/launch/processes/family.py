"""All processes of a launch, with those that they have started, however deep.

Each inherits an environment variable that names its launch, also where it left its process group or lost its parent.
"""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Collection, Mapping

import psutil

__all__ = ["TAG", "end", "find", "tagged", "untagged"]

TAG = "TFLOOM_LAUNCH"
"""Environment variable with the ids of the launch and of the launches that it runs in, separated by colons."""

POLL_S = 0.02
if sys.platform == "win32":
    KILL = signal.SIGTERM
else:
    KILL = signal.SIGKILL
"""The signal that ends a process whatever it does. Windows knows no other end, and calls that SIGTERM."""

KILL_S = 10.0
"""Time after which a process that SIGKILL did not end is given up: it is inside the kernel."""


def tagged(environment: Mapping[str, str], launch_id: str) -> dict[str, str]:
    """Return environment variables with a launch's id added."""
    outer = environment.get(TAG)
    return {**environment, TAG: f"{outer}:{launch_id}" if outer else launch_id}


def untagged(environment: Mapping[str, str]) -> dict[str, str]:
    """Return environment variables without the id of any launch."""
    return {name: value for name, value in environment.items() if name != TAG}


def find(launch_id: str, groups: Collection[int] = (), since_s: float = 0.0) -> list[psutil.Process]:
    """Return the processes of a launch that are alive, but for the calling one.

    Args:
        launch_id: The launch's id.
        groups: Ids of process groups; their members that changed their environment are found, too.
        since_s: Time before which no member was started [s since epoch], in case that an id was used again.
    """
    return [
        process
        for process in psutil.process_iter()
        if process.pid != os.getpid() and _is_of(process, launch_id, groups, since_s)
    ]


def _is_of(process: psutil.Process, launch_id: str, groups: Collection[int], since_s: float) -> bool:
    try:
        if process.status() == psutil.STATUS_ZOMBIE:
            return False
        if groups and hasattr(os, "getpgid") and os.getpgid(process.pid) in groups:
            return float(process.create_time()) >= since_s - 1.0  # which has the resolution of a clock tick
        return launch_id in str(process.environ().get(TAG, "")).split(":")
    except (psutil.Error, OSError):  # it has ended, or is another user's
        return False


def end(
    launch_id: str, groups: Collection[int], since_s: float, steps: Mapping[signal.Signals, float]
) -> list[str]:
    """End the processes of a launch, until none is left; return those that were alive, as texts.

    Args:
        launch_id: The launch's id.
        groups: Ids of its process groups.
        since_s: When it began [s since epoch].
        steps: Signals in the order in which they are sent, each with the time until the next one [s]; SIGKILL follows.
    """
    alive = find(launch_id, groups, since_s)
    named = [_described(process) for process in alive]
    for number, wait_s in [*steps.items(), (KILL, KILL_S)]:
        stop = time.monotonic() + wait_s
        signalled: set[int] = set()
        while alive:
            for process in alive:
                # One that appears meanwhile is signalled, too; SIGKILL is repeated.
                if number == KILL or process.pid not in signalled:
                    signalled.add(process.pid)
                    _send(process, number)
            if time.monotonic() > stop:
                break
            time.sleep(POLL_S)
            alive = find(launch_id, groups, since_s)
    return named


def _send(process: psutil.Process, number: signal.Signals) -> None:
    try:
        process.send_signal(number)
    except (psutil.Error, OSError, ValueError):  # the last, because Windows has no SIGINT for others
        return


def _described(process: psutil.Process) -> str:
    try:
        return f"{process.name()} [pid {process.pid}]"
    except psutil.Error:
        return f"[pid {process.pid}]"
