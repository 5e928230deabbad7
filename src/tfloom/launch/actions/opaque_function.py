"""The action that calls a function."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type

__all__ = ["OpaqueFunction"]


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
