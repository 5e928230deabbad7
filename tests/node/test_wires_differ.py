"""What nodes are told otherwise on Zenoh, as beside rmw_zenoh: who is matched, numbers of messages, the depth."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.executing.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import qos_profile_sensor_data, qos_profile_system_default


@pytest.fixture
def node(context_on_each_wire: Context) -> Iterator[Node]:
    node = Node("tester", context=context_on_each_wire)
    yield node
    node.destroy_node()


@pytest.fixture
def is_zenoh(node: Node) -> bool:
    return os.environ["RMW_IMPLEMENTATION"] == "rmw_zenoh_cpp"


@pytest.fixture
def spin_until(
    node: Node, context_on_each_wire: Context, wait_until: Callable[..., None]
) -> Iterator[Callable[..., None]]:
    with SingleThreadedExecutor(context=context_on_each_wire) as executor:
        executor.add_node(node)

        def spin_until(is_done: Callable[[], object]) -> None:
            wait_until(lambda: executor.spin_once(0.01) or is_done())

        yield spin_until


def test_depth_of_the_system_default_is_the_wires(
    node: Node, is_zenoh: bool, wait_until: Callable[..., None]
) -> None:
    node.create_publisher(String, "chatter", qos_profile_system_default)
    node.create_subscription(String, "chatter", print, qos_profile_system_default)
    wait_until(lambda: node.count_publishers("chatter") and node.count_subscribers("chatter"))
    (writer,) = node.get_publishers_info_by_topic("chatter")
    (reader,) = node.get_subscriptions_info_by_topic("chatter")
    if os.environ["RMW_IMPLEMENTATION"] != "rmw_cyclonedds_cpp":  # DDS doesn't tell the depth of others
        assert writer.qos_profile.depth == reader.qos_profile.depth == (42 if is_zenoh else 1)


def test_messages_have_numbers_on_zenoh(node: Node, is_zenoh: bool, spin_until: Callable[..., None]) -> None:
    told: list[dict[str, Any]] = []
    node.create_subscription(String, "chatter", lambda _, info: told.append(info), 10)
    publisher = node.create_publisher(String, "chatter", 10)
    spin_until(publisher.get_subscription_count)
    for _ in range(3):
        publisher.publish(String())
    spin_until(lambda: len(told) == 3)
    numbers = [(info["publication_sequence_number"], info["reception_sequence_number"]) for info in told]
    assert numbers == ([(1, 0), (2, 1), (3, 2)] if is_zenoh else 3 * [(None, None)])


def test_incompatible_peers_are_told_and_matched_on_zenoh(
    node: Node, is_zenoh: bool, spin_until: Callable[..., None], capsys: pytest.CaptureFixture[str]
) -> None:
    matched: list[int] = []
    got: list[String] = []
    publisher = node.create_publisher(
        String,
        "chatter",
        qos_profile_sensor_data,
        event_callbacks=PublisherEventCallbacks(matched=lambda status: matched.append(status.current_count)),
    )
    callbacks = SubscriptionEventCallbacks(matched=lambda status: matched.append(-status.current_count))
    node.create_subscription(String, "chatter", got.append, 10, event_callbacks=callbacks)
    text = ""

    def both_warn() -> bool:
        nonlocal text
        text += capsys.readouterr().err
        return text.count("Last incompatible policy: RELIABILITY") == 2

    spin_until(both_warn)
    assert ("Messages pass all the same" in text) == is_zenoh
    assert publisher.get_subscription_count() == int(is_zenoh)
    if is_zenoh:
        spin_until(lambda: sorted(matched) == [-1, 1])
        publisher.publish(String())
        spin_until(lambda: got)
    else:
        assert not matched
