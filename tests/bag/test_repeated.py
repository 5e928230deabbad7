"""Messages that further files and snapshots begin with, topics that are recorded from the start, and lost messages."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from tests.bag.written_bags import CHATTER, START_NS, STEP_NS, raising, text, topic
from tests.cli.transcript import run_here
from tests.conftest import wait_until

from tfloom.bag import open_bag
from tfloom.bag.errors import BagError
from tfloom.bag.recording import recorder as recorder_module
from tfloom.bag.recording.recorded_topics import RecordOptions
from tfloom.bag.recording.recorder import Recorder
from tfloom.bag.topic_choice import TopicChoice, read_static_topics
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.interfaces.rosbag2_interfaces.msg import MessagesLostEvent
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile

LATCHED = QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL)
SEEN = Callable[[Path], list[list[tuple[int, str]]]]


def files_of(folder: Path) -> list[list[tuple[str, str, int]]]:
    """Return topics, texts and log times of each file [steps after the start]."""
    with open_bag(folder) as bag:
        return [
            [
                (found.topic, _text(found.data), (found.log_time_ns - START_NS) // STEP_NS)
                for found in file.messages(None, 0, 2**62)
            ]
            for file in bag.files
        ]


def _text(data: bytes) -> str:
    return data[8:].rstrip(b"\0").decode().removeprefix("message ")


@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
@pytest.mark.parametrize("compression_mode", ["", "MESSAGE"])
def test_further_files_begin_with_the_last_messages(
    storage_id: str, compression_mode: str, tmp_path: Path
) -> None:
    writer = BagWriter(tmp_path / "bag", WriterSettings(storage_id, compression_mode=compression_mode))
    map_, chatter = writer.add_topic(topic("/map", "std_msgs/msg/String")), writer.add_topic(CHATTER)
    writer.repeat(map_, 2)
    for number in range(3):
        writer.push(map_, text(number), START_NS + number * STEP_NS, START_NS + number * STEP_NS)
    for number in (10, 20):
        writer.write_rest()
        writer.split()
        writer.push(chatter, text(number), START_NS + number * STEP_NS, START_NS + number * STEP_NS)
    writer.write_rest()
    writer.split()  # a file without a message of its own has none of others either
    assert writer.message_count == 9
    writer.close()
    assert files_of(tmp_path / "bag") == [
        [("/map", "0", 0), ("/map", "1", 1), ("/map", "2", 2)],
        [("/map", "1", 10), ("/map", "2", 10), ("/chatter", "10", 10)],
        [("/map", "1", 20), ("/map", "2", 20), ("/chatter", "20", 20)],
        [],
    ]
    with open_bag(tmp_path / "bag") as bag:
        assert bag.topics["/map"].message_count == 7


def test_repeated_messages_keep_the_time_of_their_publication(tmp_path: Path) -> None:
    writer = BagWriter(tmp_path / "bag")
    channel = writer.add_topic(CHATTER)
    writer.repeat(channel, 1)
    writer.push(channel, text(0), START_NS, START_NS - 5)
    writer.write_rest()
    writer.split()
    writer.push(channel, text(1), START_NS + 100, START_NS + 90)
    writer.close()
    with open_bag(tmp_path / "bag") as bag:
        times = [(found.log_time_ns - START_NS, found.publish_time_ns - START_NS) for found in bag.messages()]
    assert times == [(0, -5), (100, -5), (100, 90)]


@contextmanager
def recording(
    folder: Path, context: Context, choice: TopicChoice, settings: WriterSettings, **options: Any
) -> Iterator[Recorder]:
    asked = RecordOptions(choice, polling_interval_s=0.01, has_keyboard=False, **options)
    recorder = Recorder(folder, settings, asked, context=context)
    recorder.start()
    try:
        yield recorder
    finally:
        recorder.stop()
        recorder.destroy_node()


def texts(folder: Path) -> list[tuple[str, str]]:
    with open_bag(folder) as bag:
        return [(found.topic, _text(found.data)) for found in bag.messages()]


def test_all_transient_local_topics_are_repeated(local_context: Context, tmp_path: Path) -> None:
    node = Node("talker", context=local_context)
    kept, other = node.create_publisher(String, "map", LATCHED), node.create_publisher(String, "chatter", 10)
    named = node.create_publisher(String, "named", LATCHED)
    everything = TopicChoice(["/map", "/chatter", "/named"])
    with recording(
        tmp_path / "bag", local_context, everything, WriterSettings(), repeats_all=1, repeated={"/named": 2}
    ) as recorder:
        for publisher in (kept, other, named):
            for number in range(3):
                publisher.publish(String(data=f"{number}"))
        wait_until(lambda: recorder.writer.queue.message_count == 9)
        recorder.split_bagfile()
        other.publish(String(data="last"))
        wait_until(lambda: recorder.writer.queue.message_count == 10)
    with open_bag(tmp_path / "bag") as bag:
        found = [(found.topic, _text(found.data)) for found in bag.files[1].messages(None, 0, 2**62)]
    assert sorted(found) == [("/chatter", "last"), ("/map", "2"), ("/named", "1"), ("/named", "2")]


def test_snapshot_begins_with_what_the_ring_has_lost(local_context: Context, tmp_path: Path) -> None:
    node = Node("talker", context=local_context)
    kept, other = node.create_publisher(String, "map", LATCHED), node.create_publisher(String, "chatter", 10)
    settings = WriterSettings(cache_size=4000, is_snapshot=True)
    choice = TopicChoice(["/map", "/chatter"])
    with recording(tmp_path / "bag", local_context, choice, settings, repeats_all=1) as recorder:
        for number in range(3):
            kept.publish(String(data=f"{number}"))
        for number in range(500):
            other.publish(String(data=f"{number}"))
        kept.publish(String(data="new"))
        assert recorder.take_snapshot()
        found = recorder.writer.message_count
        other.publish(String(data="of the second snapshot"))
        assert recorder.take_snapshot()
        assert recorder.writer.message_count == found + 2
    seen = texts(tmp_path / "bag")
    assert [entry for entry in seen if entry[0] == "/map"] == [
        ("/map", "2"),
        ("/map", "new"),
        ("/map", "new"),
    ]
    assert seen[0] == ("/map", "2")
    assert ("/chatter", "0") not in seen
    assert seen[-1] == ("/chatter", "of the second snapshot")


def test_repeated_topic_is_paused_with_the_others(local_context: Context, tmp_path: Path) -> None:
    node = Node("talker", context=local_context)
    kept = node.create_publisher(String, "map", LATCHED)
    settings = WriterSettings(is_snapshot=True)
    with recording(
        tmp_path / "bag", local_context, TopicChoice(["/map"]), settings, repeats_all=1, is_start_paused=True
    ) as recorder:
        kept.publish(String(data="lost"))
        recorder.resume()
        kept.publish(String(data="a"))
        recorder.pause()
        kept.publish(String(data="lost"))
        assert recorder.take_snapshot()
    assert texts(tmp_path / "bag") == [("/map", "a")]


def test_snapshot_goes_back_for_a_time(tmp_path: Path) -> None:
    settings = WriterSettings(is_snapshot=True, snapshot_duration_ns=10 * STEP_NS)
    writer = BagWriter(tmp_path / "bag", settings)
    channel = writer.add_topic(CHATTER)
    for number in range(30):
        writer.push(channel, text(number), START_NS + number * STEP_NS, START_NS)
    writer.write_present()
    writer.close()
    assert [place for *_, place in files_of(tmp_path / "bag")[0]] == list(range(19, 30))
    with pytest.raises(BagError, match="can't be negative"):
        BagWriter(tmp_path / "other", settings._replace(snapshot_duration_ns=-1))


def test_snapshot_that_cannot_be_written_is_tried_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer = BagWriter(tmp_path / "bag", WriterSettings(is_snapshot=True, cache_size=800))
    channel = writer.add_topic(CHATTER)
    for number in range(8):
        writer.push(channel, text(number), START_NS + number * STEP_NS, START_NS)
    with monkeypatch.context() as patched:
        patched.setattr(writer._file, "write", raising(OSError(28, "No space left on device")))
        with pytest.raises(BagError, match="No space"):
            writer.write_present()
    writer.close()
    assert [place for *_, place in files_of(tmp_path / "bag")[0]] == list(range(8))


def test_static_topics_are_recorded_from_their_first_message(local_context: Context, tmp_path: Path) -> None:
    listed = tmp_path / "topics.yaml"
    listed.write_text(
        "static_topics_and_types_list: [[/words, std_msgs/msg/String], [odd, std_msgs/msg/Empty]]"
    )
    topics = read_static_topics(listed)
    assert topics == {"/words": "std_msgs/msg/String", "/odd": "std_msgs/msg/Empty"}
    node = Node("talker", context=local_context)
    other = node.create_publisher(String, "odd", 10)
    with recording(
        tmp_path / "bag", local_context, TopicChoice(), WriterSettings(), static_topics=topics
    ) as recorder:
        wait_until(lambda: not recorder.is_discovery_running)  # nothing else is wanted
        publisher = node.create_publisher(String, "words", 10)
        publisher.publish(String(data="first"))
        other.publish(String(data="of another type"))
    assert texts(tmp_path / "bag") == [("/words", "first")]
    with open_bag(tmp_path / "bag") as bag:
        assert bag.topics["/odd"].type == "std_msgs/msg/Empty"


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("[", "it isn't YAML"),
        ("[1]", "must have 'static_topics_and_types_list: "),
        ("static_topics_and_types_list: {a: b}", "must have"),
        ("static_topics_and_types_list: [[/a]]", r"a topic and its type, not \['/a'\]"),
        ("static_topics_and_types_list: [[/a, 1]]", "a topic and its type"),
        ("static_topics_and_types_list: [[/a, '']]", "the type of '/a' must be as package/msg/Type, not ''"),
        (
            "static_topics_and_types_list: [[/a, x/msg/A], [a, x/msg/B]]",
            "'/a' has two types: x/msg/A and x/msg/B",
        ),
    ],
)
def test_files_of_static_topics_that_cannot_be_used(content: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "topics.yaml").write_text(content)
    with pytest.raises(BagError, match=said):
        read_static_topics(tmp_path / "topics.yaml")


def test_a_missing_file_of_static_topics(tmp_path: Path) -> None:
    with pytest.raises(BagError, match="can't be read: No such file"):
        read_static_topics(tmp_path / "none.yaml")


def test_lost_messages_are_announced(
    local_context: Context, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What the wire and the full cache lose is published once, and the rest when the recording stops."""
    monkeypatch.setattr(recorder_module, "FLUSH_NS", 3_600_000_000_000)
    node = Node("talker", context=local_context)
    publishers = [node.create_publisher(String, name, 10) for name in ("chatter", "other")]
    seen: list[dict[str, tuple[int, int]]] = []

    def hear(event: MessagesLostEvent) -> None:
        assert event.node_name == "/rosbag2_recorder"
        seen.append(
            {
                entry.topic_name: (entry.messages_lost_in_transport, entry.messages_lost_in_recorder)
                for entry in event.messages_lost_statistics
            }
        )

    node.create_subscription(MessagesLostEvent, "/events/rosbag2_messages_lost", hear, 10)
    choice, settings = TopicChoice(["/chatter", "/other"]), WriterSettings(cache_size=200)
    with (
        SingleThreadedExecutor(context=local_context) as executor,
        recording(tmp_path / "bag", local_context, choice, settings, losses_hz=100.0) as recorder,
    ):
        executor.add_node(node)
        executor.add_node(recorder)

        def spin_until(count: int) -> None:
            end = time.monotonic() + 10.0
            while len(seen) < count:
                assert time.monotonic() < end
                executor.spin_once(0.01)

        monkeypatch.setattr(recorder.writer, "write_chunk", lambda _: None)
        recorder._lock.acquire()  # nothing is written: what exceeds the cache is lost
        try:
            for _ in range(20):
                publishers[0].publish(String(data="x" * 100))
            recorded = recorder._topics._recorded["/other"]
            monkeypatch.setattr(recorded, "count_lost", lambda: 4)
            spin_until(1)
            dropped = recorder.writer.queue.dropped_count
            assert dropped > 10
            assert seen == [{"/chatter": (0, dropped), "/other": (4, 0)}]
            for _ in range(5):
                executor.spin_once(0.02)
            assert len(seen) == 1
            publishers[0].publish(String(data="x" * 100))
            executor.remove_node(recorder)
        finally:
            recorder._lock.release()
        recorder.stop()
        spin_until(2)
    assert seen[1] == {"/chatter": (0, 1)}


def test_without_a_rate_there_is_no_topic_of_losses(local_context: Context, tmp_path: Path) -> None:
    with recording(tmp_path / "bag", local_context, TopicChoice(["/a"]), WriterSettings()) as recorder:
        names = [name for name, _ in recorder.get_topic_names_and_types()]
        assert "/events/rosbag2_messages_lost" not in names
        assert "/events/write_split" in names


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["-a", "--max-cache-duration", "5"], "--max-cache-duration needs --snapshot-mode"),
        (["-a", "--repeat-transient-local", "/map=0"], "needs Topic or Topic=Depth, not '/map=0'"),
        (["-a", "--repeat-transient-local", "=3"], "needs Topic or Topic=Depth, not '=3'"),
    ],
)
def test_flags_that_cannot_be_used(arguments: list[str], said: str, tmp_path: Path) -> None:
    result = run_here("bag", "record", "-o", str(tmp_path / "bag"), *arguments)
    assert result.exit_code == 1
    assert said in result.text
    assert not (tmp_path / "bag").exists()
