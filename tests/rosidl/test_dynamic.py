"""Types made at run time: from text, from a folder, from a sourced workspace."""

from __future__ import annotations

import pickle
import struct
from pathlib import Path

import numpy as np
import pytest
from tests.rosidl.workspaces import write_files

from tfloom.interfaces.geometry_msgs.msg import Point
from tfloom.rosidl import cdr, registry, sources
from tfloom.rosidl.definition_files import interface_names
from tfloom.rosidl.dynamic import define, define_folder
from tfloom.rosidl.parse import ParseError
from tfloom.rosidl.registry import get_action_class, get_message_class, get_service_class

EVERYTHING = """\
# Holds one of everything.
# In two lines.

# not part of it
uint8 LARGE=200      # a constant
string WORD="a # b"
float64[<=3] ranges  # [m]
string name 'unknown'
geometry_msgs/Point[2] corners
wstring<=4 wide
bool[3] flags [true, false, true]
int32[2] pair [1, -2]
byte[2] octets
string<=5[<=2] words ['a', "b"]
char letter 65
byte octet 7
float32 x -1.5
"""


def test_class_is_made_from_text() -> None:
    cls = define("my_msgs/msg/Everything", EVERYTHING)
    message = cls()
    assert cls.__doc__ == "Holds one of everything. In two lines."
    assert (cls.LARGE, cls.WORD) == (200, "a # b")
    assert (message.name, message.flags, message.words) == ("unknown", [True, False, True], ["a", "b"])
    assert (message.octets, message.octet, message.letter, message.x) == ([b"\0", b"\0"], b"\7", 65, -1.5)
    assert message.pair.tolist() == [1, -2]
    assert message.corners == [Point(), Point()]
    assert message.corners[0] is not message.corners[1]
    assert cls.get_fields_and_field_types() == {
        "ranges": "sequence<double, 3>",
        "name": "string",
        "corners": "geometry_msgs/Point[2]",
        "wide": "wstring<4>",
        "flags": "boolean[3]",
        "pair": "int32[2]",
        "octets": "octet[2]",
        "words": "sequence<string<5>, 2>",
        "letter": "uint8",
        "octet": "octet",
        "x": "float",
    }
    message.ranges, message.wide = [1.0], "ñ🐢"
    assert cdr.decode(cls, cdr.encode(message)) == message
    assert get_message_class("my_msgs/Everything") is cls
    assert pickle.loads(pickle.dumps(message)) == message


@pytest.mark.parametrize(
    ("field", "value", "text"),
    [
        ("ranges", [0.0] * 4, "Everything.ranges: 4 elements are more than the bound of 3"),
        ("corners", [Point()], "Everything.corners must have 2 elements, got 1"),
        ("corners", [Point(), 5], "Everything.corners[1] must be a geometry_msgs/msg/Point, got 5 (int)"),
        ("wide", "abcde", "Everything.wide: 5 characters are more than the bound of 4"),
        ("flags", [True] * 4, "Everything.flags must have 3 elements, got 4"),
        ("flags", [True, 0, True], "Everything.flags[1] must be a bool, got 0 (int)"),
        ("words", ["a", "b", "c"], "Everything.words: 3 elements are more than the bound of 2"),
        ("words", ["abcdef"], "Everything.words[0]: 6 characters are more than the bound of 5"),
        ("octets", [b"a", 5], "Everything.octets[1] must be bytes of length 1, got 5 (int)"),
        ("pair", np.zeros(3, np.int32), "Everything.pair must have 2 elements, got 3"),
    ],
)
def test_bounds_are_enforced_on_encoding(field: str, value: object, text: str) -> None:
    message = define("my_msgs/msg/Everything", EVERYTHING)()
    setattr(message, field, value)
    with pytest.raises(cdr.EncodeError) as raised:
        cdr.encode(message)
    assert str(raised.value) == text


def test_bounds_are_enforced_on_decoding() -> None:
    cls = define("my_msgs/msg/Wide", "wstring<=2 wide\nstring<=2[<=1] words")
    data = struct.pack("<4xI3I", 3, *b"abc").replace(b"\0\0\0\0", b"\0\1\0\0", 1)
    with pytest.raises(
        cdr.DecodeError, match=r"^Wide.wide: byte 20: 3 characters are more than the bound of 2$"
    ):
        cdr.decode(cls, data)
    data = b"\0\1\0\0" + struct.pack("<III", 0, 1, 4) + b"abc\0"
    with pytest.raises(cdr.DecodeError, match=r"^Wide.words\[0\]: byte 20: 3 characters are more"):
        cdr.decode(cls, data)


def test_services_and_actions_are_defined() -> None:
    service = define("my_msgs/srv/Do", "int32 a\n---\nDo2 b\n".replace("Do2", "geometry_msgs/Point"))
    assert service.Request(a=3).a == 3
    assert service.Response().b == Point()
    assert list(service.Event._FIELDS) == ["info", "request", "response"]
    assert get_service_class("my_msgs/Do") is service
    assert get_message_class("my_msgs/srv/Do_Request") is service.Request
    action = define("my_msgs/action/Go", "int32 a\n---\n---\nfloat32 f")
    assert action.Impl.SendGoalService.Request().goal == action.Goal()
    assert action.Impl.FeedbackMessage().feedback == action.Feedback()
    assert get_action_class("my_msgs/action/Go") is action
    feedback = action.Impl.FeedbackMessage()
    assert pickle.loads(pickle.dumps(feedback)) == feedback


def test_second_definition_replaces_the_first() -> None:
    first = define("my_msgs/msg/A", "int32 a")
    second = define("my_msgs/msg/A", "int32 b")
    assert (list(first._FIELDS), list(second._FIELDS)) == (["a"], ["b"])
    assert first._TYPE_HASH != second._TYPE_HASH
    assert get_message_class("my_msgs/msg/A") is second
    with pytest.raises(ParseError):
        define("my_msgs/msg/A", "nonsense")
    assert get_message_class("my_msgs/msg/A") is second


