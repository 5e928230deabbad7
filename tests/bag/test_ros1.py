"""Bags of ROS 1, which rosbags writes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rosbags.rosbag1 import Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from tests.bag.recordings import SECOND, START

from tfloom.bag import BagError, frames, open_bag

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


def write(path: Path, compression: Any = None, kind: str = "tf2_msgs/msg/TFMessage") -> Path:
    writer = Writer(path)
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
            add(
                tf,
                stamp,
                [transform("map", "odom", stamp, 0.1 * i), transform("odom", "base_link", stamp, 1)],
            )
            message = STORE.serialize_ros1(T["std_msgs/msg/String"]("text"), "std_msgs/msg/String")
            writer.write(text, stamp, message)
    return path


@pytest.mark.parametrize("compression", FORMATS, ids=["none", "bz2", "lz4"])
def test_frames_of_a_bag_of_ros_1(compression: Any, tmp_path: Path) -> None:
    path = write(tmp_path / "a.bag", compression)
    buffer = frames(path)
    found = buffer.lookup("map", "lidar", START + 250_000_000)
    assert found.translation == pytest.approx((4.0, 0, 0))
    edges = {each.child_frame_id: each for each in buffer.edges()}
    assert edges["lidar"].is_static
    assert edges["odom"].sample_count == 50
    part = frames(path, start_ns=START + SECOND // 10, end_ns=START + SECOND // 5 - 1)
    assert {each.child_frame_id: each.sample_count for each in part.edges()} == {
        "odom": 10,
        "base_link": 10,
        "lidar": 1,
    }
    assert np.allclose(buffer.trajectory("map", "base_link").positions[:, 0], 1 + 0.1 * np.arange(50))


def test_messages_of_tfs_old_type(tmp_path: Path) -> None:
    assert frames(write(tmp_path / "a.bag", kind="tf/msg/tfMessage")).has_frame("odom")


def test_raw_messages_and_topics(tmp_path: Path) -> None:
    with open_bag(write(tmp_path / "a.bag")) as bag:
        assert bag.message_count == len(list(bag.messages())) == 101
        assert bag.topics["/tf"].serialization_format == "ros1"
        assert (bag.start_ns, bag.end_ns) == (START, START + 49 * SECOND // 100)
        assert len(list(bag.messages("/chatter"))) == 50
        with pytest.raises(BagError, match="/chatter is serialized as 'ros1', and only cdr is decoded"):
            bag.read("/chatter")
        assert bag.stamps("/chatter").tolist()[:2] == [START, START + 10_000_000]


def test_errors_name_the_file_and_the_reason(tmp_path: Path) -> None:
    whole = write(tmp_path / "whole.bag").read_bytes()
    cases = {
        "empty.bag": (b"", "the file is empty"),
        "old.bag": (b"#ROSBAG V1.2\n" + bytes(90), "this is no bag of ROS 1, version 2.0: it begins with"),
        "cut.bag": (whole[:3000], "the bag "),
        "half.bag": (whole[: len(whole) // 2], "the bag "),
        "damaged.bag": (whole[:4100] + b"\xff" * 300 + whole[4400:], "the bag "),
    }
    wrong = []
    for name, (data, text) in cases.items():
        path = tmp_path / name
        path.write_bytes(data)
        try:
            list(open_bag(path).messages())
        except BagError as error:
            if not str(error).startswith(str(path)) or text not in str(error):
                wrong.append((name, str(error)))
        else:
            wrong.append((name, "no error"))
    assert wrong == []
