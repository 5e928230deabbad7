"""Begin a scope of launch configurations."""

from __future__ import annotations

from tfloom.launch.action import Action
from tfloom.launch.launch_context import LaunchContext

__all__ = ["PushLaunchConfigurations"]


class PushLaunchConfigurations(Action):
    """Begins a scope: what is set from now on is undone by the next `PopLaunchConfigurations`."""

    def execute(self, context: LaunchContext) -> None:
        """Save a copy of the configurations."""
        context._push_launch_configurations()  # noqa: SLF001  # of this room
