"""The base class of the events that report on a process."""

from __future__ import annotations

from collections.abc import Mapping

from tfloom.launch.action import Action
from tfloom.launch.event import Event

__all__ = ["RunningProcessEvent"]


class RunningProcessEvent(Event):
    """Something has happened to a process.

    Args:
        action: The action that started it, an ExecuteLocal.
        name: Its name, with its number.
        cmd: Its command line.
        cwd: The folder that it was started in; None: the launch's.
        env: Its environment variables; None: the launch's.
        pid: Its process id.
    """

    name = "launch.events.process.RunningProcessEvent"

    def __init__(
        self,
        *,
        action: Action,
        name: str,
        cmd: list[str],
        cwd: str | None,
        env: Mapping[str, str] | None,
        pid: int,
    ) -> None:
        self._action = action
        self._process_name = name
        self._cmd = cmd
        self._cwd = cwd
        self._env = env
        self._pid = pid

    @property
    def action(self) -> Action:
        """Action that started the process."""
        return self._action

    @property
    def execute_process_action(self) -> Action:
        """The action, by a former name."""
        return self._action

    @property
    def process_name(self) -> str:
        """Name of the process, with its number."""
        return self._process_name

    @property
    def cmd(self) -> list[str]:
        """Command line of the process."""
        return self._cmd

    @property
    def cwd(self) -> str | None:
        """Folder that the process was started in; None: the launch's."""
        return self._cwd

    @property
    def env(self) -> Mapping[str, str] | None:
        """Environment variables of the process; None: the launch's."""
        return self._env

    @property
    def pid(self) -> int:
        """Process id."""
        return self._pid
