"""Entities that follow the transitions of a lifecycle node."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from functools import wraps
from typing import Any

from tfloom.interfaces.lifecycle_msgs.msg import Transition

__all__ = ["ManagedEntity", "SimpleManagedEntity", "TransitionCallbackReturn"]


class TransitionCallbackReturn(IntEnum):
    """Result of a transition."""

    SUCCESS = Transition.TRANSITION_CALLBACK_SUCCESS
    FAILURE = Transition.TRANSITION_CALLBACK_FAILURE
    """Not done; the state is as before."""
    ERROR = Transition.TRANSITION_CALLBACK_ERROR
    """An error; `on_error` follows."""


class ManagedEntity:
    """Called at each transition with the state before it; by default, each succeeds."""

    def on_configure(self, state: Any) -> TransitionCallbackReturn:  # noqa: ARG002
        """Prepare."""
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state: Any) -> TransitionCallbackReturn:  # noqa: ARG002
        """Undo `on_configure`."""
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: Any) -> TransitionCallbackReturn:  # noqa: ARG002
        """End for good."""
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: Any) -> TransitionCallbackReturn:  # noqa: ARG002
        """Begin to work."""
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: Any) -> TransitionCallbackReturn:  # noqa: ARG002
        """Stop working."""
        return TransitionCallbackReturn.SUCCESS

    def on_error(self, state: Any) -> TransitionCallbackReturn:  # noqa: ARG002
        """Clean up after an error; SUCCESS leads back to the beginning, all else to the end."""
        return TransitionCallbackReturn.SUCCESS


class SimpleManagedEntity(ManagedEntity):
    """An entity that is active or not."""

    def __init__(self) -> None:
        self._enabled = False

    @property
    def is_activated(self) -> bool:
        """Whether it is active."""
        return self._enabled

    def on_activate(self, state: Any) -> TransitionCallbackReturn:  # noqa: ARG002
        """Begin to work."""
        self._enabled = True
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: Any) -> TransitionCallbackReturn:  # noqa: ARG002
        """Stop working."""
        self._enabled = False
        return TransitionCallbackReturn.SUCCESS

    @staticmethod
    def when_enabled(
        wrapped: Callable[..., Any] | None = None, *, when_not_enabled: Callable[..., Any] | None = None
    ) -> Any:
        """Decorate a method so that it runs while the entity is active; `when_not_enabled()` stands in else."""

        def decorate(method: Callable[..., Any]) -> Callable[..., Any]:
            @wraps(method)
            def only_when_enabled(self: SimpleManagedEntity, *args: Any, **kwargs: Any) -> Any:
                if self.is_activated:
                    return method(self, *args, **kwargs)
                return None if when_not_enabled is None else when_not_enabled()

            return only_when_enabled

        return decorate if wrapped is None else decorate(wrapped)
