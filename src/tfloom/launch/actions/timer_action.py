"""The action that waits, then executes others."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, cast

from tfloom.common.seconds import checked_timeout
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, SomeSubstitutionsType, described
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import BaseEventHandler
from tfloom.launch.events.event_handlers import OnShutdown
from tfloom.launch.events.launch_events import TimerEvent
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.utilities.argument_errors import entities_error
from tfloom.launch.utilities.type_utils import normalize_typed_substitution, perform_typed_substitution

if TYPE_CHECKING:
    import asyncio

__all__ = ["TimerAction"]


@expose_action("timer")
class TimerAction(Action):
    """Waits for a period, and executes actions then.

    Args:
        period: The time to wait [s].
        actions: The actions.
        cancel_on_shutdown: Whether the end of the launch ends the wait; else the launch waits for the actions.
        kwargs: As for Action.

    Raises:
        TypeError: `period` is neither a number nor a substitution.
        ValueError: it is NaN.
    """

    def __init__(
        self,
        *,
        period: float | SomeSubstitutionsType,
        actions: Iterable[LaunchDescriptionEntity],
        cancel_on_shutdown: bool | SomeSubstitutionsType = True,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self._period = normalize_typed_substitution(_as_substitution(period), float)
        if (error := entities_error("TimerAction", actions)) is not None:
            raise error
        self._actions = list(actions)
        self._cancel_on_shutdown = normalize_typed_substitution(cancel_on_shutdown, bool)
        self._completed_future: asyncio.Future[None] | None = None
        self._canceled = False
        self._canceled_future: asyncio.Future[bool] | None = None
        self._handlers: list[BaseEventHandler] = []
        self._variables: dict[str, Any] = {}
        self._logger = get_logger("launch.timer_action")

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and the arguments of its constructor."""
        _, kwargs = super().parse(entity, parser)
        kwargs["period"] = parser.parse_if_substitutions(
            entity.get_attr("period", data_type=float, can_be_str=True)
        )
        kwargs["actions"] = [parser.parse_action(child) for child in entity.children]
        return cls, kwargs

    @property
    def period(self) -> Any:
        """Time to wait [s]: a number, or a list of substitutions."""
        return self._period

    @property
    def actions(self) -> Sequence[LaunchDescriptionEntity]:
        """Actions that are executed then."""
        return self._actions

    def describe(self) -> str:
        """Return the class's name with the period."""
        return f"{type(self).__name__}(period={self._described_period()}, actions=<actions>)"

    def _described_period(self) -> str:
        return described(self._period) if isinstance(self._period, list) else str(self._period)

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return nothing, because the actions may never be executed: see `describe_conditional_sub_entities`."""
        return []

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return the actions, which are executed after the period unless the timer is canceled."""
        after = f"{self._described_period()} seconds pass without being canceled"
        return [*super().describe_conditional_sub_entities(), (after, self._actions)]

    def cancel(self) -> None:
        """End the wait, if it lasts, and execute nothing."""
        self._canceled = True
        if self._canceled_future is not None and not self._canceled_future.done():
            self._canceled_future.set_result(True)

    def reset(self) -> None:
        """Allow that the timer is executed again."""
        self._canceled = False
        self._canceled_future = None
        self._completed_future = None

    def handle(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Return the actions, with the timer as `context.locals.timer_action`; None if it was canceled.

        They have the variables of the timer's execution, such as the path of its launch file.
        """
        context.extend_locals({**self._variables, "timer_action": self})
        return None if self._canceled else self._actions

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Begin to wait.

        Raises:
            RuntimeError: no launch runs.
            ValueError: the period is not a number.
        """
        loop = context.asyncio_loop
        if loop is None:
            raise RuntimeError("a timer can't be started: no LaunchService runs")
        if self._canceled:
            return None
        # The variables of this moment, because those of an enclosing group or include are gone after the wait.
        self._variables = context.get_locals_as_dict()
        self._canceled_future = loop.create_future()
        self._completed_future = loop.create_future()
        self._handlers = [_OnTimer(self, self._complete)]
        if perform_typed_substitution(context, self._cancel_on_shutdown, bool):
            self._handlers.append(OnShutdown(on_shutdown=lambda *_: self.cancel()))
        for handler in self._handlers:
            context.register_event_handler(handler)
        self._task = loop.create_task(self._wait_to_fire_event(context))
        return None

    def get_asyncio_future(self) -> asyncio.Future[None] | None:
        """Return a future that is done when the wait has ended, and the actions have begun."""
        return self._completed_future

    async def _wait_to_fire_event(self, context: LaunchContext) -> None:
        import asyncio  # loaded with the first launch, and not for its arguments

        period_s = self._period_s(context)
        canceled = cast("asyncio.Future[bool]", self._canceled_future)
        await asyncio.wait([canceled], timeout=period_s)
        if canceled.done():
            self._complete(context)
        else:
            await context.emit_event(TimerEvent(timer_action=self))

    def _period_s(self, context: LaunchContext) -> float | None:
        """Return the period [s]; None if it never ends."""
        return checked_timeout("TimerAction", perform_typed_substitution(context, self._period, float))

    def _complete(self, context: LaunchContext) -> None:
        for handler in self._handlers:
            context.unregister_event_handler(handler)
        self._handlers.clear()
        if self._completed_future is not None and not self._completed_future.done():
            self._completed_future.set_result(None)


class _OnTimer(BaseEventHandler):
    """Handles the end of a timer's wait."""

    def __init__(self, timer: TimerAction, complete: Callable[[LaunchContext], None]) -> None:
        super().__init__(matcher=lambda event: isinstance(event, TimerEvent) and event.timer_action is timer)
        self._timer, self._complete = timer, complete

    def handle(self, event: Event, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        super().handle(event, context)
        # The launch looks for open futures after the visit of what is returned here. So it can't take itself for idle
        # between the end of the timer and the begin of its actions.
        self._complete(context)
        return self._timer.handle(context)


def _as_substitution(period: Any) -> Any:
    """Return numbers of all kinds, and texts of numbers, as floats."""
    if isinstance(period, str):
        return float(period)
    if not hasattr(period, "__float__") or isinstance(period, bool):
        return period
    period_s = checked_timeout("TimerAction", period)
    return math.inf if period_s is None else period_s
