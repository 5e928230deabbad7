"""The process that holds a port of this machine, for messages about a router that doesn't answer or can't be opened."""

from __future__ import annotations

import os
import sys
from typing import NamedTuple

__all__ = ["PortOwner", "find_port_owner"]

_LISTENING = "0A"
_STOPPED = ("T", "t")


class PortOwner(NamedTuple):
    """A process that listens on a port."""

    pid: int
    command: str
    """Its command line, up to 80 letters."""
    is_stopped: bool
    """Whether it is stopped, as by Ctrl-Z or a debugger."""

    def __str__(self) -> str:
        state = ", which is stopped (Ctrl-Z, a debugger?)" if self.is_stopped else ""
        return f"process {self.pid} ({self.command}){state}"


def find_port_owner(port: int) -> PortOwner | None:
    """Return a process that listens on a TCP port; None where it isn't known: on other systems, of other users."""
    if sys.platform != "linux":
        return None
    sockets = {f"socket:[{inode}]" for inode in _listening_inodes(port)}
    if not sockets:
        return None
    for name in _names_in("/proc"):
        if name.isdigit() and any(
            _link(f"/proc/{name}/fd/{file}") in sockets for file in _names_in(f"/proc/{name}/fd")
        ):
            return PortOwner(int(name), _command(name), _state(name) in _STOPPED)
    return None


def _listening_inodes(port: int) -> set[str]:
    inodes = set()
    for table in ("tcp", "tcp6"):
        for line in _text(f"/proc/net/{table}").splitlines()[1:]:
            columns = line.split()
            if (
                len(columns) > 9
                and columns[3] == _LISTENING
                and int(columns[1].rpartition(":")[2], 16) == port
            ):
                inodes.add(columns[9])
    return inodes


def _command(pid: str) -> str:
    return " ".join(_text(f"/proc/{pid}/cmdline").replace("\0", " ").split())[:80] or "?"


def _state(pid: str) -> str:
    # The name of the process, in parentheses before the state, may hold spaces and parentheses.
    return _text(f"/proc/{pid}/stat").rpartition(")")[2].strip()[:1]


def _text(path: str) -> str:
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read()
    except OSError:
        return ""


def _names_in(folder: str) -> list[str]:
    try:
        return os.listdir(folder)
    except OSError:
        return []


def _link(path: str) -> str:
    try:
        return os.readlink(path)
    except OSError:
        return ""
