"""Faults between processes: each leads to an error message or to a recovery."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import Program, wait_until

from tfloom.interfaces.sensor_msgs.msg import Image
from tfloom.interfaces.std_msgs.msg import Int32, String
from tfloom.node.context.context import Context
from tfloom.node.node import Node
from tfloom.node.qos.qos import HistoryPolicy, QoSProfile
from tfloom.node.values.duration import Duration
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.cyclone.wire import open_participant
from tfloom.rmw.errors import WireError
from tfloom.rmw.qos import QoS
from tfloom.rosidl import cdr

Start = Callable[..., Program]
SpinUntil = Callable[..., None]

MANY_TOPICS = 500
MEGABYTE = 2**20


def test_publisher_of_another_type_is_ignored(node: Node, spin_until: SpinUntil) -> None:
    heard: list[object] = []
    subscription = node.create_subscription(String, "chatter", heard.append, 10)
    with Context() as other_context:
        other = Node("other", context=other_context)
        wrong = other.create_publisher(Int32, "chatter", 10)
        right = other.create_publisher(String, "chatter", 10)
        wait_until(lambda: subscription.get_publisher_count() == 1)
        wait_until(lambda: node.count_publishers("chatter") == 2)
        wrong.publish(Int32(data=5))
        right.publish(String(data="right"))
        spin_until(lambda: heard)
        assert heard == [String(data="right")]
        assert wrong.get_subscription_count() == 0
        types = dict(node.get_topic_names_and_types())["/chatter"]
        assert sorted(types) == ["std_msgs/msg/Int32", "std_msgs/msg/String"]
        other.destroy_node()


def test_different_type_hash_is_received_if_decodable(
    node: Node, domain_id: int, spin_until: SpinUntil, capsys: pytest.CaptureFixture[str]
) -> None:
    heard: list[str] = []
    node.create_subscription(String, "chatter", lambda message: heard.append(message.data), 10)
    participant = open_participant(domain_id)
    try:
        participant.add_node(NodeName("/", "newer"))
        topic = Topic("/chatter", "std_msgs/msg/String", "RIHS01_" + "f" * 64)
        writer = participant.create_writer(NodeName("/", "newer"), topic, QoS())
        wait_until(writer.matched_count)
        writer.write(b"\0\1\0\0" + b"\xff" * 12)
        writer.write(cdr.encode(String(data="as before")))
        spin_until(lambda: heard)
        assert heard == ["as before"]
        warning = "Dropped a message of 16 bytes on /chatter that is not a valid std_msgs/msg/String"
        assert warning in capsys.readouterr().err
        spin_until(
            lambda: any(info.node_name == "newer" for info in node.get_publishers_info_by_topic("/chatter"))
        )
        (info,) = node.get_publishers_info_by_topic("/chatter")
        assert str(info.topic_type_hash).endswith("f" * 64)
    finally:
        participant.close()


def test_callback_error_ends_the_program_with_a_traceback_and_leaves_the_graph(
    node: Node, start: Start
) -> None:
    program = start("raising")
    publisher = node.create_publisher(String, "chatter", 10)
    assert node.wait_for_node("/raising", timeout=20)
    wait_until(publisher.get_subscription_count)
    publisher.publish(String(data="this"))
    assert program.wait() == 1
    assert "Traceback (most recent call last):" in program.output
    assert program.lines[-1] == "ValueError: cannot bear this"
    # Well before its lease ends, because it has left the domain.
    wait_until(lambda: "raising" not in node.get_node_names(), timeout_s=8.0)


def test_messages_of_ten_megabytes_arrive_unchanged(node: Node, start: Start, spin_until: SpinUntil) -> None:
    start("echo_image")
    back: list[Image] = []
    qos = QoSProfile(depth=10)
    node.create_subscription(Image, "back", back.append, qos)
    there = node.create_publisher(Image, "there", qos)
    wait_until(lambda: there.get_subscription_count() and node.count_publishers("back"))
    wait_until(lambda: all(subscription.get_publisher_count() for subscription in node.subscriptions))
    for seed in range(2):
        data = random.Random(seed).randbytes(10 * MEGABYTE + seed)
        there.publish(Image(height=seed, data=data))
        spin_until(lambda expected=seed + 1: len(back) == expected, 30.0)
        assert back[seed].height == seed
        assert bytes(back[seed].data) == data


@pytest.mark.slow
def test_five_hundred_topics_in_one_process(node: Node, start: Start) -> None:
    listener = start("many_topics", MANY_TOPICS)
    publishers = [node.create_publisher(String, f"topic_{number}", 10) for number in range(MANY_TOPICS)]
    wait_until(lambda: all(publisher.get_subscription_count() for publisher in publishers), 60.0)
    for number, publisher in enumerate(publishers):
        publisher.publish(String(data=str(number)))
    listener.wait_for("heard all")
    assert publishers[-1].wait_for_all_acked(Duration(seconds=20))
    wait_until(lambda: node.count_subscribers("topic_499") == 1)
    names = [name for name, _ in node.get_topic_names_and_types() if name.startswith("/topic_")]
    assert len(names) == MANY_TOPICS


def test_full_domain_gives_one_error_message(
    domain_id: int, monkeypatch: pytest.MonkeyPatch, start_program: Callable[..., Program], tmp_path: Path
) -> None:
    from tfloom.rmw.cyclone.config import configuration

    text = configuration()
    limit = "<MaxAutoParticipantIndex>"
    start, rest = text.split(limit)
    full = start + limit + "1" + rest[rest.index("<") :]
    monkeypatch.setenv("CYCLONEDDS_URI", full)
    first = Context()
    first.init([], domain_id=domain_id)
    try:
        assert Node("first", context=first).get_name() == "first"
        second = start_program("tfloom", "topic", "list")
        assert second.wait() == 1
        assert "Traceback" not in second.output
        assert "check CYCLONEDDS_URI" in second.lines[-1]
    finally:
        first.destroy()


def test_reliable_writer_waits_for_a_slow_subscription(node: Node, spin_until: SpinUntil) -> None:
    all_of_them = QoSProfile(history=HistoryPolicy.KEEP_ALL)
    heard: list[int] = []
    node.create_subscription(Int32, "numbers", lambda message: heard.append(message.data), all_of_them)
    with Context() as other_context:
        other = Node("other", context=other_context)
        publisher = other.create_publisher(Int32, "numbers", all_of_them)
        wait_until(publisher.get_subscription_count)
        for number in range(5000):
            publisher.publish(Int32(data=number))
        spin_until(lambda: len(heard) == 5000)
        assert heard == list(range(5000))
        other.destroy_node()


def test_closed_wire_gives_an_error_message(node: Node, context: Context) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    publisher._endpoint.close()
    with pytest.raises(WireError, match="cannot write to /chatter"):
        publisher.publish(String())
