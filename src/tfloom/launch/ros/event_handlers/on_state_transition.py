"""The handler of transitions of lifecycle nodes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_description_entity import SomeEntitiesType
from tfloom.launch.core.substitution import SomeSubstitutionsType
from tfloom.launch.entities.event_handler import EventHandler
from tfloom.launch.ros.actions.lifecycle_node import LifecycleNode
from tfloom.launch.ros.events.lifecycle_events import StateTransition

__all__ = ["OnStateTransition"]


class OnStateTransition(EventHandler):
    """Visits entities after a transition of a lifecycle node; what is None isn't compared.

    Args:
        entities: The entities.
        target_lifecycle_node: The node.
        transition: Name of the transition.
        start_state: Name of the state before.
        goal_state: Name of the state after.
        matcher: Called with the event, for a condition of one's own.
        kwargs: As for EventHandler.

    Raises:
        RuntimeError: the target is not a LifecycleNode.
    """

    def __init__(
        self,
        *,
        entities: SomeEntitiesType,
        target_lifecycle_node: LifecycleNode | None = None,
        transition: SomeSubstitutionsType | None = None,
        start_state: SomeSubstitutionsType | None = None,
        goal_state: SomeSubstitutionsType | None = None,
        matcher: Callable[[Event], bool] | None = None,
        **kwargs: Any,
    ) -> None:
        if not isinstance(target_lifecycle_node, (LifecycleNode, type(None))):
            raise RuntimeError("OnStateTransition requires a 'LifecycleNode' action as the target")
        self._target = target_lifecycle_node
        self._labels = {"transition": transition, "start_state": start_state, "goal_state": goal_state}
        self._custom_matcher = matcher
        super().__init__(matcher=self._accepts, entities=entities, **kwargs)

    def _accepts(self, event: Event) -> bool:
        return (
            isinstance(event, StateTransition)
            and (self._target is None or event.action is self._target)
            and all(label is None or getattr(event, name) == label for name, label in self._labels.items())
            and (self._custom_matcher is None or self._custom_matcher(event))
        )

    @property
    def handler_description(self) -> str:
        """What it does, for people."""
        return "<actions>"

    @property
    def matcher_description(self) -> str:
        """Which events it handles, for people."""
        named = {**self._labels, "target_lifecycle_node": self._target}
        conditions = [f"{name}={value!r}" for name, value in named.items() if value is not None]
        return " and ".join(["event == StateTransition", *conditions])
