"""End a scope of environment variables."""

from __future__ import annotations

from tfloom.launch.action import Action
from tfloom.launch.launch_context import LaunchContext

__all__ = ["PopEnvironment"]


class PopEnvironment(Action):
    """Ends a scope: restores the environment variables of the last `PushEnvironment`."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the variables."""
        context._pop_environment()  # noqa: SLF001  # of this room
