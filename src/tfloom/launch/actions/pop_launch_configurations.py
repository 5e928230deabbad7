"""End a scope of launch configurations."""

from __future__ import annotations

from tfloom.launch.action import Action
from tfloom.launch.launch_context import LaunchContext

__all__ = ["PopLaunchConfigurations"]


class PopLaunchConfigurations(Action):
    """Ends a scope: restores the launch configurations of the last `PushLaunchConfigurations`."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the configurations."""
        context._pop_launch_configurations()  # noqa: SLF001  # of this room
