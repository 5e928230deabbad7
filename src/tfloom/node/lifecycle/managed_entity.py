"""Managed entities, which follow the transitions of a lifecycle node; among them its publishers."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from functools import wraps
from typing import Any

from tfloom.interfaces.lifecycle_msgs.msg import Transition
from tfloom.node.endpoints.publisher import MsgType, Publisher

__all__ = ["LifecyclePublisher", "ManagedEntity", "SimpleManagedEntity", "TransitionCallbackReturn"]


class TransitionCallbackReturn(IntEnum):
    """Result of a transition."""

    SUCCESS = Transition.TRANSITION_CALLBACK_SUCCESS
    FAILURE = Transition.TRANSITION_CALLBACK_FAILURE
    """The transition failed; the state is as before."""
    ERROR = Transition.TRANSITION_CALLBACK_ERROR
    """An error occurred; `on_error` is called."""

    def __str__(self) -> str:
        return f"TransitionCallbackReturnType.{self.name}"  # the name of rclpy's C half

    def __format__(self, form: str) -> str:
        return format(str(self) if not form else int(self), form)

    def __repr__(self) -> str:
        return f"<{self}: {self.value}>"

    def to_label(self) -> str:
        """Return the label of the transition that follows: `transition_success` and its like."""
        return f"transition_{self.name.lower()}"


class ManagedEntity:
    """Base of managed entities. Each transition calls a method with the state before it; by default, it succeeds."""

    def on_configure(self, state: Any) -> TransitionCallbackReturn:
        """Prepare what the node needs to be activated; derived classes do it."""
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state: Any) -> TransitionCallbackReturn:
        """Undo `on_configure`."""
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: Any) -> TransitionCallbackReturn:
        """Clean up before the finalized state."""
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: Any) -> TransitionCallbackReturn:
        """Start working, at the transition to active."""
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: Any) -> TransitionCallbackReturn:
        """Stop working, at the transition to inactive."""
        return TransitionCallbackReturn.SUCCESS

    def on_error(self, state: Any) -> TransitionCallbackReturn:
        """Clean up after an error; SUCCESS leads to unconfigured, any other result to finalized."""
        return TransitionCallbackReturn.SUCCESS


class SimpleManagedEntity(ManagedEntity):
    """An entity that is either active or inactive."""

    def __init__(self) -> None:
        self._enabled = False

    @property
    def is_activated(self) -> bool:
        """Whether it is active."""
        return self._enabled

    def on_activate(self, state: Any) -> TransitionCallbackReturn:
        """Start working, at the transition to active."""
        self._enabled = True
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: Any) -> TransitionCallbackReturn:
        """Stop working, at the transition to inactive."""
        self._enabled = False
        return TransitionCallbackReturn.SUCCESS

    @staticmethod
    def when_enabled(
        wrapped: Callable[..., Any] | None = None, *, when_not_enabled: Callable[..., Any] | None = None
    ) -> Any:
        """Decorate a method to run only while the entity is active; otherwise `when_not_enabled()` is called."""

        def decorate(method: Callable[..., Any]) -> Callable[..., Any]:
            @wraps(method)
            def only_when_enabled(self: SimpleManagedEntity, *args: Any, **kwargs: Any) -> Any:
                if self.is_activated:
                    return method(self, *args, **kwargs)
                return None if when_not_enabled is None else when_not_enabled()

            return only_when_enabled

        return decorate if wrapped is None else decorate(wrapped)


class LifecyclePublisher(SimpleManagedEntity, Publisher[MsgType]):
    """Publishes while its node is active, and drops messages otherwise."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        SimpleManagedEntity.__init__(self)
        Publisher.__init__(self, *args, **kwargs)

    def publish(self, msg: MsgType | bytes) -> None:
        """Send a message if the node is active; see `Publisher.publish`."""
        if self.is_activated:
            super().publish(msg)
