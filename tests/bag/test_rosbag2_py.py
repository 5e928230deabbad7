"""rosbag2_py as programs use it, and its names as they were recorded."""

from __future__ import annotations

import inspect
import json
import re
import threading
import time
from enum import IntEnum
from pathlib import Path
from typing import Any

import pytest
import rosbag2_py
from rclpy.duration import Duration
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.time import Time
from rosidl_runtime_py.utilities import get_message
from std_msgs.msg import String
from tests.bag.written_bags import read_by_rosbags
from tests.conftest import wait_until

from tfloom.node.context.context import Context
from tfloom.node.context.utilities import get_default_context

BAGS = Path(__file__).parents[1] / "golden" / "bags"
API: dict[str, Any] = json.loads((BAGS.parent / "rosbag2_py_api.json").read_text("utf-8"))
CDR = rosbag2_py.ConverterOptions("cdr", "cdr")


def parameters(signature: str) -> list[str]:
    """Return the names in a recorded signature."""
    inside = signature[signature.index("(") + 1 : signature.rindex(")")]
    flat = re.sub(r"<[^<>]*>|\[[^\[\]]*\]|\([^()]*\)", "", re.sub(r"\[[^\[\]]*\]", "", inside))
    return [name for part in flat.split(",") if (name := part.partition(":")[0].strip())]


LATER = {
    "StorageFilter": ["actions", "exclude_actions"],
    "StorageOptions": ["max_bag_files", "max_cache_duration"],
}
"""Parameters that Kilted and Lyrical have after those of Jazzy."""


def test_names_and_parameters_are_the_recorded_ones() -> None:
    wrong = []
    for name, members in API.items():
        found = getattr(rosbag2_py, name)
        if isinstance(members, str):
            continue
        for member, text in members.items():
            if member == "__init__":
                expected = parameters(text)
                if expected and "*args" not in text and not text.count("value: int"):
                    ours = list(inspect.signature(found.__init__).parameters)
                    expected += LATER.get(name, [])
                    wrong += (
                        [(name, ours, expected)]
                        if ours not in (expected, [*expected, "args", "kwargs"])
                        else []
                    )
            elif text == "property":
                holder = found("") if name == "StorageOptions" else found
                names = {*dir(holder), *getattr(found, "__dataclass_fields__", {})}
                if member not in names and not hasattr(instance_of(found), member):
                    wrong.append((name, member))
            elif not hasattr(found, member) and not hasattr(instance_of(found), member):
                wrong.append((name, member))
    assert wrong == []


def instance_of(cls: Any) -> Any:
    if issubclass(cls, IntEnum):
        return cls(0)
    if cls is rosbag2_py.TopicMetadata:
        return cls(0, "/a", "std_msgs/msg/String", "cdr")
    try:
        return cls()
    except TypeError:
        return None


def write(uri: Path, writer: Any = None, **options: Any) -> list[tuple[str, int, bytes]]:
    """Write a bag as in the tutorial."""
    writer = writer or rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(uri=str(uri), **options), rosbag2_py.ConverterOptions("", ""))
    for name in ("/chatter", "/other"):
        writer.create_topic(
            rosbag2_py.TopicMetadata(id=0, name=name, type="std_msgs/msg/String", serialization_format="cdr")
        )
    rows = []
    for number in range(20):
        name = "/other" if number % 5 == 0 else "/chatter"
        rows.append((name, 1000 + number, serialize_message(String(data=f"{number}"))))
        writer.write(name, rows[-1][2], rows[-1][1])
    return rows


@pytest.mark.parametrize("storage_id", ["", "mcap", "sqlite3"])
def test_bag_of_the_tutorial(storage_id: str, tmp_path: Path) -> None:
    rows = write(tmp_path / "bag", storage_id=storage_id)  # the writer is freed, which completes the bag
    assert read_by_rosbags(tmp_path / "bag") == rows
    reader = rosbag2_py.SequentialReader()
    reader.open(rosbag2_py.StorageOptions(uri=str(tmp_path / "bag"), storage_id=storage_id), CDR)
    types = {topic.name: topic.type for topic in reader.get_all_topics_and_types()}
    found = []
    while reader.has_next():
        topic, data, stamp = reader.read_next()
        assert deserialize_message(data, get_message(types[topic])).data == str(stamp - 1000)
        found.append((topic, stamp, data))
    assert found == rows
    with pytest.raises(RuntimeError, match="no more messages"):
        reader.read_next()


