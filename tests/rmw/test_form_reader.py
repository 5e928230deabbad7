"""A message that distributions define otherwise is read by the definition of its sender, on each wire."""

from __future__ import annotations

import json
import os
import sys
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.bag.writing.definition_text import find_definition
from tfloom.interfaces.lifecycle_msgs.msg import State, Transition, TransitionEvent
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared import form_reader
from tfloom.rosidl import cdr
from tfloom.rosidl.definition_files import forms_of
from tfloom.rosidl.dynamic import define
from tfloom.rosidl.other_forms import FORMS, converted, forms_beside
from tfloom.rosidl.recorded import recorded_class

TYPE = "lifecycle_msgs/msg/TransitionEvent"
OLDER, NEWER = FORMS[TYPE]
PUBLISH = """
import sys, rclpy
from lifecycle_msgs.msg import TransitionEvent
with rclpy.init():
    node = rclpy.create_node("publishes")
    publisher = node.create_publisher(TransitionEvent, "events", 10)
    event = TransitionEvent()
    event.transition.label = sys.argv[1]
    if hasattr(event, "stamp"):
        event.stamp.sec, event.stamp.nanosec = 7, 1
    else:
        event.timestamp = 7_000_000_001
    node.create_timer(0.05, lambda: publisher.publish(event))
    rclpy.spin(node)
"""
SUBSCRIBE = """
import json, rclpy
from lifecycle_msgs.msg import TransitionEvent
times = {}
def note(event):
    stamp = getattr(event, "stamp", None)
    times[event.transition.label] = event.timestamp if stamp is None else [stamp.sec, stamp.nanosec]
    if len(times) == 2:
        print(json.dumps(times), flush=True)
with rclpy.init():
    node = rclpy.create_node("subscribes")
    node.create_subscription(TransitionEvent, "events", note, 10)
    rclpy.spin(node)
"""


@pytest.mark.wire
@pytest.mark.parametrize("wire", ["rmw_cyclonedds_cpp", "rmw_zenoh_cpp"])
def test_events_of_both_distributions_are_read_from_one_topic(
    wire: str, domain_id: int, start_program: Any
) -> None:
    if wire == "rmw_zenoh_cpp":
        pytest.importorskip("zenoh")
    environment = os.environ | {"RMW_IMPLEMENTATION": wire}
    readers, programs = {}, []
    for distro in ("jazzy", "lyrical"):
        own = environment | {"ROS_DISTRO": distro}
        programs.append(start_program(sys.executable, "-c", PUBLISH, distro, env=own))
        readers[distro] = start_program(sys.executable, "-c", SUBSCRIBE, env=own)
        readers[f"echo of {distro}"] = start_program(
            "ros2", "topic", "echo", "/events", TYPE, "--csv", env=own
        )

    def lines(reader: str, start: str) -> list[str]:
        return [line for line in readers[reader].lines if line.startswith(start)]

    wait_until(lambda: lines("jazzy", "{") and lines("lyrical", "{"), 60)
    assert not any("nothing passes" in line for program in programs for line in program.lines)
    expected = {"jazzy": 7_000_000_001, "lyrical": [7, 1]}
    for distro, time in expected.items():
        for line in lines(distro, "{"):
            assert json.loads(line) == dict.fromkeys(expected, time), distro
    for distro, beginning in (("jazzy", "7000000001,"), ("lyrical", "7,1,")):
        echo = f"echo of {distro}"
        wait_until(
            lambda echo=echo: (
                {label for label in expected if any(label in x for x in lines(echo, "7"))} == set(expected)
            ),
            60,
        )
        assert len(lines(echo, "7")) == len(lines(echo, beginning))


def older(**fields: Any) -> bytes:
    event = TransitionEvent(transition=Transition(label="up"), goal_state=State(label="active"), **fields)
    return cdr.encode(event)


def newer(sec: int, nanosec: int) -> Any:
    event = recorded_class(TYPE, "ros2msg", forms_of(TYPE)[1].read_text("utf-8"), NEWER.type_hash)()
    event.stamp.sec, event.stamp.nanosec = sec, nanosec
    event.transition.label = "up"
    event.goal_state.label = "active"
    return event


def test_time_is_converted_within_its_range() -> None:
    for sec, nanosec, stamp in (
        (7, 1, 7_000_000_001),
        (0, 0, 0),
        (-1, 5, 0),
        (2**31 - 1, 0, (2**31 - 1) * 10**9),
    ):
        assert converted(TYPE, NEWER, cdr.encode(newer(sec, nanosec))) == older(timestamp=stamp)


def test_time_is_converted_to_the_newer_form(monkeypatch: pytest.MonkeyPatch) -> None:
    kind = type(newer(0, 0))
    monkeypatch.setattr("tfloom.rosidl.registry.get_message_class", lambda _: kind)
    for stamp, sec, nanosec in ((7_000_000_001, 7, 1), (0, 0, 0), (2**64 - 1, 2**31 - 1, 709_551_615)):
        assert cdr.decode(kind, _as_newer(stamp)) == newer(sec, nanosec)


