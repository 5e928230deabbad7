"""The transition of lifecycle nodes, as an action, and the handler of the transitions that they report."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, ClassVar, Union

from tfloom.launch.actions.event_actions import EmitEvent
from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, SomeEntitiesType, SomeSubstitutionsType
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import EventHandler
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.ros.actions.lifecycle_node import LifecycleNode
from tfloom.launch.ros.lifecycle_events import ChangeState, StateTransition, matches_node_name
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["LifecycleTransition", "OnStateTransition", "match_node_name_goal", "match_node_name_start_goal"]


class OnStateTransition(EventHandler):
    """Visits entities after a transition of a lifecycle node; what is None isn't compared.

    Args:
        entities: The entities.
        target_lifecycle_node: The node.
        transition: Name of the transition.
        start_state: Name of the state before.
        goal_state: Name of the state after.
        matcher: Called with the event, for a condition of one's own.
        kwargs: As for EventHandler.

    Raises:
        RuntimeError: the target is not a LifecycleNode.
    """

    def __init__(
        self,
        *,
        entities: SomeEntitiesType,
        target_lifecycle_node: LifecycleNode | None = None,
        transition: SomeSubstitutionsType | None = None,
        start_state: SomeSubstitutionsType | None = None,
        goal_state: SomeSubstitutionsType | None = None,
        matcher: Callable[[Event], bool] | None = None,
        **kwargs: Any,
    ) -> None:
        if not isinstance(target_lifecycle_node, (LifecycleNode, type(None))):
            raise RuntimeError("OnStateTransition requires a 'LifecycleNode' action as the target")
        self._target = target_lifecycle_node
        self._labels = {"transition": transition, "start_state": start_state, "goal_state": goal_state}
        self._custom_matcher = matcher
        super().__init__(matcher=self._accepts, entities=entities, **kwargs)

    def _accepts(self, event: Event) -> bool:
        return (
            isinstance(event, StateTransition)
            and (self._target is None or event.action is self._target)
            and all(label is None or getattr(event, name) == label for name, label in self._labels.items())
            and (self._custom_matcher is None or self._custom_matcher(event))
        )

    @property
    def handler_description(self) -> str:
        """What it does, for people."""
        return "<actions>"

    @property
    def matcher_description(self) -> str:
        """Which events it handles, for people."""
        named = {**self._labels, "target_lifecycle_node": self._target}
        conditions = [f"{name}={value!r}" for name, value in named.items() if value is not None]
        return " and ".join(["event == StateTransition", *conditions])


EventMatcher = Callable[[Event], bool]


def match_node_name_goal(node_name: str, goal_state: str) -> EventMatcher:
    """Return a matcher of transitions of a node to a state."""
    return lambda event: (
        isinstance(event, StateTransition)
        and matches_node_name(node_name)(event.action)
        and event.goal_state == goal_state
    )


def match_node_name_start_goal(node_name: str, start_state: str, goal_state: str) -> EventMatcher:
    """Return a matcher of transitions of a node from a state to another."""
    is_to_goal = match_node_name_goal(node_name, goal_state)
    return lambda event: (
        isinstance(event, StateTransition) and event.start_state == start_state and is_to_goal(event)
    )


class LifecycleTransition(Action):
    """Requests transitions of lifecycle nodes in order: each after the one before it has succeeded.

    Args:
        lifecycle_node_names: Full names of the nodes, or substitutions for them.
        transition_ids: Constants of lifecycle_msgs/msg/Transition, or substitutions for them.
        kwargs: As for Action.

    Raises:
        ValueError: there are no nodes, or no transitions.
    """

    transition_targets: ClassVar = {
        1: {"start_state": "configuring", "goal_state": "inactive"},
        2: {"start_state": "cleaningup", "goal_state": "unconfigured"},
        3: {"start_state": "activating", "goal_state": "active"},
        4: {"start_state": "deactivating", "goal_state": "inactive"},
        5: {"start_state": "shuttingdown", "goal_state": "finalized"},
        6: {"start_state": "shuttingdown", "goal_state": "finalized"},
        7: {"start_state": "shuttingdown", "goal_state": "finalized"},
    }
    """The state during each transition, and the one after its success."""

    def __init__(
        self,
        *,
        lifecycle_node_names: Iterable[SomeSubstitutionsType],
        transition_ids: Iterable[Union[int, SomeSubstitutionsType]],
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self._names = [normalize_to_list_of_substitutions(name) for name in lifecycle_node_names]
        self._transitions = [
            normalize_to_list_of_substitutions(str(number) if isinstance(number, int) else number)
            for number in transition_ids
        ]
        if not self._names:
            raise ValueError("No lifecycle_node_names provided.")
        if not self._transitions:
            raise ValueError("No transition_ids provided.")

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Request the first transition of each node, and follow the node's transitions.

        Raises:
            ValueError: a transition's text is not a number of one.
        """
        transitions = [
            self._transition_number(perform_substitutions(context, text)) for text in self._transitions
        ]
        first: list[LaunchDescriptionEntity] = []
        for substitutions in self._names:
            name = perform_substitutions(context, substitutions)
            _Sequence(name, transitions).follow(context)
            first.append(EmitEvent(event=_request(name, transitions[0])))
        return first

    def _transition_number(self, text: str) -> int:
        if not text.isdecimal() or int(text) not in self.transition_targets:
            numbers = ", ".join(map(str, self.transition_targets))
            raise ValueError(
                f"'{text}' is not a transition that LifecycleTransition can request; use one of {numbers}"
            )
        return int(text)


class _Sequence:
    """The transitions of a node that are left; used by the thread that runs the launch."""

    def __init__(self, name: str, transitions: list[int]) -> None:
        self._name = name
        self._left = list(transitions)
        self._is_of_node = matches_node_name(name)
        self._handler = OnStateTransition(
            matcher=self._ends_a_transition, entities=[OpaqueFunction(function=self._request_next)]
        )

    def follow(self, context: LaunchContext) -> None:
        """Handle the state transitions of the node from now on."""
        context.register_event_handler(self._handler)

    def _ends_a_transition(self, event: Event) -> bool:
        """Return whether the transition that was requested has ended, whether successfully or not."""
        return (
            isinstance(event, StateTransition)
            and self._is_of_node(event.action)
            and event.start_state in (self._target["start_state"], "errorprocessing")
        )

    @property
    def _target(self) -> dict[str, str]:
        return LifecycleTransition.transition_targets[self._left[0]]

    def _request_next(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        # The transition that was requested has ended: in its goal state, in another one, or in error processing, which
        # is another transition and ends later. Only a success leads to the next request.
        event = context.locals.event
        succeeded = (event.start_state, event.goal_state) == tuple(self._target.values())
        if not succeeded and event.goal_state == "errorprocessing":
            return None  # its end is the next event
        done = self._left.pop(0)
        if succeeded and self._left:
            return [EmitEvent(event=_request(self._name, self._left[0]))]
        context.unregister_event_handler(self._handler)
        if not succeeded and self._left:
            get_logger("launch_ros.actions.lifecycle_transition").error(
                f"'{self._name}' is {event.goal_state} after the transition "
                f"'{ChangeState.valid_transitions[done]}', so that the transitions after it are not requested: "
                + ", ".join(ChangeState.valid_transitions[number] for number in self._left)
            )
        return None


def _request(name: str, transition: int) -> ChangeState:
    return ChangeState(lifecycle_node_matcher=matches_node_name(name), transition_id=transition)