def stamps(reader: Any) -> list[int]:
    found = []
    while reader.has_next():
        found.append(reader.read_next()[2] - 1000)
    return found


def test_filters_seeks_and_orders(tmp_path: Path) -> None:
    write(tmp_path / "bag")
    reader = rosbag2_py.SequentialCompressionReader()
    reader.open_uri(str(tmp_path / "bag"))
    reader.set_filter(rosbag2_py.StorageFilter(topics=["/other"]))
    assert stamps(reader) == [0, 5, 10, 15]
    reader.seek(1008)
    assert stamps(reader) == [10, 15]
    reader.reset_filter()
    reader.seek(1017)
    assert stamps(reader) == [17, 18, 19]
    reader.set_filter(rosbag2_py.StorageFilter(regex="cha", exclude_topics=["/x"], regex_to_exclude="z"))
    reader.seek(1013)
    assert reader.read_next()[2] == 1013
    reader.set_filter(rosbag2_py.StorageFilter(topics=["/other"]))
    assert stamps(reader) == [15]
    reader.reset_filter()
    reader.seek(1018)
    assert reader.set_read_order(rosbag2_py.ReadOrder(reverse=True))
    assert stamps(reader) == list(range(18, -1, -1))
    assert not reader.set_read_order(rosbag2_py.ReadOrder(rosbag2_py.ReadOrderSortBy.File))
    options = rosbag2_py.StorageOptions(str(tmp_path / "bag"), start_time_ns=1003, end_time_ns=1005)
    reader.open(options, CDR)
    assert reader.set_read_order(rosbag2_py.ReadOrder())
    assert stamps(reader) == [3, 4, 5]


def write_of_one_time(folder: Path) -> None:
    """Write messages on three topics, several of them at one time, two of them equal."""
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(folder), "mcap"), CDR)
    for name in ("/a", "/b", "/c"):
        writer.create_topic(rosbag2_py.TopicMetadata(0, name, "std_msgs/msg/String", "cdr"))
    for name, text, stamp in [("/b", "0", 1), ("/a", "1", 5), ("/b", "2", 5), ("/a", "3", 5), ("/a", "3", 5)]:
        writer.write(name, serialize_message(String(data=text)), stamp)
    for name, text, stamp in [("/c", "4", 5), ("/b", "5", 6), ("/a", "6", 9)]:
        writer.write(name, serialize_message(String(data=text)), stamp)
    writer.close()


def texts(reader: Any, most: int = 99) -> str:
    found = ""
    while len(found) < most and reader.has_next():
        found += deserialize_message(reader.read_next()[1], String).data
    return found


@pytest.mark.parametrize(("read", "rest"), [(0, "01233456"), (1, "233456"), (2, "3456"), (3, "456"), (4, "")])
def test_reset_filter_goes_on_after_the_last_message(read: int, rest: str, tmp_path: Path) -> None:
    """Read `read` messages on one topic, then go on with all: those of the present time too, each once."""
    write_of_one_time(tmp_path / "bag")
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(tmp_path / "bag"))
    reader.set_filter(rosbag2_py.StorageFilter(topics=["/a"]))
    assert texts(reader, read) == "1336"[:read]
    assert reader.has_next() == (read < 4)
    reader.reset_filter()
    assert texts(reader) == rest


def test_another_filter_goes_on_after_the_last_message_in_reverse(tmp_path: Path) -> None:
    write_of_one_time(tmp_path / "bag")
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(tmp_path / "bag"))
    reader.set_read_order(rosbag2_py.ReadOrder(reverse=True))
    assert texts(reader, 4) == "6543"
    reader.set_filter(rosbag2_py.StorageFilter(topics=["/a", "/b"]))
    assert texts(reader) == "3210"


def test_definitions_by_short_names_and_of_services() -> None:
    source = rosbag2_py.LocalMessageDefinitionSource()
    short = source.get_full_text("tf2_msgs/TFMessage")
    full = source.get_full_text("tf2_msgs/msg/TFMessage")
    assert (short.encoding, short.topic_type) == ("ros2msg", "tf2_msgs/TFMessage")
    assert (short.encoded_message_definition, short.type_hash) == (
        full.encoded_message_definition,
        full.type_hash,
    )
    service = source.get_full_text("nav_msgs/srv/GetMap")
    assert service.encoding == "ros2msg"
    text = service.encoded_message_definition
    assert "---" in text.splitlines()
    assert text.count("MSG: nav_msgs/OccupancyGrid\n") == text.count("MSG: std_msgs/Header\n") == 1
    assert source.get_full_text("nav_msgs/srv/None").encoding == "unknown"


