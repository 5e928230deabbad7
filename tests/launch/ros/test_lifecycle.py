"""Lifecycle nodes: their transitions as events, and events that request transitions; over DDS."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tfloom.interfaces.lifecycle_msgs.msg import State, Transition, TransitionEvent
from tfloom.launch.actions.event_actions import EmitEvent, RegisterEventHandler, Shutdown
from tfloom.launch.actions.log import LogInfo
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.ros.actions.lifecycle_node import LifecycleNode
from tfloom.launch.ros.actions.lifecycle_transition import (
    LifecycleTransition,
    OnStateTransition,
    match_node_name_goal,
    match_node_name_start_goal,
)
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.lifecycle_events import (
    ChangeState,
    StateTransition,
    matches_lifecycle_node_name,
    matches_node_name,
)

SENSOR = Path(__file__).parents[3] / "examples" / "lifecycle" / "sensor.py"


def sensor() -> LifecycleNode:
    return LifecycleNode(executable=sys.executable, arguments=[str(SENSOR)], name="sensor", namespace="")


def on(node: LifecycleNode, goal: str, *actions: object) -> RegisterEventHandler:
    log = LogInfo(msg=f"the sensor is {goal}")
    return RegisterEventHandler(
        OnStateTransition(target_lifecycle_node=node, goal_state=goal, entities=[log, *actions])
    )


def test_events_change_the_state_and_report_it(launch: Callable[..., object], domain_id: int) -> None:
    node = sensor()

    def request(transition: int) -> EmitEvent:
        matches = matches_node_name("/sensor")
        return EmitEvent(event=ChangeState(lifecycle_node_matcher=matches, transition_id=transition))

    ran = launch(
        on(node, "inactive", request(Transition.TRANSITION_ACTIVATE)),
        on(node, "active", Shutdown(reason="done")),
        node,
        request(Transition.TRANSITION_CONFIGURE),
    )
    assert ran.code == 0, ran.lines
    reached = [line for line in ran.lines if "[launch.user]: the sensor is" in line]
    assert reached == [f"[INFO] [launch.user]: the sensor is {state}" for state in ("inactive", "active")]


def test_transitions_follow_one_another(launch: Callable[..., object], domain_id: int) -> None:
    node = sensor()
    ids = [Transition.TRANSITION_CONFIGURE, str(Transition.TRANSITION_ACTIVATE)]
    ran = launch(
        on(node, "active", Shutdown(reason="done")),
        node,
        LifecycleTransition(lifecycle_node_names=["sensor"], transition_ids=ids),
    )
    assert ran.code == 0, ran.lines
    assert "[INFO] [launch.user]: the sensor is active" in ran.lines


def test_refused_transition_is_reported(launch: Callable[..., object], domain_id: int) -> None:
    node = sensor()
    ran = launch(
        on(node, "inactive", Shutdown(reason="done")),
        node,
        LifecycleTransition(
            lifecycle_node_names=["/sensor"], transition_ids=[Transition.TRANSITION_ACTIVATE]
        ),
        LifecycleTransition(
            lifecycle_node_names=["/sensor"], transition_ids=[Transition.TRANSITION_CONFIGURE]
        ),
    )
    assert ran.code == 0, ran.lines
    assert (
        "[ERROR] [launch_ros.actions.lifecycle_node]: Failed to make transition 'activate' for LifecycleNode '/sensor'"
        in ran.lines
    )


class Named:
    """An action with a node's name."""

    node_name = "/a/sensor"


def event(start: str, goal: str) -> StateTransition:
    message = TransitionEvent(timestamp=7)
    message.start_state, message.goal_state = State(label=start), State(label=goal)
    message.transition.label = "configure"
    return StateTransition(action=Named(), msg=message)


def test_event_has_what_the_node_published() -> None:
    transition_event = event("configuring", "inactive")
    assert (
        transition_event.start_state,
        transition_event.goal_state,
        transition_event.transition,
        transition_event.timestamp,
    ) == (
        *("configuring", "inactive", "configure"),
        7,
    )
    assert transition_event.name == "launch_ros.events.lifecycle.StateTransition"


