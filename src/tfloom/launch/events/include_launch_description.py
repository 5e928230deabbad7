"""A description to launch."""

from __future__ import annotations

from tfloom.launch.core.event import Event
from tfloom.launch.entities.launch_description import LaunchDescription

__all__ = ["IncludeLaunchDescription"]


class IncludeLaunchDescription(Event):
    """Adds a description to the launch.

    Args:
        launch_description: The description.
    """

    name = "launch.events.IncludeLaunchDescription"

    def __init__(self, launch_description: LaunchDescription) -> None:
        self._launch_description = launch_description

    @property
    def launch_description(self) -> LaunchDescription:
        """Description that is added to the launch."""
        return self._launch_description
