"""Event handlers, by the events that they handle."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, ClassVar, cast

from tfloom.launch.core.base_classes import (
    LaunchDescriptionEntity,
    SomeEntitiesType,
    normalize_to_list_of_entities,
)
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action, ExecutionComplete
from tfloom.launch.entities.event_handler import BaseEventHandler
from tfloom.launch.events.launch_events import IncludeLaunchDescription, Shutdown
from tfloom.launch.events.process import ProcessExited, ProcessIO, ProcessStarted

__all__ = [
    "OnActionEventBase",
    "OnExecutionComplete",
    "OnIncludeLaunchDescription",
    "OnProcessExit",
    "OnProcessIO",
    "OnProcessStart",
    "OnShutdown",
    "event_named",
]


def event_named(name: str) -> Callable[[Event], bool]:
    """Return a matcher of the events that have a name."""
    return lambda event: event.name == name


class OnActionEventBase(BaseEventHandler):
    """Handles the events of a kind that belong to an action.

    Args:
        action_matcher: The action, or a function that returns whether an action is meant; None: any action.
        on_event: The entities to visit, or a function that takes the event and the context and returns them.
        target_event_cls: The kind of events.
        target_action_cls: The kind of actions that have such events.
        kwargs: As for BaseEventHandler.

    Raises:
        TypeError: `action_matcher` or `on_event` is of another type.
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
        self._target = self._target_name or target_action_cls.__name__
        # By `__class__`, which a mock of an action has from the class that it stands for.
        classes = action_matcher.__class__.__mro__
        if not (
            action_matcher is None
            or callable(action_matcher)
            or self._target in (cls.__name__ for cls in classes)
        ):
            raise TypeError(f"action_matcher must be an '{self._target}' instance or a callable")
        self._action_matcher = action_matcher
        self._target_event_cls = target_event_cls
        self._on_event = on_event
        self._actions: list[LaunchDescriptionEntity] | None = None
        if not callable(on_event):
            if not isinstance(on_event, Iterable) and not hasattr(on_event, "visit"):
                # In here, not by the function below, so that the traceback is short.
                raise TypeError(
                    "expected all items in 'on_event' iterable to be of type 'LaunchDescriptionEntity' "
                    f"but got '{type(on_event)}': give actions, or a function that returns them, not {on_event!r}"
                )
            self._actions = normalize_to_list_of_entities([on_event], name="on_event")
        super().__init__(matcher=self._is_target_event, **kwargs)

    def _is_target_event(self, event: Any) -> bool:
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


class OnExecutionComplete(OnActionEventBase):
    """Visits entities at the end of an action.

    Args:
        target_action: The action, or a function that returns whether an action is meant; None: any.
        on_completion: The entities, or a function that takes the event and the context and returns them.
        kwargs: As for BaseEventHandler.
    """

    def __init__(
        self,
        *,
        target_action: Action | Callable[[Any], bool] | None = None,
        on_completion: SomeEntitiesType
        | Callable[[ExecutionComplete, LaunchContext], SomeEntitiesType | None],
        **kwargs: Any,
    ) -> None:
        super().__init__(
            action_matcher=target_action,
            on_event=on_completion,
            target_event_cls=ExecutionComplete,
            target_action_cls=Action,
            **kwargs,
        )


class OnIncludeLaunchDescription(BaseEventHandler):
    """Visits the description of an IncludeLaunchDescription event. The launch service has one.

    Args:
        kwargs: As for BaseEventHandler.
    """

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, IncludeLaunchDescription), **kwargs)

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the description."""
        super().handle(event, context)
        return cast("IncludeLaunchDescription", event).launch_description

    @property
    def handler_description(self) -> str:
        """What it does, for people."""
        return "returns the launch_description in the event"

    @property
    def matcher_description(self) -> str:
        """Which events it handles, for people."""
        return "event issubclass of launch.events.IncludeLaunchDescription"


class OnProcessExit(OnActionEventBase):
    """Visits entities at the end of a process.

    Args:
        target_action: The action, or a function that returns whether an action is meant; None: any.
        on_exit: The entities, or a function that takes the event and the context and returns them.
        kwargs: As for BaseEventHandler.
    """

    _target_name = "ExecuteLocal"

    def __init__(
        self,
        *,
        target_action: Action | Callable[[Any], bool] | None = None,
        on_exit: SomeEntitiesType | Callable[[ProcessExited, LaunchContext], SomeEntitiesType | None],
        **kwargs: Any,
    ) -> None:
        super().__init__(
            action_matcher=target_action,
            on_event=on_exit,
            target_event_cls=ProcessExited,
            target_action_cls=Action,
            **kwargs,
        )


Reaction = Callable[[ProcessIO], Any]


class OnProcessIO(OnActionEventBase):
    """Calls functions with what a process reads and writes.

    Args:
        target_action: The action, or a function that returns whether an action is meant; None: any.
        on_stdin: Takes the event, and returns entities to visit or None; None: nothing is done.
        on_stdout: The same for stdout.
        on_stderr: The same for stderr.
        kwargs: As for BaseEventHandler.
    """

    _target_name = "ExecuteLocal"

    def __init__(
        self,
        *,
        target_action: Action | Callable[[Any], bool] | None = None,
        on_stdin: Reaction | None = None,
        on_stdout: Reaction | None = None,
        on_stderr: Reaction | None = None,
        **kwargs: Any,
    ) -> None:
        self._on_stdin = on_stdin
        self._on_stdout = on_stdout
        self._on_stderr = on_stderr
        super().__init__(
            action_matcher=target_action,
            on_event=self._react,
            target_event_cls=ProcessIO,
            target_action_cls=Action,
            **kwargs,
        )

    def _react(self, event: ProcessIO, _: LaunchContext) -> SomeEntitiesType | None:
        reaction = (
            self._on_stdout if event.from_stdout else self._on_stderr if event.from_stderr else self._on_stdin
        )
        return None if reaction is None else reaction(event)

    @property
    def handler_description(self) -> str:
        """What it does, for people."""
        named = {"on_stdin": self._on_stdin, "on_stdout": self._on_stdout, "on_stderr": self._on_stderr}
        return " ".join(f"{name}: '{reaction}'" for name, reaction in named.items() if reaction is not None)


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


class OnShutdown(BaseEventHandler):
    """Visits entities when the launch shuts down.

    Args:
        on_shutdown: The entities, or a function that takes the event and the context and returns them.
        kwargs: As for BaseEventHandler.

    Raises:
        TypeError: `on_shutdown` is of another type.
    """

    def __init__(
        self,
        *,
        on_shutdown: SomeEntitiesType | Callable[[Shutdown, LaunchContext], SomeEntitiesType | None],
        **kwargs: Any,
    ) -> None:
        super().__init__(matcher=lambda event: isinstance(event, Shutdown), **kwargs)
        if not callable(on_shutdown):
            normalize_to_list_of_entities([on_shutdown], name="on_shutdown")
        self._on_shutdown = on_shutdown

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities to visit."""
        super().handle(event, context)
        if callable(self._on_shutdown):
            return self._on_shutdown(event, context)  # type: ignore[arg-type]  # the matcher has checked it
        return self._on_shutdown

    @property
    def handler_description(self) -> str:
        """What it does, for people."""
        return "<actions>" if not callable(self._on_shutdown) else f"{self._on_shutdown}"

    @property
    def matcher_description(self) -> str:
        """Which events it handles, for people."""
        return "event is Shutdown"

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description for people, and the entities to visit, as far as they are known."""
        entities = [] if callable(self._on_shutdown) else [self._on_shutdown]
        return super().describe()[0], list(normalize_to_list_of_entities(entities))
