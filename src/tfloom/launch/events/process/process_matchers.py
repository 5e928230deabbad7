"""Matchers of processes, for the events that do something to some of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

__all__ = ["matches_executable", "matches_name", "matches_pid"]

ProcessMatcher = Callable[[Any], bool]


def matches_pid(pid: int) -> ProcessMatcher:
    """Return a function that returns whether an action's process has a process id."""
    return lambda action: bool(action.process_details) and action.process_details["pid"] == pid


def matches_name(name: str) -> ProcessMatcher:
    """Return a function that returns whether an action's process has a name, with or without its number."""

    def matches(action: Any) -> bool:
        final_name = str((action.process_details or {}).get("name") or action.process_description.final_name)
        head, _, number = final_name.rpartition("-")
        return name == final_name or (number.isdigit() and name == head)

    return matches


def matches_executable(executable: str) -> ProcessMatcher:
    """Return a function that returns whether an action's process runs a program, by its path or its file name."""

    def matches(action: Any) -> bool:
        cmd = (action.process_details or {}).get("cmd") or action.process_description.final_cmd
        return bool(cmd) and executable in (cmd[0], cmd[0].rpartition("/")[2])

    return matches
