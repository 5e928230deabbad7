"""Events of lifecycle nodes, and matchers of the actions that start nodes."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any, ClassVar, Protocol

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.launch.core.event import Event

__all__ = ["ChangeState", "NamedNode", "StateTransition", "matches_lifecycle_node_name", "matches_node_name"]


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
        """LifecycleNode whose state has changed."""
        return self._action

    @property
    def msg(self) -> Any:
        """The node's message."""
        return self._msg

    @property
    def timestamp(self) -> int:
        """Time of the transition [ns]; `stamp` in ROS 2 Lyrical."""
        if hasattr(self._msg, "stamp"):
            return int(self._msg.stamp.sec) * 10**9 + int(self._msg.stamp.nanosec)
        return int(self._msg.timestamp)

    @property
    def stamp(self) -> Time:
        """Time of the transition, a builtin_interfaces/msg/Time; `timestamp` before ROS 2 Lyrical."""
        sec, nanosec = divmod(self.timestamp, 10**9)
        return Time(sec=sec, nanosec=nanosec)

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


class ChangeState(Event):
    """Requests a transition of the lifecycle nodes that a matcher accepts.

    Args:
        lifecycle_node_matcher: Returns whether a LifecycleNode is meant.
        transition_id: A constant of lifecycle_msgs/msg/Transition, as TRANSITION_CONFIGURE.

    Raises:
        ValueError: there is no such transition.
    """

    name = "launch_ros.events.lifecycle.ChangeState"

    valid_states: ClassVar = {
        0: "unknown",
        1: "unconfigured",
        2: "inactive",
        3: "active",
        4: "finalized",
        10: "configuring",
        11: "cleaningup",
        12: "shuttingdown",
        13: "activating",
        14: "deactivating",
        15: "errorprocessing",
    }
    """Names of the states of lifecycle_msgs/msg/State."""

    valid_transitions: ClassVar = {
        0: "create",
        1: "configure",
        2: "cleanup",
        3: "activate",
        4: "deactivate",
        5: "unconfigured_shutdown",
        6: "inactive_shutdown",
        7: "active_shutdown",
        8: "destroy",
        10: "on_configure_success",
        11: "on_configure_failure",
        12: "on_configure_error",
        20: "on_cleanup_success",
        21: "on_cleanup_failure",
        22: "on_cleanup_error",
        30: "on_activate_success",
        31: "on_activate_failure",
        32: "on_activate_error",
        40: "on_deactivate_success",
        41: "on_deactivate_failure",
        42: "on_deactivate_error",
        50: "on_shutdown_success",
        51: "on_shutdown_failure",
        52: "on_shutdown_error",
        60: "on_error_success",
        61: "on_error_failure",
        62: "on_error_error",
        97: "callback_success",
        98: "callback_failure",
        99: "callback_error",
    }
    """Names of the transitions of lifecycle_msgs/msg/Transition."""

    def __init__(self, *, lifecycle_node_matcher: Callable[[Any], bool], transition_id: int) -> None:
        if transition_id not in self.valid_transitions:
            transitions = ", ".join(
                f"{number} ({name})" for number, name in self.valid_transitions.items() if number < 10
            )
            raise ValueError(
                f"transition_id {transition_id} is not a transition of a lifecycle node; use one of {transitions}"
            )
        self._matcher = lifecycle_node_matcher
        self._transition_id = transition_id

    @property
    def lifecycle_node_matcher(self) -> Callable[[Any], bool]:
        """Returns whether a LifecycleNode is meant."""
        return self._matcher

    @property
    def transition_id(self) -> int:
        """Number of the requested transition, as in lifecycle_msgs/msg/Transition."""
        return self._transition_id


class NamedNode(Protocol):
    """An action that starts a node, as events need it."""

    @property
    def node_name(self) -> str:
        """Full name of the node."""


def matches_node_name(node_name: str) -> Callable[[NamedNode], bool]:
    """Return a matcher of the action whose node has a name, which may lack the first slash."""
    full = node_name if node_name.startswith("/") else f"/{node_name}"
    return lambda action: action.node_name == full


def matches_lifecycle_node_name(node_name: str) -> Callable[[NamedNode], bool]:
    """Return `matches_node_name(node_name)`, with a warning that its place among lifecycle events is deprecated."""
    warnings.warn(
        "The 'launch_ros.events.lifecycle.matches_node_name' function is deprecated. Please use "
        "'launch_ros.events.matches_node_name' instead.",
        stacklevel=2,
    )
    return matches_node_name(node_name)
