"""Begin a scope of environment variables."""

from __future__ import annotations

from tfloom.launch.action import Action
from tfloom.launch.launch_context import LaunchContext

__all__ = ["PushEnvironment"]


class PushEnvironment(Action):
    """Begins a scope: what is set from now on is undone by the next `PopEnvironment`."""

    def execute(self, context: LaunchContext) -> None:
        """Save a copy of the variables."""
        context._push_environment()  # noqa: SLF001  # of this room
