"""Processes that a test has marked by an environment variable, as Linux lists them."""

from __future__ import annotations

import os
import signal
from pathlib import Path

from tests.conftest import wait_until


def read(path: Path) -> bytes:
    """Return the content of a file under /proc; empty if its process has ended."""
    try:
        return path.read_bytes()
    except OSError:
        return b""


def alive(mark: str) -> dict[int, str]:
    """Return the commands of the marked processes, by process id."""
    return {
        int(folder.name): read(folder / "cmdline").replace(b"\0", b" ").decode()
        for folder in Path("/proc").glob("[0-9]*")
        if mark.encode() in read(folder / "environ")
    }


def kill_when_there(part: str, mark: str) -> None:
    """Kill the marked process with this part in its command, as soon as it runs."""

    def found() -> list[int]:
        return [process for process, command in alive(mark).items() if part in command]

    wait_until(found, what=part)
    (process,) = found()
    os.kill(process, signal.SIGKILL)
