"""Classes of types that only a recording knows, made from its own definitions."""

from __future__ import annotations

from pathlib import Path

import pytest
from mcap.writer import Writer
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as RosbagsWriter
from rosbags.typesys import Stores, get_types_from_idl, get_types_from_msg, get_typestore
from tests.bag.recordings import START, error_of

from tfloom.bag import BagError, open_bag
from tfloom.bag.values import Definition, Topic
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.rosidl.described import hash_of
from tfloom.rosidl.registry import get_message_class

LINE = "=" * 80 + "\n"
PROBE = """\
uint8 KIND_WATER = 3
std_msgs/Header header
Reading[] readings
float64[3] position
string<=20 label "none"
"""
READING = "float32 value\nbool[] flags\n"


def typestore(package: str) -> object:
    store = get_typestore(Stores.ROS2_JAZZY)
    types = get_types_from_msg(PROBE.replace("Reading[]", f"{package}/Reading[]"), f"{package}/msg/Probe")
    store.register({**types, **get_types_from_msg(READING, f"{package}/msg/Reading")})
    return store


@pytest.mark.parametrize("plugin", [StoragePlugin.MCAP, StoragePlugin.SQLITE3], ids=["mcap", "sqlite3"])
def test_messages_of_a_type_that_only_the_recording_knows(plugin: StoragePlugin, tmp_path: Path) -> None:
    import numpy as np

    package = f"only_in_{plugin.name.lower()}"
    store: object = typestore(package)
    types = store.types  # type: ignore[attr-defined]
    header = types["std_msgs/msg/Header"](types["builtin_interfaces/msg/Time"](12, 34), "probe")
    reading = types[f"{package}/msg/Reading"](1.5, np.array([True, False]))
    probe = types[f"{package}/msg/Probe"](header, [reading], np.array([1.0, 2.0, 3.0]), "deep")
    folder = tmp_path / "bag"
    with RosbagsWriter(folder, version=9, storage_plugin=plugin) as writer:
        connection = writer.add_connection("/probe", f"{package}/msg/Probe", typestore=store)
        data = bytes(store.serialize_cdr(probe, f"{package}/msg/Probe"))  # type: ignore[attr-defined]
        writer.write(connection, START, data)
    with open_bag(folder) as bag:
        ((raw, message),) = bag.read("/probe")
        assert raw.data == data
        assert (message.header.stamp.sec, message.header.frame_id) == (12, "probe")
        assert message.readings[0].value == 1.5
        assert list(message.readings[0].flags) == [True, False]
        assert message.position.tolist() == [1.0, 2.0, 3.0]
        assert (message.label, message.KIND_WATER) == ("deep", 3)
        assert bag.stamps("/probe").tolist() == [12_000_000_034]
        assert bag.stamps("/probe", "log").tolist() == [START]
    assert isinstance(message, get_message_class(f"{package}/msg/Probe"))


@pytest.mark.parametrize("text", ["", "\n", "# no fields\n"])
@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
@pytest.mark.parametrize("has_hash", [True, False])
def test_messages_of_a_type_without_fields(
    storage_id: str, text: str, has_hash: bool, tmp_path: Path
) -> None:
    name = f"bare_in_{storage_id}_{len(text)}_{has_hash:d}/msg/Nothing"
    type_hash = hash_of(name, {name: {}}) if has_hash else ""
    writer = BagWriter(tmp_path / "bag", WriterSettings(storage_id))
    topic = Topic("/a", name, "cdr", type_hash, "", Definition("ros2msg", text))
    writer.push(writer.add_topic(topic), b"\0\1\0\0\0", START, START)
    writer.close()
    with open_bag(tmp_path / "bag") as bag:
        ((_, message),) = bag.read("/a")
        assert repr(message) == f"{name.replace('/', '.')}()"


def write(path: Path, name: str, encoding: str, text: str, data: bytes) -> Path:
    with path.open("wb") as file:
        writer = Writer(file)
        writer.start("ros2", "a test")
        schema = writer.register_schema(name, encoding, text.encode())
        writer.add_message(writer.register_channel("/a", "cdr", schema), START, data, START)
        writer.finish()
    return path


