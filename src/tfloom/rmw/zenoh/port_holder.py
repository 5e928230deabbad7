"""Who holds a port of this machine: the process, for messages about a router; and this one's connections there."""

from __future__ import annotations

import os
import socket
import sys
from contextlib import suppress
from typing import NamedTuple

__all__ = ["PortOwner", "end_connections", "find_port_owner"]

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


def end_connections(port: int) -> int:
    """End the connections that this process has accepted at a TCP port; return their number. On Windows it can't."""
    return sum(_ends_connection(int(name), port) for name in _names_in("/dev/fd") if name.isdigit())


def _ends_connection(descriptor: int, port: int) -> bool:
    with suppress(OSError):  # it is closed by now, is not a socket, or has no peer
        copy = os.dup(descriptor)
        try:
            found = socket.socket(fileno=copy)
        except OSError:
            os.close(copy)
            return False
        with found:
            is_tcp = found.family in {socket.AF_INET, socket.AF_INET6} and found.type == socket.SOCK_STREAM
            if is_tcp and found.getsockname()[1] == port and found.getpeername():
                found.shutdown(socket.SHUT_RDWR)  # of the connection, whoever has other descriptors of it
                return True
    return False


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
