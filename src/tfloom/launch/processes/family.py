"""All processes of a launch, with those that they have started, however deep.

Each inherits an environment variable that names its launch, also where it left its process group or lost its parent.
"""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path

import psutil

__all__ = ["TAG", "Groups", "Member", "end", "find", "members_of", "tagged", "untagged"]

Member = tuple[int, float]
"""A process as its id and its start, which differs from that of a later process with the same id."""
Groups = dict[int, set[Member] | None]
"""Ids of process groups, each with the members that it was last seen to have; None while its first process runs.

The system gives the id of a group that has no member left to another group. Because a process can only join a group
that has members, a group is the same one for as long as a member that it was seen to have is left.
"""

TAG = "TFLOOM_LAUNCH"
"""Environment variable with the ids of the launch and of the launches that it runs in, separated by colons."""

POLL_S = 0.02
LOOK_S = 0.2
"""Time between two looks at all processes of the machine while none of the known ones ends [s]: each takes some ms."""
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


def members_of(group: int) -> set[Member]:
    """Return the processes of a group, also those that have ended and that nobody has waited for."""
    if sys.platform == "win32":
        return set()
    try:
        os.killpg(group, 0)  # which takes less time than to look at all processes
    except ProcessLookupError:
        return set()
    except PermissionError:  # it is there, with processes of another user
        pass
    return _members({group}).get(group, set())


def _members(groups: set[int]) -> dict[int, set[Member]]:
    """Return the members of groups that have any."""
    # One walk over all processes for all groups: the system has no list of a group's members.
    members_by_group: dict[int, set[Member]] = {}
    if sys.platform != "win32":
        for pid in psutil.pids() if groups else []:
            with suppress(psutil.Error, OSError):  # it has ended
                group = os.getpgid(pid)
                if group in groups:
                    members_by_group.setdefault(group, set()).add((pid, _start_of(pid)))
    return members_by_group


def _start_of(pid: int) -> float:
    """Return when a process started: on Linux in clock ticks since the boot, which no change of the clock moves."""
    if sys.platform == "linux":
        # The name of the program, in parentheses, may hold spaces.
        return float(Path(f"/proc/{pid}/stat").read_bytes().rpartition(b")")[2].split()[19])
    return float(psutil.Process(pid).create_time())


def find(launch_id: str, groups: Groups | None = None, since_s: float = 0.0) -> list[psutil.Process]:
    """Return the processes of a launch that are alive, but for the calling one.

    Args:
        launch_id: The launch's id.
        groups: Process groups; their members that changed their environment are found, too. Those that the launch no
            longer has are removed, and those members of the others noted that they are now seen to have.
        since_s: Time before which no member was started [s since epoch], in case that an id was used again.
    """
    groups = {} if groups is None else groups
    # First the groups: is each still the launch's? While its first process runs, the id can't be given to another
    # group (None). Later one of the members that were noted must be there; the ones that it has started meanwhile are
    # then noted with it, because it may end before the next look.
    members_by_group = _members(set(groups))
    for group, noted_members in list(groups.items()):
        members = members_by_group.get(group, set())
        if members and (noted_members is None or noted_members & members):
            groups[group] = members
        else:
            del groups[group]
    own_pid = os.getpid()
    found = (_find_one(pid, launch_id, groups, since_s) for pid in psutil.pids() if pid != own_pid)
    return [process for process in found if process is not None]


def _find_one(pid: int, launch_id: str, groups: Groups, since_s: float) -> psutil.Process | None:
    """Return the process of this id if it is alive and one of the launch."""
    with suppress(psutil.Error, OSError):  # it has ended, or is another user's
        # The group first: a member may have emptied its environment. Outside the groups, only the environment tells.
        is_member = bool(groups) and hasattr(os, "getpgid") and os.getpgid(pid) in groups
        if not is_member and not _may_be_tagged(pid, launch_id):
            return None
        process = psutil.Process(pid)
        if is_member:
            belongs = process.create_time() >= since_s - 1.0  # which has the resolution of a clock tick
        else:
            belongs = launch_id in str(process.environ().get(TAG, "")).split(":")
        return process if belongs and _is_alive(process) else None
    return None


def _may_be_tagged(pid: int, launch_id: str) -> bool:
    """Return whether a process may have a launch's id in its environment, because most of the machine's have not.

    psutil takes several times as long: it makes a dictionary of the variables of each.
    """
    return sys.platform != "linux" or launch_id.encode() in Path(f"/proc/{pid}/environ").read_bytes()


def end(launch_id: str, groups: Groups, since_s: float, steps: Mapping[signal.Signals, float]) -> list[str]:
    """End the processes of a launch, until none is left; return those that were alive, as texts.

    Args:
        launch_id: The launch's id.
        groups: Its process groups, as for `find`.
        since_s: When it began [s since epoch].
        steps: Signals in the order in which they are sent, each with the time until the next one [s]; SIGKILL follows.
    """
    # A process that gets a signal may start others before it ends, and these inherit the launch's id. So each step
    # looks again and again, and ends early when nobody is left.
    alive = find(launch_id, groups, since_s)
    named = [_process_text(process) for process in alive]
    for number, wait_s in [*steps.items(), (KILL, KILL_S)]:
        stop = time.monotonic() + wait_s
        signalled: set[int] = set()
        while alive:
            for process in alive:
                # One that appears meanwhile is signalled, too; SIGKILL is repeated.
                if number == KILL or process.pid not in signalled:
                    signalled.add(process.pid)
                    _send_signal(process, number)
            if time.monotonic() > stop:
                break
            _wait_for_an_end(alive, min(stop, time.monotonic() + LOOK_S))
            alive = find(launch_id, groups, since_s)
    return named


def _wait_for_an_end(processes: Sequence[psutil.Process], until_s: float) -> None:
    """Wait until one of these processes has ended, or for a time."""
    time.sleep(POLL_S)
    while time.monotonic() < until_s and all(map(_is_alive, processes)):
        time.sleep(POLL_S)


def _is_alive(process: psutil.Process) -> bool:
    with suppress(psutil.Error, OSError):
        # A zombie has ended already. It stays until its parent waits for it, which no signal hastens.
        return bool(process.status() != psutil.STATUS_ZOMBIE)
    return False


def _send_signal(process: psutil.Process, number: signal.Signals) -> None:
    try:
        process.send_signal(number)
    except (psutil.Error, OSError, ValueError):  # the last, because Windows has no SIGINT for others
        return


def _process_text(process: psutil.Process) -> str:
    try:
        return f"{process.name()} [pid {process.pid}]"
    except psutil.Error:
        return f"[pid {process.pid}]"
