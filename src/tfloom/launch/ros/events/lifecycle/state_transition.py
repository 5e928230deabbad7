"""The event of a lifecycle node's transition."""

from __future__ import annotations

from typing import Any

from tfloom.launch.event import Event

__all__ = ["StateTransition"]


class StateTransition(Event):
    """A lifecycle node has gone from one state to another.

    Args:
        action: The LifecycleNode.
        msg: The lifecycle_msgs/msg/TransitionEvent that the node has published.
    """

    name = "launch_ros.events.lifecycle.StateTransition"

    def __init__(self, *, action: Any, msg: Any) -> None:
        self._action = action
        self._msg = msg

    @property
    def action(self) -> Any:
        """The LifecycleNode."""
        return self._action

    @property
    def msg(self) -> Any:
        """The node's message."""
        return self._msg

    @property
    def timestamp(self) -> int:
        """Time of the transition [ns]."""
        return int(self._msg.timestamp)

    @property
    def transition(self) -> str:
        """Name of the transition."""
        return str(self._msg.transition.label)

    @property
    def start_state(self) -> str:
        """Name of the state before."""
        return str(self._msg.start_state.label)

    @property
    def goal_state(self) -> str:
        """Name of the state after."""
        return str(self._msg.goal_state.label)
