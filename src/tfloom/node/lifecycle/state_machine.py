"""The states of a lifecycle node, and the transitions between them (https://design.ros2.org/articles/node_lifecycle.html)."""

from __future__ import annotations

from typing import NamedTuple

from tfloom.interfaces.lifecycle_msgs import msg as lifecycle_msg
from tfloom.interfaces.lifecycle_msgs.msg import State, Transition
from tfloom.node.lifecycle.managed_entity import TransitionCallbackReturn
from tfloom.node.values.exceptions import RCLError

__all__ = ["LifecycleState", "StateMachine", "Step"]


class LifecycleState(NamedTuple):
    """A state of a lifecycle node, by its label and the constant of `lifecycle_msgs/msg/State`."""

    label: str
    state_id: int

    def to_msg(self) -> lifecycle_msg.State:
        """Return the state as a message."""
        return State(id=self.state_id, label=self.label)


class Step(NamedTuple):
    """A transition between two states."""

    transition_id: int
    label: str
    start: LifecycleState
    goal: LifecycleState

    def as_tuple(self) -> tuple[int, str, int, str, int, str]:
        """Return id and label of the transition, of its start and of its goal."""
        start, goal = self.start, self.goal
        return self.transition_id, self.label, start.state_id, start.label, goal.state_id, goal.label

    def transition_msg(self) -> lifecycle_msg.Transition:
        """Return the transition as a message, without its states."""
        return Transition(id=self.transition_id, label=self.label)


def _state(name: str) -> LifecycleState:
    label = name.removeprefix("PRIMARY_STATE_").removeprefix("TRANSITION_STATE_").lower()
    return LifecycleState(label, getattr(State, name))


UNKNOWN = _state("PRIMARY_STATE_UNKNOWN")
UNCONFIGURED = _state("PRIMARY_STATE_UNCONFIGURED")
INACTIVE = _state("PRIMARY_STATE_INACTIVE")
ACTIVE = _state("PRIMARY_STATE_ACTIVE")
FINALIZED = _state("PRIMARY_STATE_FINALIZED")
CONFIGURING = _state("TRANSITION_STATE_CONFIGURING")
CLEANINGUP = _state("TRANSITION_STATE_CLEANINGUP")
SHUTTINGDOWN = _state("TRANSITION_STATE_SHUTTINGDOWN")
ACTIVATING = _state("TRANSITION_STATE_ACTIVATING")
DEACTIVATING = _state("TRANSITION_STATE_DEACTIVATING")
ERRORPROCESSING = _state("TRANSITION_STATE_ERRORPROCESSING")

STATES = [
    UNKNOWN,
    UNCONFIGURED,
    INACTIVE,
    ACTIVE,
    FINALIZED,
    CONFIGURING,
    CLEANINGUP,
    SHUTTINGDOWN,
    ACTIVATING,
    DEACTIVATING,
    ERRORPROCESSING,
]

_REQUESTS = [
    Step(Transition.TRANSITION_CONFIGURE, "configure", UNCONFIGURED, CONFIGURING),
    Step(Transition.TRANSITION_CLEANUP, "cleanup", INACTIVE, CLEANINGUP),
    Step(Transition.TRANSITION_ACTIVATE, "activate", INACTIVE, ACTIVATING),
    Step(Transition.TRANSITION_DEACTIVATE, "deactivate", ACTIVE, DEACTIVATING),
    Step(Transition.TRANSITION_UNCONFIGURED_SHUTDOWN, "shutdown", UNCONFIGURED, SHUTTINGDOWN),
    Step(Transition.TRANSITION_INACTIVE_SHUTDOWN, "shutdown", INACTIVE, SHUTTINGDOWN),
    Step(Transition.TRANSITION_ACTIVE_SHUTDOWN, "shutdown", ACTIVE, SHUTTINGDOWN),
]
_OUTCOMES = {
    # state: first id, then the goals of success, failure and error
    CONFIGURING: (Transition.TRANSITION_ON_CONFIGURE_SUCCESS, (INACTIVE, UNCONFIGURED, ERRORPROCESSING)),
    CLEANINGUP: (Transition.TRANSITION_ON_CLEANUP_SUCCESS, (UNCONFIGURED, INACTIVE, ERRORPROCESSING)),
    ACTIVATING: (Transition.TRANSITION_ON_ACTIVATE_SUCCESS, (ACTIVE, INACTIVE, ERRORPROCESSING)),
    DEACTIVATING: (Transition.TRANSITION_ON_DEACTIVATE_SUCCESS, (INACTIVE, ACTIVE, ERRORPROCESSING)),
    SHUTTINGDOWN: (Transition.TRANSITION_ON_SHUTDOWN_SUCCESS, (FINALIZED, FINALIZED, ERRORPROCESSING)),
    ERRORPROCESSING: (Transition.TRANSITION_ON_ERROR_SUCCESS, (UNCONFIGURED, FINALIZED, FINALIZED)),
}
_OUTCOME_LABELS = ("transition_success", "transition_failure", "transition_error")


def _outcome_steps() -> list[Step]:
    return [
        Step(first_id + number, label, start, goals[number])
        for start, (first_id, goals) in _OUTCOMES.items()
        for number, label in enumerate(_OUTCOME_LABELS)
    ]


STEPS = [*_REQUESTS, *_outcome_steps()]


class StateMachine:
    """The state of a lifecycle node, and its transitions."""

    def __init__(self) -> None:
        self.state = UNCONFIGURED

    @property
    def initialized(self) -> bool:
        """True; rclpy's machine has states from its creation on, too."""
        return True

    @property
    def current_state(self) -> tuple[int, str]:
        """Id and label of the present state, as rclpy's machine gives them."""
        return self.state.state_id, self.state.label

    @property
    def available_states(self) -> list[tuple[int, str]]:
        """Ids and labels of all states."""
        return [(state.state_id, state.label) for state in STATES]

    @property
    def available_transitions(self) -> list[tuple[int, str, int, str, int, str]]:
        """Id and label of each transition from the present state, those of its start, and those of its goal."""
        return [step.as_tuple() for step in self.available()]

    @property
    def transition_graph(self) -> list[tuple[int, str, int, str, int, str]]:
        """All transitions, as `available_transitions` has them."""
        return [step.as_tuple() for step in STEPS]

    def get_transition_by_label(self, label: str) -> int:
        """Return the id of the transition with a label from the present state.

        Raises:
            RCLError: there is no such transition.
        """
        return self.find(0, label).transition_id

    def available(self) -> list[Step]:
        """Return the transitions from the present state."""
        return [step for step in STEPS if step.start == self.state]

    def find(self, transition_id: int, label: str = "") -> Step:
        """Return the transition with a label, or else with an id, from the present state.

        Raises:
            RCLError: there is no such transition.
        """
        for step in self.available():
            if step.label == label if label else step.transition_id == transition_id:
                return step
        raise RCLError(
            f"Failed to trigger lifecycle state machine transition: no transition {label or transition_id} "
            f"from state {self.state.label}"
        )

    def outcome(self, result: TransitionCallbackReturn) -> Step:
        """Return the transition that the result of a callback leads to."""
        return self.find(0, result.to_label())
