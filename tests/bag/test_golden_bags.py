"""Recordings that rosbag2 of ROS 2 Jazzy made."""

from __future__ import annotations

from pathlib import Path

import pytest
from rosbags.highlevel import AnyReader
from tests.bag.recordings import found_in

from tfloom.bag import frames, open_bag

GOLDEN = Path(__file__).parents[1] / "golden" / "bags"
COUNTS = {
    "mcap": {"/chatter": 16, "/tf_static": 1, "/turtle1/pose": 859},
    "sqlite3": {"/chatter": 16, "/tf_static": 1, "/turtle1/pose": 859},
    "split": {"/turtle1/pose": 1521},
    "zstd_file": {"/chatter": 13},
}


@pytest.mark.parametrize("name", COUNTS)
def test_messages_are_those_that_rosbags_reads(name: str) -> None:
    with AnyReader([GOLDEN / name]) as reader:
        theirs = [(connection.topic, stamp, bytes(data)) for connection, stamp, data in reader.messages()]
    with open_bag(GOLDEN / name) as bag:
        ours = found_in(bag)
        assert {topic.name: topic.message_count for topic in bag.topics.values()} == COUNTS[name]
        assert bag.message_count == len(ours) == sum(COUNTS[name].values())
        assert (bag.start_ns, bag.end_ns) == (ours[0][1], ours[-1][1])
    assert sorted(ours) == sorted(theirs)
    assert [row[1] for row in ours] == sorted(row[1] for row in ours)


@pytest.mark.parametrize("name", ["mcap", "sqlite3"])
def test_static_frames_are_read(name: str) -> None:
    buffer = frames(GOLDEN / name)
    (edge,) = buffer.edges()
    assert (edge.frame_id, edge.child_frame_id, edge.is_static) == ("world", "camera", True)
    assert edge.authority == "/tf_static"


def test_messages_of_one_topic_and_time() -> None:
    with open_bag(GOLDEN / "split") as bag:
        all_of_it = list(bag.messages())
        middle = all_of_it[500:700]
        start, end = middle[0].log_time_ns, middle[-1].log_time_ns
        assert list(bag.messages("/turtle1/pose", start, end)) == middle


def test_messages_are_decoded_by_the_classes_of_tfloom() -> None:
    with open_bag(GOLDEN / "mcap") as bag:
        texts = [message.data for _, message in bag.read("/chatter")]
        assert texts[0] == "Hello World: 5"
        (definition,) = {bag.topics["/chatter"].definition}
        assert definition is not None
        assert (definition.encoding, definition.text.strip().endswith("string data")) == ("ros2msg", True)