@pytest.mark.parametrize("kind", [rosbag2_py.Player, rosbag2_py.Recorder])
def test_log_level_of_player_and_recorder(kind: Any) -> None:
    kind("debug")
    kind()
    with pytest.raises(ValueError, match="no log level 'loud': debug, info, warn, error or fatal"):
        kind("loud")


@pytest.mark.wire
@pytest.mark.parametrize(("level", "is_told"), [("debug", True), ("fatal", False)])
def test_log_level_holds_while_a_bag_is_played(
    level: str, is_told: bool, domain_id: int, tmp_path: Path
) -> None:
    import subprocess
    import sys

    write_of_one_time(tmp_path / "bag")
    code = (
        "import rosbag2_py, sys; options = rosbag2_py.PlayOptions(); options.disable_keyboard_controls = True; "
        "rosbag2_py.Player(sys.argv[2]).play(rosbag2_py.StorageOptions(sys.argv[1], 'mcap'), options); "
        "from rclpy.logging import get_logger_effective_level; print(get_logger_effective_level('x').name)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "bag"), level],
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    assert done.stdout.splitlines()[-1] == level.upper()
    assert ("[INFO]" in done.stderr + done.stdout) == is_told


def test_metadata_and_definitions_of_a_recorded_bag() -> None:
    metadata = rosbag2_py.Info().read_metadata(str(BAGS / "mcap"), "mcap")
    assert metadata.duration == Duration(nanoseconds=13737005344)
    assert metadata.starting_time.nanoseconds == 1795304246236723712
    assert isinstance(metadata.starting_time, Time)
    assert [topic.message_count for topic in metadata.topics_with_message_count] == [16, 1, 859]
    assert [file.path for file in metadata.files] == ["b1_0.mcap"]
    chatter = metadata.topics_with_message_count[0].topic_metadata
    qos = [rosbag2_py.convert_rclcpp_qos_to_rclpy_qos(profile) for profile in chatter.offered_qos_profiles]
    assert [profile.depth for profile in qos] == [10, 7]
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(BAGS / "mcap"))
    assert {
        definition.topic_type: definition.encoding for definition in reader.get_all_message_definitions()
    } == dict.fromkeys(["std_msgs/msg/String", "tf2_msgs/msg/TFMessage", "turtlesim/msg/Pose"], "ros2msg")
    assert reader.get_metadata() == metadata
    source = rosbag2_py.LocalMessageDefinitionSource()
    assert "MSG: std_msgs/Header" in source.get_full_text("tf2_msgs/msg/TFMessage").encoded_message_definition
    assert source.get_full_text("no_pkg/msg/None").encoding == "unknown"


def test_metadata_io_keeps_all(tmp_path: Path) -> None:
    io = rosbag2_py.MetadataIo()
    metadata = io.read_metadata(str(BAGS / "split"))
    assert not io.metadata_file_exists(str(tmp_path))
    io.write_metadata(str(tmp_path), metadata)
    assert (tmp_path / "metadata.yaml").read_bytes() == (BAGS / "split" / "metadata.yaml").read_bytes()
    assert io.serialize_metadata(
        io.deserialize_metadata(io.serialize_metadata(metadata))
    ) == io.serialize_metadata(metadata)


def test_compressed_bag_and_its_rewriting(tmp_path: Path) -> None:
    options = rosbag2_py.CompressionOptions("zstd", rosbag2_py.CompressionMode.FILE)
    writer = rosbag2_py.SequentialCompressionWriter(options)
    rows = write(tmp_path / "bag", writer)
    writer.split_bagfile()
    writer.write("/chatter", rows[1][2], 1020)
    del writer
    assert sorted(file.name for file in (tmp_path / "bag").glob("*.zstd")) == [
        "bag_0.mcap.zstd",
        "bag_1.mcap.zstd",
    ]
    (tmp_path / "bag" / "metadata.yaml").unlink()
    rosbag2_py.Reindexer().reindex(rosbag2_py.StorageOptions(str(tmp_path / "bag")))
    rosbag2_py.bag_rewrite(
        [rosbag2_py.StorageOptions(str(tmp_path / "bag"))],
        f"output_bags:\n- {{uri: '{tmp_path}/out', storage_id: sqlite3, topics: [/other]}}\n",
    )
    assert read_by_rosbags(tmp_path / "out") == [row for row in rows if row[0] == "/other"]
    assert rosbag2_py.compression_mode_from_string("file") == rosbag2_py.CompressionMode.FILE
    assert rosbag2_py.compression_mode_to_string(rosbag2_py.CompressionMode.MESSAGE) == "MESSAGE"
    assert rosbag2_py.get_registered_writers() == rosbag2_py.get_registered_readers() == {"mcap", "sqlite3"}


