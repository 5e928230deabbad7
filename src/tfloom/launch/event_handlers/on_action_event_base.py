"""The base class of the handlers of events that belong to an action."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, ClassVar

from tfloom.launch.action import Action
from tfloom.launch.event import Event
from tfloom.launch.event_handler import BaseEventHandler
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.some_entities_type import SomeEntitiesType
from tfloom.launch.utilities.normalize_to_list_of_entities import normalize_to_list_of_entities

__all__ = ["OnActionEventBase"]


class OnActionEventBase(BaseEventHandler):
    """Handles the events of a kind that belong to an action.

    Args:
        action_matcher: The action, or a function that returns whether an action is meant; None: any action.
        on_event: The entities to visit, or a function that takes the event and the context and returns them.
        target_event_cls: The kind of events.
        target_action_cls: The kind of actions that have such events.
        kwargs: As for BaseEventHandler.

    Raises:
        RuntimeError: `action_matcher` or `on_event` is of another type.
    """

    _target_name: ClassVar[str | None] = None
    """Name of a class in a higher file, which is the kind of actions in place of `target_action_cls`."""

    def __init__(
        self,
        *,
        action_matcher: Action | Callable[[Any], bool] | None,
        on_event: SomeEntitiesType | Callable[[Any, LaunchContext], SomeEntitiesType | None],
        target_event_cls: type[Event],
        target_action_cls: type[Action],
        **kwargs: Any,
    ) -> None:
        name = type(self).__name__
        self._target = self._target_name or target_action_cls.__name__
        if not (
            action_matcher is None
            or self._target in (cls.__name__ for cls in type(action_matcher).__mro__)
            or callable(action_matcher)
        ):
            raise RuntimeError(
                f"{name} requires a '{self._target}' action as the target, a function that matches "
                f"one, or None, and not '{action_matcher!r}'"
            )
        if not (callable(on_event) or isinstance(on_event, (LaunchDescriptionEntity, Iterable))):
            raise RuntimeError(  # noqa: TRY004  # programs catch this one
                f"{name} requires a function or launch description entities for its event, and not '{on_event!r}'"
            )
        self._action_matcher = action_matcher
        self._target_event_cls = target_event_cls
        self._on_event = on_event
        self._actions: list[LaunchDescriptionEntity] | None = None
        if not callable(on_event):
            self._actions = normalize_to_list_of_entities([on_event])
        super().__init__(matcher=self._is_meant, **kwargs)

    def _is_meant(self, event: Any) -> bool:
        if not isinstance(event, self._target_event_cls):
            return False
        matcher = self._action_matcher
        if matcher is None:
            return True
        action = event.action  # type: ignore[attr-defined]  # all such events have it
        return action is matcher if isinstance(matcher, Action) else matcher(action)

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities to visit."""
        super().handle(event, context)
        if self._actions is not None:
            return self._actions
        return self._on_event(event, context)  # type: ignore[operator]  # callable otherwise

    @property
    def handler_description(self) -> str:
        """What it does, for people."""
        return "<actions>" if self._actions is not None else f"{self._on_event}"

    @property
    def matcher_description(self) -> str:
        """Which events it handles, for people."""
        kind = self._target_event_cls.__name__
        if self._action_matcher is None:
            return f"event == {kind}"
        if isinstance(self._action_matcher, Action):
            return f"event == {kind} and {self._target}(event.action)"
        return f"event == {kind} and {self._action_matcher}(event.action)"

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description for people, and the entities to visit, as far as they are known."""
        return super().describe()[0], list(self._actions or [])
