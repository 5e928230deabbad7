"""Handler of the start of a process."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.event_handlers.on_action_event_base import OnActionEventBase
from tfloom.launch.events.process.process_started import ProcessStarted
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_entities_type import SomeEntitiesType

__all__ = ["OnProcessStart"]


class OnProcessStart(OnActionEventBase):
    """Visits entities at the start of a process.

    Args:
        target_action: The action, or a function that returns whether an action is meant; None: any.
        on_start: The entities, or a function that takes the event and the context and returns them.
        kwargs: As for BaseEventHandler.
    """

    _target_name = "ExecuteLocal"

    def __init__(
        self,
        *,
        target_action: Action | Callable[[Any], bool] | None = None,
        on_start: SomeEntitiesType | Callable[[ProcessStarted, LaunchContext], SomeEntitiesType | None],
        **kwargs: Any,
    ) -> None:
        super().__init__(
            action_matcher=target_action,
            on_event=on_start,
            target_event_cls=ProcessStarted,
            target_action_cls=Action,
            **kwargs,
        )
