"""Bags of ROS 1, which rosbags writes."""

from __future__ import annotations

import random
import struct
import warnings
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rosbags.rosbag1 import Reader, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from tests.bag.recordings import SECOND, START, error_of, rows_of

from tfloom.bag import BagError, BagWarning, frames, open_bag
from tfloom.bag.reading.ros1_records import CHUNK, MAGIC

STORE = get_typestore(Stores.ROS1_NOETIC)
STORE.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms", "tf2_msgs/msg/TFMessage"))
STORE.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms", "tf/msg/tfMessage"))
T = STORE.types
FORMATS = [None, Writer.CompressionFormat.BZ2, Writer.CompressionFormat.LZ4]


def transform(frame_id: str, child_frame_id: str, stamp_ns: int, x: float) -> Any:
    stamp = T["builtin_interfaces/msg/Time"](*divmod(stamp_ns, SECOND))
    return T["geometry_msgs/msg/TransformStamped"](
        T["std_msgs/msg/Header"](3, stamp, frame_id),
        child_frame_id,
        T["geometry_msgs/msg/Transform"](
            T["geometry_msgs/msg/Vector3"](x, 0.0, 0.0), T["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0)
        ),
    )


def write(
    path: Path, compression: Any = None, kind: str = "tf2_msgs/msg/TFMessage", chunk_size: int = 1 << 20
) -> Path:
    writer = Writer(path)
    writer.chunk_threshold = chunk_size
    if compression is not None:
        writer.set_compression(compression)
    with writer:
        tf = writer.add_connection("/tf", kind, typestore=STORE)
        static = writer.add_connection("/tf_static", kind, typestore=STORE)
        text = writer.add_connection("/chatter", "std_msgs/msg/String", typestore=STORE)

        def add(connection: Any, stamp: int, transforms: list[Any]) -> None:
            writer.write(connection, stamp, STORE.serialize_ros1(T[kind](transforms), kind))

        add(static, START, [transform("/base_link", "/lidar", START, 0.5)])
        for i in range(50):
            stamp = START + i * SECOND // 100
            moving = [transform("map", "odom", stamp, 0.1 * i), transform("odom", "base_link", stamp, 1)]
            add(tf, stamp, moving)
            message = STORE.serialize_ros1(T["std_msgs/msg/String"]("text"), "std_msgs/msg/String")
            writer.write(text, stamp, message)
    return path


@pytest.mark.parametrize("compression", FORMATS, ids=["none", "bz2", "lz4"])
def test_frames_of_a_bag_of_ros_1(compression: Any, tmp_path: Path) -> None:
    path = write(tmp_path / "a.bag", compression)
    buffer = frames(path)
    found = buffer.lookup("map", "lidar", START + 250_000_000)
    assert found.translation == pytest.approx((4.0, 0, 0))
    edges = {edge.child_frame_id: edge for edge in buffer.edges()}
    assert edges["lidar"].is_static
    assert edges["odom"].sample_count == 50
    part = frames(path, start_ns=START + SECOND // 10, end_ns=START + SECOND // 5 - 1)
    assert {edge.child_frame_id: edge.sample_count for edge in part.edges()} == {
        "odom": 10,
        "base_link": 10,
        "lidar": 1,
    }
    assert np.allclose(buffer.trajectory("map", "base_link").positions[:, 0], 1 + 0.1 * np.arange(50))


def test_messages_of_tfs_old_type(tmp_path: Path) -> None:
    assert frames(write(tmp_path / "a.bag", kind="tf/msg/tfMessage")).has_frame("odom")


def test_a_message_that_is_unreadable_is_dropped_with_its_field(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    path = tmp_path / "a.bag"
    kind = "tf2_msgs/msg/TFMessage"
    spoilt = STORE.serialize_ros1(
        T[kind]([transform("map", child, START, 0.0) for child in ("odom", "frame")]), kind
    )
    with Writer(path) as writer:
        tf = writer.add_connection("/tf", kind, typestore=STORE)
        writer.write(tf, START, bytes(spoilt).replace(b"frame", b"\xff\xff\xff\xff\xff"))
        writer.write(tf, START, STORE.serialize_ros1(T[kind]([transform("map", "base", START, 0.0)]), kind))
    assert [edge.child_frame_id for edge in frames(path).edges()] == ["base"]
    reason = "transforms[1].child_frame_id: the text is not UTF-8 (at byte "
    assert f"on /tf that is no TFMessage: {reason}" in caplog.text


def test_raw_messages_and_topics(tmp_path: Path) -> None:
    with open_bag(write(tmp_path / "a.bag")) as bag:
        assert bag.message_count == len(list(bag.messages())) == 101
        assert bag.topics["/tf"].serialization_format == "ros1"
        assert (bag.start_ns, bag.end_ns) == (START, START + 49 * SECOND // 100)
        assert len(list(bag.messages("/chatter"))) == 50
        with pytest.raises(BagError, match="/chatter is serialized as 'ros1', and only cdr is decoded"):
            bag.read("/chatter")
        assert bag.stamps("/chatter").tolist()[:2] == [START, START + 10_000_000]


@pytest.mark.parametrize("compression", FORMATS, ids=["none", "bz2", "lz4"])
def test_messages_are_those_that_rosbags_reads(compression: Any, tmp_path: Path) -> None:
    path = write(tmp_path / "a.bag", compression, chunk_size=2000)
    with Reader(path) as reader:
        expected = [(connection.topic, stamp, bytes(data)) for connection, stamp, data in reader.messages()]
    assert sorted(rows_of(path)) == sorted(expected)
    with open_bag(path) as bag, Reader(path) as reader:
        assert {name: topic.message_count for name, topic in bag.topics.items()} == {
            name: topic.msgcount for name, topic in reader.topics.items()
        }
        assert (bag.start_ns, bag.end_ns) == (reader.start_time, reader.end_time - 1)


def test_errors_name_the_file_and_the_reason(tmp_path: Path) -> None:
    whole = write(tmp_path / "whole.bag").read_bytes()
    cases = {
        "empty.bag": (b"", "the file is empty"),
        "old.bag": (b"#ROSBAG V1.2\n" + bytes(90), "this is not a bag of ROS 1, version 2.0: it begins with"),
        "cut.bag": (whole[:20], "the bag has no header, because it is damaged or cut off"),
        "damaged.bag": (whole[:20] + b"\xff" * 300 + whole[320:], "the bag's header is damaged: a field of"),
        "encrypted.bag": (
            MAGIC + _record({"op": b"\x03", "index_pos": bytes(8), "encryptor": b"AES"}, b""),
            "the bag is encrypted by 'AES': decrypt it by rosbag",
        ),
    }
    for name, (data, text) in cases.items():
        path = tmp_path / name
        path.write_bytes(data)
        with error_of(path, text):
            rows_of(path)


@pytest.mark.parametrize("topics", [[], ["/a"]])
def test_whole_bag_without_messages_is_read_without_a_warning(topics: list[str], tmp_path: Path) -> None:
    path = tmp_path / "still.bag"
    with Writer(path) as writer:
        for topic in topics:
            writer.add_connection(topic, "std_msgs/msg/String", typestore=STORE)
    with warnings.catch_warnings(), open_bag(path) as bag:
        warnings.simplefilter("error")
        assert (sorted(bag.topics), list(bag.messages())) == (topics, [])


def test_bag_that_ends_where_its_index_should_begin_is_not_taken_for_a_whole_one(tmp_path: Path) -> None:
    whole = write(tmp_path / "whole.bag").read_bytes()
    at = whole.index(b"index_pos=") + len(b"index_pos=")
    (place,) = struct.unpack_from("<Q", whole, at)
    (tmp_path / "cut.bag").write_bytes(whole[:place])
    with pytest.warns(BagWarning, match="its recorder was killed"), open_bag(tmp_path / "cut.bag") as bag:
        assert bag.message_count == 101


def records(whole: bytes) -> list[tuple[int, int, int]]:
    """Return kind, offset, and offset of the data of each record in a bag."""
    found = []
    at = len(MAGIC)
    while at < len(whole):
        (length,) = struct.unpack_from("<I", whole, at)
        data = at + 4 + length + 4
        found.append((whole[whole.index(b"op=", at) + 3], at, data))
        at = data + struct.unpack_from("<I", whole, data - 4)[0]
    return found


def without_index(whole: bytes) -> bytes:
    """Return a bag that its recorder left after a whole chunk."""
    at = whole.index(b"index_pos=") + len(b"index_pos=")
    (end,) = struct.unpack_from("<Q", whole, at)
    return whole[:at] + bytes(8) + whole[at + 8 : end]


def within_a_chunk(whole: bytes) -> bytes:
    """Return a bag that its recorder left within a chunk, whose size is not written yet."""
    unfinished = without_index(whole)
    _, at, data = [record for record in records(unfinished) if record[0] == CHUNK][-1]
    end = data + struct.unpack_from("<I", unfinished, data - 4)[0]
    header = bytearray(unfinished[at : data - 4])
    place = header.index(b"size=") + len(b"size=")
    header[place : place + 4] = bytes(4)
    return unfinished[:at] + header + bytes(4) + unfinished[data : end - 30]


@pytest.mark.parametrize("compression", FORMATS, ids=["none", "bz2", "lz4"])
@pytest.mark.parametrize("name", ["a.bag.active", "a.bag"])
def test_bag_without_an_index_is_read_by_its_records(compression: Any, name: str, tmp_path: Path) -> None:
    whole = write(tmp_path / "whole.bag", compression, chunk_size=2000)
    expected = rows_of(whole)
    with open_bag(whole) as bag:
        topics = bag.topics
    path = tmp_path / name
    path.write_bytes(without_index(whole.read_bytes()))
    with pytest.warns(BagWarning, match="has no index, because it is still being recorded .*; 101 messages"):
        assert rows_of(path) == expected
    with pytest.warns(BagWarning):
        bag = open_bag(path)
    with bag:
        assert bag.topics == topics
        assert (bag.message_count, bag.start_ns, bag.end_ns) == (101, START, START + 49 * SECOND // 100)
        assert len(list(bag.messages("/tf", START + SECOND // 10, START + SECOND // 5 - 1))) == 10
    with pytest.warns(BagWarning):
        buffer = frames(path)
    assert buffer.lookup("map", "lidar", START + 250_000_000).translation == pytest.approx((4.0, 0, 0))


def test_chunk_that_was_being_written_is_read_to_its_last_whole_message(tmp_path: Path) -> None:
    whole = write(tmp_path / "whole.bag", chunk_size=2000)
    path = tmp_path / "a.bag.active"
    path.write_bytes(within_a_chunk(whole.read_bytes()))
    with pytest.warns(BagWarning, match="100 messages are read"):
        assert rows_of(path) == rows_of(whole)[:-1]


def test_bag_that_is_cut_off_anywhere_is_read_to_its_last_whole_message(tmp_path: Path) -> None:
    whole = write(tmp_path / "whole.bag", chunk_size=2000)
    expected = rows_of(whole)
    data = whole.read_bytes()
    path = tmp_path / "cut.bag"
    (index,) = struct.unpack_from("<Q", data, data.index(b"index_pos=") + len(b"index_pos="))
    most = 0
    for size in range(records(data)[1][1], index, 199):
        path.write_bytes(data[:size])
        with pytest.warns(BagWarning, match="has no index"):
            found = rows_of(path)
        assert found == expected[: len(found)]
        assert len(found) >= most
        most = len(found)
    assert most == len(expected)


def test_random_damage_gives_errors_and_warnings_only(tmp_path: Path) -> None:
    path = tmp_path / "damaged.bag"
    chance = random.Random(5)
    for compression in FORMATS:
        whole = write(tmp_path / f"{compression}.bag", compression, chunk_size=2000).read_bytes()
        for form in (whole, without_index(whole), *([within_a_chunk(whole)] if compression is None else [])):
            first = records(whole)[1][1]
            for _ in range(25):
                data = bytearray(form)
                for _ in range(chance.randint(1, 6)):
                    data[chance.randrange(first, len(data))] = chance.choice(
                        [0, 1, 127, 255, chance.randrange(256)]
                    )
                path.write_bytes(data)
                with warnings.catch_warnings(), suppress(BagError):
                    warnings.simplefilter("ignore", BagWarning)
                    rows_of(path)
                    frames(path)


def test_compression_that_is_unknown_is_named(tmp_path: Path) -> None:
    whole = write(tmp_path / "whole.bag", Writer.CompressionFormat.BZ2).read_bytes()
    path = tmp_path / "a.bag"
    path.write_bytes(without_index(whole).replace(b"compression=bz2", b"compression=xyz"))
    with pytest.raises(
        BagError, match=r"a\.bag: byte \d+: the compression is 'xyz', which is none of bz2 and lz4"
    ):
        open_bag(path)


def _record(fields: dict[str, bytes], data: bytes, declared: int | None = None) -> bytes:
    header = b"".join(
        struct.pack("<I", len(name) + 1 + len(value)) + name.encode() + b"=" + value
        for name, value in fields.items()
    )
    size = len(data) if declared is None else declared
    return struct.pack("<I", len(header)) + header + struct.pack("<I", size) + data