def test_definition_in_idl(tmp_path: Path) -> None:
    text = (
        f"{LINE}IDL: idl_of_bag/msg/Depth\n"
        "module idl_of_bag { module msg { struct Depth { idl_of_bag::msg::Unit unit; double depth; }; }; };\n"
        f"{LINE}IDL: idl_of_bag/msg/Unit\n"
        "module idl_of_bag { module msg { struct Unit { string name; }; }; };\n"
    )
    store = get_typestore(Stores.EMPTY)
    store.register(get_types_from_idl(text.replace(LINE, "").replace("IDL: ", "// ")))
    types = store.types
    unit = types["idl_of_bag/msg/Unit"]("m")
    data = bytes(store.serialize_cdr(types["idl_of_bag/msg/Depth"](unit, 2.5), "idl_of_bag/msg/Depth"))
    ((_, message),) = open_bag(
        write(tmp_path / "a.mcap", "idl_of_bag/msg/Depth", "ros2idl", text, data)
    ).read("/a")
    assert (message.unit.name, message.depth) == ("m", 2.5)


def test_type_that_is_otherwise_here_gets_a_class_of_its_own(tmp_path: Path) -> None:
    """As a message of another distribution of ROS, whose package is installed here in another version."""
    text = f"geometry_msgs/Point32 at\nstring note\n{LINE}MSG: geometry_msgs/Point32\nfloat32 x\nfloat32 y\n"
    data = b"\0\1\0\0\0\0\x80?\0\0\0@\3\0\0\0ok\0"
    bag = open_bag(write(tmp_path / "a.mcap", "geometry_msgs/msg/PointStamped", "ros2msg", text, data))
    ((_, message),) = bag.read("/a")
    assert (message.at.x, message.at.y, message.note) == (1.0, 2.0, "ok")
    assert type(message)._TYPE_NAME.startswith("geometry_msgs_recorded_")
    ours = get_message_class("geometry_msgs/msg/PointStamped")
    assert set(ours._FIELDS) == {"header", "point"}
    assert set(get_message_class("geometry_msgs/msg/Point32")._FIELDS) == {"x", "y", "z"}
    ((_, again),) = bag.read("/a")
    assert type(again) is type(message)


def test_type_that_is_the_same_here_has_the_class_of_tfloom(tmp_path: Path) -> None:
    path = write(tmp_path / "a.mcap", "std_msgs/msg/String", "ros2msg", "string data", b"\0\1\0\0\2\0\0\0a\0")
    ((_, message),) = open_bag(path).read("/a")
    assert type(message) is get_message_class("std_msgs/msg/String")


def test_empty_text_is_not_the_definition_of_a_type_with_fields(tmp_path: Path) -> None:
    string = get_message_class("std_msgs/msg/String")
    data = b"\0\1\0\0\2\0\0\0a\0"
    with open_bag(write(tmp_path / "a.mcap", "std_msgs/msg/String", "ros2msg", "", data)) as bag:
        ((_, message),) = bag.read("/a")
        assert message == string(data="a")
    topic = Topic("/a", "bare/msg/Fields", "cdr", string._TYPE_HASH, "", Definition("ros2msg", ""))
    writer = BagWriter(tmp_path / "bag")
    writer.push(writer.add_topic(topic), data, START, START)
    writer.close()
    with (
        open_bag(tmp_path / "bag") as bag,
        pytest.raises(BagError, match="bare/msg/Fields has no definition"),
    ):
        list(bag.read("/a"))


def test_definitions_that_cannot_be_used_are_named(tmp_path: Path) -> None:
    cases = {
        "none": ("", "", "nowhere/msg/A has no definition, here or in the file: source the workspace"),
        "garbage": ("ros2msg", "what is this?", "the definition of nowhere/msg/A is invalid"),
        "empty": (
            "ros2idl",
            "",
            "nowhere/msg/A has no definition, here or in the file: source the workspace",
        ),
        "part": ("ros2msg", "nowhere_else/B b", "there is no definition of 'nowhere_else/msg/B'"),
        "itself": ("ros2msg", "A a", "nested in nowhere/msg/A more than 50 deep, or in themselves"),
        "huge": ("ros2msg", "uint8[4000000000] a", "a new nowhere/msg/A would hold more than 1000000 values"),
        "idl": ("ros2idl", "module {", "the definition of nowhere/msg/A is invalid"),
    }
    for name, (encoding, text, expected) in cases.items():
        path = write(tmp_path / f"{name}.mcap", "nowhere/msg/A", encoding, text, b"\0\1\0\0")
        with error_of(path, expected):
            open_bag(path).read("/a")


def test_message_that_is_none_of_its_type_is_an_error(tmp_path: Path) -> None:
    path = write(
        tmp_path / "a.mcap", "std_msgs/msg/String", "ros2msg", "string data", b"\0\1\0\0\xff\0\0\0a\0"
    )
    with pytest.raises(BagError, match=f"a message on /a of {START} ns isn't a std_msgs/msg/String: "):
        list(open_bag(path).read("/a"))
