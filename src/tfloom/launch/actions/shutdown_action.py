"""The action that ends the launch."""

from __future__ import annotations

from typing import Any

from tfloom.launch.actions.event_actions import EmitEvent
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.events.process import ProcessExited
from tfloom.launch.events.shutdown import Shutdown as ShutdownEvent
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.logs.logging import get_logger

__all__ = ["Shutdown"]


@expose_action("shutdown")
class Shutdown(EmitEvent):
    """Ends the launch, and all its processes.

    Args:
        reason: Why, for people.
        kwargs: As for Action.
    """

    def __init__(self, *, reason: str = "reason not given", **kwargs: Any) -> None:
        super().__init__(event=ShutdownEvent(reason=reason), **kwargs)

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and the arguments of its constructor."""
        _, kwargs = super().parse(entity, parser)
        if (reason := entity.get_attr("reason", optional=True)) is not None:
            kwargs["reason"] = reason
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        """Emit the event, and log the process whose end was the reason, if one was."""
        event = context.get_locals_as_dict().get("event")
        if isinstance(event, ProcessExited):
            get_logger("launch").info(
                "process[%s] was required: shutting down launched system", event.process_name
            )
        super().execute(context)