def test_hash_of_a_known_definition_matches() -> None:
    for name in ("sensor_msgs/msg/CameraInfo", "turtlesim/srv/Spawn", "example_interfaces/action/Fibonacci"):
        source = sources.find_source(name)
        assert source is not None
        known = registry.find_class(name)
        assert define(name, source.text)._TYPE_HASH == known._TYPE_HASH


def test_definitions_of_a_folder_are_defined(tmp_path: Path) -> None:
    files = {"msg/Outer.msg": "Inner inner\n", "msg/Inner.msg": "int32 a\n", "srv/Ask.srv": "---\n"}
    classes = define_folder(write_files(tmp_path / "my_msgs", files))
    assert list(classes) == ["my_msgs/msg/Inner", "my_msgs/msg/Outer", "my_msgs/srv/Ask"]
    assert type(classes["my_msgs/msg/Outer"]().inner) is classes["my_msgs/msg/Inner"]
    with pytest.raises(FileNotFoundError, match="no definitions in"):
        define_folder(tmp_path)


def test_folder_with_what_cannot_be_loaded(tmp_path: Path) -> None:
    files = {
        "Broken.msg": "int32 a\nint33 b\n",
        "Uses.msg": "Broken b\n",
        "Sound.msg": "int32 a\n",
        "bad_name.msg": "int32 a\n",
        "Bytes.msg": b"\xff",
    }
    home = write_files(tmp_path / "my_msgs" / "msg", files)
    (home / "Folder.msg").mkdir()
    with pytest.warns(UserWarning, match="can't be loaded") as warned:
        classes = define_folder(home.parent)
    assert list(classes) == ["my_msgs/msg/Sound"]
    broken = f"{home}/Broken.msg:2:1: 'int33' is neither a primitive type nor a message's name"
    assert str(warned[0].message).splitlines() == [
        f"5 of 6 definitions in {home.parent} can't be loaded:",
        f"  my_msgs/msg/Broken: {broken}",
        f"  my_msgs/msg/Bytes: {home}/Bytes.msg:1:1: octet 0xff isn't UTF-8 text",
        f"  my_msgs/msg/Folder: [Errno 21] Is a directory: '{home}/Folder.msg'",
        f"  my_msgs/msg/Uses: {broken}",
        "  my_msgs/msg/bad_name: 'bad_name' is not an interface name: letters and digits, the first a capital",
    ]
    assert warned[0].filename == __file__
    for name in ("Broken", "Uses"):
        with pytest.raises(LookupError):
            get_message_class(f"my_msgs/msg/{name}")
    (home / "Sound.msg").unlink()
    with pytest.raises(ValueError, match=r"^5 of 5 definitions in .*\n  my_msgs/msg/Broken: .*:2:1: 'int33'"):
        define_folder(home.parent)


@pytest.mark.usefixtures("forget_interfaces")
def test_definitions_of_a_sourced_workspace_are_found(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = {"There.msg": "Here here\n", "Here.msg": "bool yes true\n", "Wrong.msg": "int32 a\n  int33 b\n"}
    folder = write_files(tmp_path / "share" / "other_msgs" / "msg", files)
    monkeypatch.setenv("AMENT_PREFIX_PATH", f"/nowhere:{tmp_path}")
    assert get_message_class("other_msgs/msg/There")().here.yes is True
    with pytest.raises(ParseError) as raised:
        get_message_class("other_msgs/msg/Wrong")
    assert str(raised.value).startswith(f"{folder}/Wrong.msg:2:3: 'int33' is neither")


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("Nope x", "my_msgs/msg/A.msg:1:1: there is no definition of 'my_msgs/msg/Nope'"),
        (
            "int32 a\n  A b",
            "my_msgs/msg/A.msg:2:3: a message contains itself: my_msgs/msg/A -> my_msgs/msg/A",
        ),
    ],
)
def test_unknown_references_raise(text: str, error: str) -> None:
    with pytest.raises(ParseError) as raised:
        define("my_msgs/msg/A", text)
    assert str(raised.value) == error
    with pytest.raises(LookupError):
        get_message_class("my_msgs/msg/A")


def test_unknown_names_raise_with_the_nearest_name() -> None:
    assert "turtlesim/srv/Spawn" in interface_names("srv")
    for name, text in {
        "geometry_msgs/msg/Twst": (
            "there is no message type 'geometry_msgs/msg/Twst'; did you mean 'geometry_msgs/msg/Twist'?"
        ),
        "Twist": "there is no message type 'Twist'; did you mean 'geometry_msgs/msg/Twist'?",
        "no_such/msg/Type": "there is no message type 'no_such/msg/Type'",
        "turtlesim/srv/Spawn": "'turtlesim/srv/Spawn' is no message type but a service type",
        "../../etc/passwd": "there is no message type '../../etc/passwd'",
    }.items():
        with pytest.raises(LookupError) as raised:
            get_message_class(name)
        assert str(raised.value) == text


def test_defaults_of_arrays_are_new_each_time() -> None:
    text = "float64[2] pair [1.5, 2.5]\nint32[] some [1, 2]\nstring[] words ['a', 'b']"
    cls = define("my_msgs/msg/Defaults", text)
    assert cls.PAIR__DEFAULT.tolist() == [1.5, 2.5]
    cls.SOME__DEFAULT.append(3)
    cls.WORDS__DEFAULT.append("c")
    assert (cls.SOME__DEFAULT.tolist(), cls.WORDS__DEFAULT) == ([1, 2], ["a", "b"])
