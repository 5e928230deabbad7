"""launch_testing_ros: waits for topics, a spinning thread, republished messages; no wire leaves the process."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.conftest import wait_until
from tests.launch.testing.conftest import run_pytest

from tfloom.interfaces.std_msgs.msg import String
from tfloom.launch.testing.ros.output import basic_output_filter, get_rmw_output_filter
from tfloom.launch.testing.ros.topics import DataRepublisher, MessagePump, WaitForTopics
from tfloom.node.node import Node


@pytest.fixture
def pumped(node: Node) -> Iterator[Node]:
    """Return a node that is spun all the time, on the domain of ROS_DOMAIN_ID, as WaitForTopics."""
    pump = MessagePump(node)
    pump.start()
    yield node
    pump.stop()


def publish_always(node: Node, topic: str) -> None:
    publisher = node.create_publisher(String, topic, 10)
    node.create_timer(0.01, lambda: publisher.publish(String(data=topic)))


def test_messages_on_all_topics_end_the_wait(pumped: Node) -> None:
    for topic in ("one", "two"):
        publish_always(pumped, topic)
    with WaitForTopics(
        [("one", String), ("two", String)], timeout=60, messages_received_buffer_length=3
    ) as topics:
        assert topics.topics_received() == {"one", "two"}
        assert topics.topics_not_received() == set()
        wait_until(lambda: len(topics.received_messages("two")) == 3)
        assert {message.data for message in topics.received_messages("two")} == {"two"}
        with pytest.raises(KeyError, match="No topic 'three' is waited for; those are: one, two"):
            topics.received_messages("three")


def test_topic_without_messages_is_named(pumped: Node) -> None:
    publish_always(pumped, "one")
    text = "Did not receive messages on these topics: two$"
    with (
        pytest.raises(RuntimeError, match=text),
        WaitForTopics([("one", String), ("two", String)], timeout=1),
    ):
        pytest.fail("the block was entered")


def test_trigger_starts_what_publishes(pumped: Node) -> None:
    del pumped
    heard: list[object] = []

    def trigger(node: Node, word: str) -> None:
        assert node.get_namespace() == "/there"
        heard.append(word)
        publish_always(node, "one")

    topics = WaitForTopics(
        [("one", String)], timeout=60, trigger=trigger, node_namespace="there", qos_profile=5
    )
    try:
        assert topics.wait("go")
        assert heard == ["go"]
    finally:
        topics.shutdown()
        topics.shutdown()
    with pytest.raises(TypeError, match="trigger must be a function"):
        WaitForTopics([], trigger=7)  # type: ignore[arg-type]


def test_messages_are_republished(pumped: Node, make_node: Callable[..., Node]) -> None:
    del make_node

    def transform(message: String) -> String | None:
        return None if message.data == "drop" else String(data=message.data.upper())

    republisher = DataRepublisher(pumped, "small", "large", String, transform)
    large: list[str] = []
    pumped.create_subscription(String, "large", lambda message: large.append(message.data), 10)
    publisher = pumped.create_publisher(String, "small", 10)
    wait_until(lambda: publisher.get_subscription_count() == 1)
    for text in ("red", "drop", "blue"):
        publisher.publish(String(data=text))
    wait_until(lambda: large == ["RED", "BLUE"])
    assert republisher.get_num_received() == 3
    assert republisher.get_num_republished() == 2
    assert [message.data for message in republisher.get_republished()] == ["RED", "BLUE"]
    republisher.shutdown()
    wait_until(lambda: publisher.get_subscription_count() == 0)


def test_lines_of_a_wire_are_left_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    index = tmp_path / "share" / "ament_index" / "resource_index"
    for kind, text in (("prefixes", "[wire]\n"), ("patterns", ".*noise.*\n")):
        folder = index / f"rmw_output_{kind}"
        folder.mkdir(parents=True)
        (folder / "rmw_wire").write_text(text)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    assert get_rmw_output_filter("rmw_wire", "prefixes") == ["[wire]"]
    assert get_rmw_output_filter("rmw_other", "prefixes") == []
    keep = basic_output_filter(filtered_rmw_implementation="rmw_wire")
    assert keep("[wire] x\nsome noise\npid 7\nhello\n") == "hello\n"
    assert basic_output_filter()("[wire] x\n") == "[wire] x\n"


TALKER = """\
import unittest

import launch
import launch_ros.actions
import launch_testing
import launch_testing.actions
import launch_testing_ros
import pytest
from std_msgs.msg import String


@pytest.mark.rostest
def generate_test_description():
    talker = launch_ros.actions.Node(
        package="demo_nodes_py", executable="talker", namespace="there", remappings=[("chatter", "said")]
    )
    return launch.LaunchDescription([talker, launch_testing.actions.ReadyToTest()]), {"talker": talker}


class TestTalker(unittest.TestCase):
    def test_topic(self, proc_output, talker):
        with launch_testing_ros.WaitForTopics([("/there/said", String)], timeout=60) as topics:
            assert "Hello World" in topics.received_messages("/there/said")[0].data
        proc_output.assertWaitFor("Publishing", process=talker, timeout=60)


@launch_testing.post_shutdown_test()
class TestEnd(unittest.TestCase):
    def test_exit_code(self, proc_info, talker):
        launch_testing.asserts.assertExitCodes(proc_info, process=talker)
"""


def test_topic_of_a_launched_node(domain_id: int, tmp_path: Path) -> None:
    run = run_pytest(tmp_path, {"test_talker.py": TALKER}, ROS_DOMAIN_ID=str(domain_id))
    assert run.code == 0, run.output
    assert run.outcome("test_talker::test_talker") == "passed"