def test_matchers() -> None:
    transition_event = event("configuring", "inactive")
    assert matches_node_name("a/sensor")(Named())
    assert not matches_node_name("sensor")(Named())
    with pytest.warns(
        UserWarning, match=r"'launch_ros.events.lifecycle.matches_node_name' function is deprecated"
    ):
        assert matches_lifecycle_node_name("/a/sensor")(Named())
    assert match_node_name_goal("/a/sensor", "inactive")(transition_event)
    assert not match_node_name_goal("/a/sensor", "active")(transition_event)
    assert not match_node_name_goal("/sensor", "inactive")(transition_event)
    assert match_node_name_start_goal("/a/sensor", "configuring", "inactive")(transition_event)
    assert not match_node_name_start_goal("/a/sensor", "activating", "inactive")(transition_event)
    assert not match_node_name_goal("/a/sensor", "inactive")(Event())


@pytest.mark.parametrize(
    ("options", "accepted"),
    [
        ({}, True),
        ({"start_state": "configuring", "goal_state": "inactive", "transition": "configure"}, True),
        ({"start_state": "inactive"}, False),
        ({"goal_state": "active"}, False),
        ({"transition": "activate"}, False),
        ({"matcher": lambda event: event.timestamp == 8}, False),
        ({"target_lifecycle_node": sensor()}, False),
    ],
)
def test_handler_compares_what_is_given(options: dict[str, object], accepted: bool) -> None:
    handler = OnStateTransition(entities=[], **options)
    assert handler.matches(event("configuring", "inactive")) is accepted
    assert not handler.matches(Event())
    assert handler.matcher_description.startswith("event == StateTransition")


@pytest.mark.parametrize(
    ("states", "requested", "reported"),
    [
        ([("configuring", "inactive")], [Transition.TRANSITION_ACTIVATE], ""),
        (
            [("configuring", "inactive"), ("inactive", "activating"), ("activating", "active")],
            [Transition.TRANSITION_ACTIVATE],
            "",
        ),
        (
            [("configuring", "unconfigured")],
            [],
            "'/a/sensor' is unconfigured after the transition 'configure'",
        ),
        ([("configuring", "errorprocessing")], [], ""),
        (
            [("configuring", "errorprocessing"), ("errorprocessing", "finalized")],
            [],
            "so that the transitions after it are not requested: activate",
        ),
    ],
    ids=str,
)
def test_next_transition_needs_the_success_of_the_one_before(
    states: list[tuple[str, str]], requested: list[int], reported: str, capsys: pytest.CaptureFixture[str]
) -> None:
    context = LaunchContext()
    ids = [Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE]
    action = LifecycleTransition(lifecycle_node_names=["/a/sensor"], transition_ids=ids)
    (first,) = action.execute(context)
    assert first.event.transition_id == Transition.TRANSITION_CONFIGURE
    followed = []
    for start, goal in states:
        happened = event(start, goal)
        for handler in [handler for handler in context.run_state.handlers if handler.matches(happened)]:
            for entity in handler.handle(happened, context):
                followed += entity.execute(context) or []
    assert [action.event.transition_id for action in followed] == requested
    assert reported in capsys.readouterr().out


def test_wrong_arguments_are_refused() -> None:
    with pytest.raises(
        RuntimeError, match="OnStateTransition requires a 'LifecycleNode' action as the target"
    ):
        OnStateTransition(entities=[], target_lifecycle_node=Node(executable="x"))
    with pytest.raises(ValueError, match="transition_id 77 is not a transition of a lifecycle node"):
        ChangeState(lifecycle_node_matcher=lambda _: True, transition_id=77)
    with pytest.raises(ValueError, match=r"No lifecycle_node_names provided\."):
        LifecycleTransition(lifecycle_node_names=[], transition_ids=[1])
    with pytest.raises(ValueError, match=r"No transition_ids provided\."):
        LifecycleTransition(lifecycle_node_names=["a"], transition_ids=[])


def test_unknown_transition_ends_the_launch(launch: Callable[..., object]) -> None:
    ran = launch(LifecycleTransition(lifecycle_node_names=["a"], transition_ids=["configure"]))
    assert ran.code == 1
    assert "'configure' is not a transition that LifecycleTransition can request" in ran.lines[-1]
