"""Lifecycle nodes, by their own methods and by their services."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tfloom.interfaces.lifecycle_msgs.msg import Transition, TransitionEvent
from tfloom.interfaces.lifecycle_msgs.srv import (
    ChangeState,
    GetAvailableStates,
    GetAvailableTransitions,
    GetState,
)
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.lifecycle.managed_entity import TransitionCallbackReturn
from tfloom.node.lifecycle.node import LifecycleNode, LifecycleState
from tfloom.node.node import Node
from tfloom.node.values.exceptions import RCLError

SUCCESS, FAILURE, ERROR = TransitionCallbackReturn


class Managed(LifecycleNode):
    """Returns a configured result in each transition, and records the calls."""

    def __init__(self, context: Context) -> None:
        super().__init__("managed", context=context)
        self.plan: dict[str, Any] = {}
        self.done: list[tuple[str, str]] = []

    def _do(self, name: str, state: LifecycleState) -> TransitionCallbackReturn:
        self.done.append((name, state.label))
        wish = self.plan.get(name)
        if isinstance(wish, Exception):
            raise wish
        return wish or getattr(super(), name)(state)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._do("on_configure", state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._do("on_activate", state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._do("on_deactivate", state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._do("on_error", state)


@pytest.fixture
def managed(context: Context) -> Iterator[Managed]:
    with Managed(context) as node:
        yield node


def test_transitions_lead_to_active_and_back(managed: Managed) -> None:
    assert managed.trigger_configure() is SUCCESS
    assert managed.trigger_activate() is SUCCESS
    assert managed.trigger_deactivate() is SUCCESS
    assert managed.trigger_cleanup() is SUCCESS
    assert managed.trigger_shutdown() is SUCCESS
    assert managed.done == [
        ("on_configure", "unconfigured"),
        ("on_activate", "inactive"),
        ("on_deactivate", "active"),
    ]
    with pytest.raises(RCLError, match="no transition configure from state finalized"):
        managed.trigger_configure()


def test_failed_transition_returns_to_the_previous_state(managed: Managed) -> None:
    managed.plan = {"on_configure": FAILURE}
    assert managed.trigger_configure() is FAILURE
    with pytest.raises(RCLError, match="from state unconfigured"):
        managed.trigger_activate()


@pytest.mark.parametrize(
    ("answer", "state"), [(SUCCESS, "unconfigured"), (FAILURE, "finalized"), (ERROR, "finalized")]
)
def test_error_in_a_transition_calls_on_error(
    answer: TransitionCallbackReturn, state: str, managed: Managed, capsys: pytest.CaptureFixture[str]
) -> None:
    managed.plan = {"on_activate": ValueError("mine"), "on_error": answer}
    managed.trigger_configure()
    assert managed.trigger_activate() is ERROR
    assert managed.done[-1] == ("on_error", "inactive")
    assert "Error raised while activating: mine" in capsys.readouterr().err
    with pytest.raises(RCLError, match=f"from state {state}"):
        managed.trigger_activate()


def test_lifecycle_publishers_publish_only_while_active(
    managed: Managed, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    heard: list[str] = []
    publisher = managed.create_lifecycle_publisher(String, "chatter", 10)
    managed.create_subscription(String, "chatter", lambda msg: heard.append(msg.data), 10)
    executor.add_node(managed)
    publisher.publish(String(data="too early"))
    managed.trigger_configure()
    managed.trigger_activate()
    assert publisher.is_activated
    publisher.publish(String(data="now"))
    managed.trigger_deactivate()
    publisher.publish(String(data="too late"))
    spin_until(lambda: heard)
    executor.spin_once(timeout_sec=0)
    assert heard == ["now"]
    assert managed.destroy_lifecycle_publisher(publisher)


def test_services_change_the_state_and_events_report_it(
    managed: Managed, node: Node, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    executor.add_node(managed)
    executor.add_node(node)
    events: list[TransitionEvent] = []
    node.create_subscription(TransitionEvent, "/managed/transition_event", events.append, 10)

    def call(srv_type: Any, name: str, request: Any = None) -> Any:
        client = node.create_client(srv_type, f"/managed/{name}")
        assert client.wait_for_service(timeout_sec=5)
        future = client.call_async(request or srv_type.Request())
        executor.spin_until_future_complete(future, timeout_sec=5)
        return future.result()

    def change(transition: Transition) -> bool:
        return call(ChangeState, "change_state", ChangeState.Request(transition=transition)).success

    assert call(GetState, "get_state").current_state.label == "unconfigured"
    assert change(Transition(id=Transition.TRANSITION_CONFIGURE))
    assert change(Transition(label="activate"))
    assert not change(Transition(label="configure"))
    assert not change(Transition(id=99))
    assert call(GetState, "get_state").current_state.id == 3
    available = call(GetAvailableTransitions, "get_available_transitions").available_transitions
    assert [
        (description.transition.id, description.transition.label, description.goal_state.label)
        for description in available
    ] == [(4, "deactivate", "deactivating"), (7, "shutdown", "shuttingdown")]
    states = call(GetAvailableStates, "get_available_states").available_states
    assert [(state.id, state.label) for state in states] == [
        *[(0, "unknown"), (1, "unconfigured"), (2, "inactive"), (3, "active"), (4, "finalized")],
        *[(10, "configuring"), (11, "cleaningup"), (12, "shuttingdown"), (13, "activating")],
        *[(14, "deactivating"), (15, "errorprocessing")],
    ]
    assert len(call(GetAvailableTransitions, "get_transition_graph").available_transitions) == 25
    assert change(Transition(label="shutdown"))
    spin_until(lambda: len(events) == 6)
    assert [event.goal_state.label for event in events] == [
        "configuring",
        "inactive",
        "activating",
        "active",
        "shuttingdown",
        "finalized",
    ]


def test_results_of_transitions_are_printed_by_name() -> None:
    result = TransitionCallbackReturn.FAILURE
    texts = (str(result), f"{result}", repr(result))
    assert texts == (
        *2 * ["TransitionCallbackReturnType.FAILURE"],
        "<TransitionCallbackReturnType.FAILURE: 98>",
    )
