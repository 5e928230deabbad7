"""Actions that call a function, or run a coroutine, of the launch file."""

from __future__ import annotations

from collections.abc import Callable, Coroutine, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from tfloom.launch.core.base_classes import LaunchDescriptionEntity
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import BaseEventHandler
from tfloom.launch.events.event_handlers import OnShutdown
from tfloom.launch.utilities.argument_types import ensure_argument_type

if TYPE_CHECKING:
    import asyncio

__all__ = ["OpaqueCoroutine", "OpaqueFunction"]


class OpaqueFunction(Action):
    """Calls a function while the launch runs.

    Args:
        function: Called with the context, `args` and `kwargs`; it may return entities to visit.
        args: More positional arguments.
        kwargs: Keyword arguments.
        left_over_kwargs: As for Action.
    """

    def __init__(
        self,
        *,
        function: Callable[..., list[LaunchDescriptionEntity] | None],
        args: Iterable[Any] | None = None,
        kwargs: Mapping[str, Any] | None = None,
        **left_over_kwargs: Any,
    ) -> None:
        super().__init__(**left_over_kwargs)
        if not callable(function):
            raise TypeError(
                f"OpaqueFunction expected a callable for 'function', got '{function}' of type '{type(function)}'"
            )
        ensure_argument_type(args, (Iterable, type(None)), "args", "OpaqueFunction")
        ensure_argument_type(kwargs, (dict, type(None)), "kwargs", "OpaqueFunction")
        self._function = function
        self._args = list(args or ())
        self._kwargs = dict(kwargs or {})

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Call the function, and return what it returns."""
        return self._function(context, *self._args, **self._kwargs)


class OpaqueCoroutine(Action):
    """Runs a coroutine beside the launch, which waits for its end.

    Args:
        coroutine: A coroutine function, called with the context, `args` and `kwargs`.
        args: More positional arguments.
        kwargs: Keyword arguments.
        ignore_context: Whether the context is left out.
        left_over_kwargs: As for Action.

    Raises:
        TypeError: `coroutine` is not a coroutine function.
    """

    def __init__(
        self,
        *,
        coroutine: Callable[..., Coroutine[Any, Any, None]],
        args: Iterable[Any] | None = None,
        kwargs: Mapping[str, Any] | None = None,
        ignore_context: bool = False,
        **left_over_kwargs: Any,
    ) -> None:
        super().__init__(**left_over_kwargs)
        import inspect  # which few launch files need

        if not inspect.iscoroutinefunction(coroutine):
            raise TypeError(
                "OpaqueCoroutine expected a coroutine function for 'coroutine', "
                f"got '{coroutine}' of type '{type(coroutine)}'"
            )
        ensure_argument_type(args, (Iterable, type(None)), "args", "OpaqueCoroutine")
        ensure_argument_type(kwargs, (dict, type(None)), "kwargs", "OpaqueCoroutine")
        ensure_argument_type(ignore_context, bool, "ignore_context", "OpaqueCoroutine")
        self._coroutine = coroutine
        self._args = list(args or ())
        self._kwargs = dict(kwargs or {})
        self._ignore_context = ignore_context
        self._future: asyncio.Task[None] | None = None

    def execute(self, context: LaunchContext) -> None:
        """Begin the coroutine. The launch's end cancels it."""
        args = self._args if self._ignore_context else [context, *self._args]
        loop = context.asyncio_loop
        if loop is None:
            raise RuntimeError("a coroutine can't be run: no LaunchService runs")
        task = loop.create_task(self._coroutine(*args, **self._kwargs))
        self._future = task
        on_shutdown: BaseEventHandler = OnShutdown(on_shutdown=lambda *_: _cancel(task))
        context.register_event_handler(on_shutdown)
        task.add_done_callback(lambda _: context.unregister_event_handler(on_shutdown))

    def get_asyncio_future(self) -> asyncio.Task[None] | None:
        """Return the coroutine's task."""
        return self._future


def _cancel(task: asyncio.Task[None]) -> None:
    task.cancel()
