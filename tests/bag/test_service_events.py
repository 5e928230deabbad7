"""Services in bags: their events are recorded, and their requests are sent again."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from rosbags.highlevel import AnyReader
from tests.bag.written_bags import topic

from tfloom.bag import open_bag
from tfloom.bag.playing.play_options import PlayOptions
from tfloom.bag.playing.player import Player
from tfloom.bag.recording.recorded_topics import RecordOptions
from tfloom.bag.recording.recorder import Recorder
from tfloom.bag.topic_choice import TopicChoice
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import qos_profile_system_default
from tfloom.rosidl import cdr


def test_requests_are_recorded_and_sent_again(local_context: Context, tmp_path: Path) -> None:
    node = Node("adder", context=local_context)
    sums: list[int] = []

    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        sums.append(response.sum)
        return response

    service = node.create_service(AddTwoInts, "add", add)
    service.configure_introspection(
        node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS
    )
    client = node.create_client(AddTwoInts, "add")
    with SingleThreadedExecutor(context=local_context) as executor:
        executor.add_node(node)
        options = RecordOptions(TopicChoice(services=["/add"]), has_keyboard=False)
        recorder = Recorder(tmp_path / "bag", WriterSettings(), options, context=local_context)
        recorder.start()
        for number in range(5):
            executor.spin_until_future_complete(client.call_async(AddTwoInts.Request(a=number, b=10)), 5.0)
        recorder.stop()
        recorder.destroy_node()
        assert sums == [10, 11, 12, 13, 14]

        def spin_until(condition: Callable[[], bool]) -> None:
            end = time.monotonic() + 10.0
            while not condition():
                assert time.monotonic() < end, sums
                executor.spin_once(0.02)

        with open_bag(tmp_path / "bag") as bag:
            assert bag.topics.keys() == {"/add/_service_event"}
            assert bag.message_count == 10
            for options_, expected in (
                (PlayOptions(publishes_requests=True), [10, 11, 12, 13, 14]),
                (PlayOptions(publishes_requests=True, is_client_source=True), []),
                (PlayOptions(), []),
            ):
                sums.clear()
                options_.has_keyboard = False
                player = Player(bag, options_, context=local_context)
                player.start()
                spin_until(player.ended.is_set)
                spin_until(lambda: len(sums) >= len(expected))  # noqa: B023
                player.stop()
                player.destroy_node()
                assert sums == expected


ACTION_TOPICS = [
    *(f"/fibonacci/_action/{part}" for part in ("feedback", "status")),
    *(f"/fibonacci/_action/{part}/_service_event" for part in ("send_goal", "cancel_goal", "get_result")),
]


def test_an_action_is_its_topics_and_the_events_of_its_services() -> None:
    named = TopicChoice(actions=["/fibonacci"])
    assert all(named.wants(topic, "any_Event") for topic in ACTION_TOPICS)
    assert not named.wants("/fibonacci", "std_msgs/msg/String")
    assert not named.wants("/other/_action/feedback", "any")
    assert not named.is_by_name_only
    everything = TopicChoice(
        all_topics=True, all_services=True, all_actions=True, exclude_actions=["/fibonacci"]
    )
    assert not any(everything.wants(topic, "any_Event") for topic in ACTION_TOPICS)
    assert everything.wants("/other/_action/status", "any")
    assert not TopicChoice(all_actions=True, exclude_regex="fib").wants(ACTION_TOPICS[0], "any")
    # Those of a service of an action may be wanted as such, too.
    assert TopicChoice(services=["/fibonacci/_action/send_goal"]).wants(ACTION_TOPICS[2], "any_Event")
    assert not TopicChoice(services=["/fibonacci/_action/send_goal"]).wants(ACTION_TOPICS[0], "any")


def test_a_named_action_is_recorded_although_its_topics_are_hidden(
    local_context: Context, tmp_path: Path
) -> None:
    node = Node("server", context=local_context)
    publishers = [node.create_publisher(String, topic, 10) for topic in (*ACTION_TOPICS[:2], "/other")]
    options = RecordOptions(TopicChoice(actions=["/fibonacci"]), has_keyboard=False)
    recorder = Recorder(tmp_path / "bag", WriterSettings(), options, context=local_context)
    recorder.start()
    for publisher in publishers:
        publisher.publish(String(data="x"))
    recorder.stop()
    recorder.destroy_node()
    with open_bag(tmp_path / "bag") as bag:
        assert sorted(bag.topics) == ACTION_TOPICS[:2]
        assert bag.message_count == 2


@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
def test_feedback_is_read_by_another_reader(storage_id: str, tmp_path: Path) -> None:
    feedback = Fibonacci.Impl.FeedbackMessage
    message = feedback(feedback=Fibonacci.Feedback(sequence=[1, 2]))
    writer = BagWriter(tmp_path / "bag", WriterSettings(storage_id=storage_id))
    writer.push(writer.add_topic(topic(ACTION_TOPICS[0], feedback._TYPE_NAME)), cdr.encode(message), 1, 1)
    writer.close()
    with AnyReader([tmp_path / "bag"]) as reader:
        ((connection, _, data),) = reader.messages()
        read: Any = reader.deserialize(data, connection.msgtype)
    assert read.feedback.sequence.tolist() == [1, 2]
    with open_bag(tmp_path / "bag") as bag:
        ((_, ours),) = bag.read(ACTION_TOPICS[0])
    assert ours == message