def _as_newer(stamp: int) -> bytes:
    # The class of the older form, which `converted` would make as a recorded one, is the one here.
    return converted(TYPE, OLDER, older(timestamp=stamp))


def test_forms_are_those_of_the_definitions() -> None:
    assert forms_beside(TYPE, OLDER.type_hash) == (OLDER, NEWER)
    assert forms_beside(TYPE, NEWER.type_hash) == (NEWER, OLDER)
    assert forms_beside(TYPE, "RIHS01_0") is None
    assert forms_beside("std_msgs/msg/String", OLDER.type_hash) is None
    assert OLDER.type_hash == TransitionEvent._TYPE_HASH
    assert type(newer(0, 0)).get_fields_and_field_types()["stamp"] == "builtin_interfaces/Time"


@pytest.mark.parametrize(
    ("type_hash", "says"), [("", "doesn't say which it has"), (f"RIHS01_{'0' * 64}", "has a third one")]
)
def test_publisher_without_a_known_hash_is_warned_of_once(
    type_hash: str, says: str, make_node: Any, capfd: Any
) -> None:
    node = make_node("subscribes")
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    taken: list[Any] = []
    node.create_subscription(TransitionEvent, "/events", taken.append, 10)
    participant = node._NodeBase__entities.participant()
    writer = participant.create_writer(NodeName("/", "other"), Topic("/events", TYPE, type_hash), QoS())
    for stamp in (1, 2):
        writer.write(older(timestamp=stamp))
        wait_until(lambda: executor.spin_once(timeout_sec=0.01) or len(taken) == stamp, 20)  # noqa: B023
    assert [event.timestamp for event in taken] == [1, 2]
    text = (
        f"{TYPE} has two definitions, and a publisher of /events {says}: it is read with 'timestamp', as up to Kilted, "
        "and not with 'stamp', as from Lyrical on"
    )
    assert capfd.readouterr().err.count(text) == 1


def test_a_publishers_hash_may_become_known_after_its_first_event(
    make_node: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    participant = make_node("subscribes")._NodeBase__entities.participant()
    own, topic = NodeName("/", "own"), Topic("/events", TYPE, OLDER.type_hash)
    reader: Any = form_reader.create_reader(participant, own, topic, QoS(), lambda _: None)
    writer = participant.create_writer(own, topic._replace(type_hash=NEWER.type_hash), QoS())
    for _ in range(2):
        writer.write(cdr.encode(newer(7, 1)))
    with monkeypatch.context() as patch:
        patch.setattr(type(reader._reader), "publisher_hash", lambda self, gid: "")
        assert reader.take().data == cdr.encode(newer(7, 1))
    assert reader.take().data == older(timestamp=7_000_000_001)
    reader.close()
    writer.close()


def test_damaged_and_raw_events(make_node: Any, capfd: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(form_reader, "MAX_PUBLISHERS", 1)
    node = make_node("subscribes")
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    whole: list[Any] = []
    raw: list[bytes] = []
    node.create_subscription(TransitionEvent, "/events", whole.append, 10)
    node.create_subscription(TransitionEvent, "/events", raw.append, 10, raw=True)
    participant = node._NodeBase__entities.participant()
    topic = Topic("/events", TYPE, NEWER.type_hash)
    data = cdr.encode(newer(7, 1))
    for number in range(3):
        writer = participant.create_writer(NodeName("/", f"other{number}"), topic, QoS())
        writer.write(data[:-9])
        writer.write(data)
    wait_until(lambda: executor.spin_once(timeout_sec=0.01) or (len(whole), len(raw)) == (3, 6), 20)
    assert {event.timestamp for event in whole} == {7_000_000_001}
    assert raw == [data[:-9], older(timestamp=7_000_000_001)] * 3
    assert "that is not a valid lifecycle_msgs/msg/TransitionEvent" in capfd.readouterr().err


def test_an_own_definition_is_left_alone(make_node: Any) -> None:
    """A program that defines the type itself reads what it has defined."""
    from tfloom.rosidl.sources import replace

    own = define(TYPE, "uint8 x")
    try:
        assert forms_beside(own._TYPE_NAME, own._TYPE_HASH) is None
    finally:
        replace(TYPE, None)
        from tfloom.rosidl.class_table import register

        register(TYPE, TransitionEvent)


def test_recording_has_the_definition_of_the_publisher() -> None:
    for form, number in ((OLDER, 0), (NEWER, 1)):
        text = forms_of(TYPE)[number].read_text("utf-8")
        definition = find_definition(TYPE, form.type_hash)
        assert definition is not None
        assert definition.text.startswith(text)
        assert (OLDER.type_hash if form is OLDER else type(newer(0, 0))._TYPE_HASH) == recorded_class(
            TYPE, definition.encoding, definition.text
        )._TYPE_HASH
        assert ("MSG: builtin_interfaces/Time" in definition.text) is (form is NEWER)