def test_mistakes_are_runtime_errors(tmp_path: Path) -> None:
    write(tmp_path / "bag")
    odd_options = rosbag2_py.RecordOptions()
    odd_options.compression_mode = "files"
    new = rosbag2_py.StorageOptions(str(tmp_path / "new"))
    for use, said in (
        (lambda: rosbag2_py.Recorder().record(new, odd_options), "none, file or message, not 'FILES'"),
        (lambda: rosbag2_py.bag_rewrite([], f"{{output_bags: [], {'x' * 300}: 1, [}}"), "output_options: "),
        (lambda: rosbag2_py.SequentialReader().open_uri(str(tmp_path / "none")), "there is no such file"),
        (rosbag2_py.SequentialReader().has_next, "call open"),
        (lambda: write(tmp_path / "bag"), "exists already"),
        (lambda: write(tmp_path / "odd", storage_id="odd"), "'odd' is unknown"),
        (lambda: rosbag2_py.SequentialWriter().write("/x", b"", 0), "call open"),
    ):
        with pytest.raises(RuntimeError, match=said):
            use()  # type: ignore[no-untyped-call]
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(tmp_path / "new")), CDR)
    for stamps in ({}, {"time_stamp": 1, "recv_timestamp": 1}):
        with pytest.raises(TypeError, match="one log time in nanoseconds"):
            writer.write("/x", b"", **stamps)
    with pytest.raises(RuntimeError, match="Topic '/x' has not been created yet! Call 'create_topic' first"):
        writer.write("/x", b"", 0)


@pytest.fixture
def local_default(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    assert not get_default_context().ok()


def test_recorder_and_player_run_until_they_are_cancelled(local_default: None, tmp_path: Path) -> None:
    write(tmp_path / "bag")
    record_options = rosbag2_py.RecordOptions()
    record_options.topics = ["/again"]
    record_options.disable_keyboard_controls = True
    play_options = rosbag2_py.PlayOptions()
    play_options.topic_remapping_options = ["--ros-args", "--remap", "/chatter:=/again"]
    play_options.disable_keyboard_controls = True
    play_options.delay = 0.3
    play_options.loop = True
    recorder, player = rosbag2_py.Recorder(), rosbag2_py.Player()
    storage = rosbag2_py.StorageOptions(str(tmp_path / "new"), "mcap")
    # One context for both.
    context: Context = get_default_context()
    context.init(args=[], domain_id=0)
    threads = [
        threading.Thread(target=recorder.record, args=(storage, record_options)),
        threading.Thread(
            target=player.play, args=(rosbag2_py.StorageOptions(str(tmp_path / "bag")), play_options)
        ),
    ]
    for thread in threads:
        thread.start()
    try:
        wait_until((tmp_path / "new" / "new_0.mcap").exists)
        time_limit = time.monotonic() + 10.0
        path = tmp_path / "new" / "new_0.mcap"
        while path.stat().st_size < 2000 and time.monotonic() < time_limit:
            time.sleep(0.01)
    finally:
        rosbag2_py.Player.cancel()
        rosbag2_py.Recorder.cancel()
        for thread in threads:
            thread.join(10.0)
        context.try_shutdown()
    texts = {row[2] for row in read_by_rosbags(tmp_path / "new")}
    assert texts <= {serialize_message(String(data=f"{number}")) for number in range(20)}
    assert len(texts) == 16


def test_times_of_sending_are_written_and_read(tmp_path: Path) -> None:
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(tmp_path / "bag"), "mcap"), CDR)
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/x", "std_msgs/msg/String", "cdr"))
    data = serialize_message(String(data="a"))
    writer.write("/x", data, 100)
    writer.write("/x", data, 200, 150, 7)
    writer.write("/x", data, recv_timestamp=300, send_timestamp=250, sequence_number=8)
    writer.close()
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(tmp_path / "bag"))
    found = [reader.read_next_ext() for _ in range(3)]
    assert found == [("/x", data, 100, 100), ("/x", data, 200, 150), ("/x", data, 300, 250)]
    with pytest.raises(RuntimeError, match="no more messages"):
        reader.read_next_ext()
