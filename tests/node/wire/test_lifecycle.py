"""A lifecycle node in another process: its services, its events, and its log outputs."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import Program

from tfloom.interfaces.lifecycle_msgs.msg import Transition, TransitionEvent
from tfloom.interfaces.lifecycle_msgs.srv import (
    ChangeState,
    GetState,
)
from tfloom.interfaces.rcl_interfaces.msg import Log, LoggerLevel
from tfloom.interfaces.rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.qos import qos_profile_rosout_default

Start = Callable[..., Program]
Call = Callable[..., Any]
SpinUntil = Callable[..., None]


@pytest.fixture
def managed(start: Start) -> Program:
    return start("managed")


@pytest.fixture
def call(node: Node, managed: Program, finish: Callable[..., Any]) -> Call:
    """Call a service of the node in the other process."""

    def call(srv_type: Any, name: str, **fields: Any) -> Any:
        client = node.create_client(srv_type, f"/managed/{name}")
        assert client.wait_for_service(timeout_sec=20)
        response = finish(client.call_async(srv_type.Request(**fields)))
        node.destroy_client(client)
        return response

    return call


def change(call: Call, label: str) -> bool:
    return bool(call(ChangeState, "change_state", transition=Transition(label=label)).success)


def state(call: Call) -> str:
    return str(call(GetState, "get_state").current_state.label)


def test_requested_transitions_are_made_and_published(
    node: Node, call: Call, managed: Program, spin_until: SpinUntil
) -> None:
    events: list[TransitionEvent] = []
    heard: list[String] = []
    subscription = node.create_subscription(TransitionEvent, "/managed/transition_event", events.append, 10)
    node.create_subscription(String, "chatter", heard.append, 10)
    spin_until(subscription.get_publisher_count)
    assert state(call) == "unconfigured"
    assert change(call, "configure")
    assert not heard
    assert call(ChangeState, "change_state", transition=Transition(id=Transition.TRANSITION_ACTIVATE)).success
    spin_until(lambda: heard)
    assert not change(call, "configure")
    managed.wait_for("no transition configure from state active")
    assert change(call, "deactivate")
    assert change(call, "cleanup")
    assert change(call, "shutdown")
    assert state(call) == "finalized"
    spin_until(lambda: len(events) == 10)
    told = [(event.transition.label, event.start_state.label, event.goal_state.label) for event in events]
    assert told == [
        ("configure", "unconfigured", "configuring"),
        ("transition_success", "configuring", "inactive"),
        ("activate", "inactive", "activating"),
        ("transition_success", "activating", "active"),
        ("deactivate", "active", "deactivating"),
        ("transition_success", "deactivating", "inactive"),
        ("cleanup", "inactive", "cleaningup"),
        ("transition_success", "cleaningup", "unconfigured"),
        ("shutdown", "unconfigured", "shuttingdown"),
        ("transition_success", "shuttingdown", "finalized"),
    ]
    assert [event.transition.id for event in events[:2]] == [Transition.TRANSITION_CONFIGURE, 10]


FAILURES = {
    "failure": [("transition_failure", "unconfigured")],
    "raise": [("transition_error", "errorprocessing"), ("transition_success", "unconfigured")],
}
"""What follows the start of a transition, by the way in which it fails."""


def test_failing_transitions_are_reported(
    node: Node, call: Call, managed: Program, finish: Callable[..., Any], spin_until: SpinUntil
) -> None:
    events: list[TransitionEvent] = []
    subscription = node.create_subscription(TransitionEvent, "/managed/transition_event", events.append, 10)
    spin_until(subscription.get_publisher_count)
    client = AsyncParameterClient(node, "/managed")
    assert client.wait_for_services(timeout_sec=20)
    for wish, ends in FAILURES.items():
        events.clear()
        assert finish(client.set_parameters([Parameter("configure", value=wish)])).results[0].successful
        assert not change(call, "configure")
        spin_until(lambda ends=ends: len(events) == 1 + len(ends))
        assert [(event.transition.label, event.goal_state.label) for event in events[1:]] == ends
        assert state(call) == "unconfigured"
    managed.wait_for("Error raised while configuring: broken")
    managed.wait_for("ValueError: broken")
    managed.wait_for("[managed]: cleaning up")
    assert finish(client.set_parameters([Parameter("configure", value="success")])).results[0].successful
    assert change(call, "configure")


def test_log_goes_to_console_rosout_and_file_at_the_set_level(
    node: Node, call: Call, managed: Program, spin_until: SpinUntil
) -> None:
    records: list[Log] = []
    node.create_subscription(Log, "/rosout", records.append, qos_profile_rosout_default)
    spin_until(lambda: node.count_publishers("/rosout") == 2)
    spin_until(lambda: all(subscription.get_publisher_count() == 2 for subscription in node.subscriptions))
    names = ["managed", "rclpy", ""]
    levels = call(GetLoggerLevels, "get_logger_levels", names=names).levels
    assert [level.level for level in levels] == [0, 0, 20]  # the level set for each name
    assert change(call, "configure")
    spin_until(lambda: records)
    assert change(call, "cleanup")
    levels = [LoggerLevel(name="managed", level=10), LoggerLevel(name="managed", level=35)]
    results = call(SetLoggerLevels, "set_logger_levels", levels=levels).results
    assert [result.successful for result in results] == [True, False]
    assert call(GetLoggerLevels, "get_logger_levels", names=["managed"]).levels[0].level == 10
    assert change(call, "configure")
    spin_until(lambda: len(records) == 3)
    assert [(record.level, record.name, record.msg) for record in records] == [
        (20, "managed", "configure from unconfigured"),
        (20, "managed", "configure from unconfigured"),
        (10, "managed", "in detail"),
    ]
    assert records[0].file.endswith("managed.py")
    assert records[0].function == "on_configure"
    assert records[0].line > 0
    assert records[0].stamp.sec > 0
    (path,) = Path(os.environ["ROS_LOG_DIR"]).glob(f"managed_{managed.process.pid}_*.log")
    assert re.fullmatch(r"managed_\d+_\d+\.log", path.name)

    def console() -> list[str]:
        return [line for line in managed.lines if line.startswith("[")]

    spin_until(lambda: len(console()) == 3)
    assert path.read_text().splitlines() == console()
    assert re.fullmatch(r"\[DEBUG\] \[\d{10}\.\d{9}\] \[managed\]: in detail", console()[2])
