"""Restore the environment variables of the launch's start."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext

__all__ = ["ResetEnvironment"]


@expose_action("reset_env")
class ResetEnvironment(Action):
    """Restores, when it is executed, the environment variables that the context was created with."""

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[ResetEnvironment], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `reset_env`."""
        _, kwargs = super().parse(entity, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        """Restore them."""
        context._reset_environment()  # noqa: SLF001  # of this room
