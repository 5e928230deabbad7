"""Interfaces that .idl files define: the same types as those of .msg, .srv and .action files."""

from __future__ import annotations

import importlib
import json
import sys
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import run_to_end
from tests.ros_peer.programs import idl_contents
from tests.rosidl.workspaces import write_files

from tfloom import use_ros_names
from tfloom.rosidl import cdr, dynamic, idl_parser, registry, sources, spec
from tfloom.rosidl.definition import Constant, Include, Message
from tfloom.rosidl.idl_spec import parse_idl
from tfloom.rosidl.parse import ParseError, parse_interface
from tfloom.rosidl.type_hash import type_hash

HERE = Path(__file__).parent
FILES = sorted((HERE / "idl").glob("*.idl"))
RECORDED = json.loads((HERE.parent / "golden" / "idl_contents.json").read_text("utf-8"))

MESSAGE = """\
#include "geometry_msgs/msg/Point.idl"
module my_msgs {
  module msg {
    module All_Constants {
      const octet BYTE = 0x1F;
      const unsigned short LENGTH = (1 << 2) - 017 + 28 / 2;
      const double RATIO = -2.5;
      const string NAME = "a \\"name\\"\\t" "!";
    };
    typedef double double__3[3];
    typedef geometry_msgs::msg::Point geometry_msgs__msg__Point;
    typedef geometry_msgs__msg__Point corners[4];
    @verbatim (language="comment", text="All kinds" "\\n" "of fields.")
    struct All {
      @default (value=TRUE) @unit("none")
      boolean flag;
      @verbatim (language="comment", text="[m]")
      double__3 three;
      corners points;
      sequence<float> floats;
      @default (value="(1, 2, 255)")
      sequence<octet, 5> octets;
      string<7> text;
      @default (value="('a', 'b')")
      sequence<string<3>, LENGTH> words;
      sequence<string<(32 >> 2)>> names;
      @default (value=L"\\u00e9")
      wstring wide;
      int16 a, b[2];
      @default (value=-7)
      long long far;
    };
  };
};
"""
SAME_MESSAGE = """\
# All kinds
# of fields.

byte BYTE=31
uint16 LENGTH=3
float64 RATIO=-2.5
string NAME='a "name"\\t!'
bool flag true
float64[3] three  # [m]
geometry_msgs/Point[4] points
float32[] floats
byte[<=5] octets [1, 2, 255]
string<=7 text
string<=3[<=3] words ["a", "b"]
string<=8[] names
wstring wide "é"
int16 a
int16[2] b
int64 far -7
"""
ACTION = """\
module my_msgs { module action {
  struct Roll_Goal { double distance; };
  struct Roll_Result { uint8 structure_needs_at_least_one_member; };
  struct Roll_Feedback { sequence<int32> sequence; };
}; };
"""
SERVICE = """\
module my_msgs { module srv {
  struct Weigh_Request { my_msgs::msg::All all; };
  module Weigh_Response_Constants { const int8 OK = 0; };
  struct Weigh_Response { float mass; };
}; };
"""
PAIRS = {
    "my_msgs/msg/All": (MESSAGE, SAME_MESSAGE),
    "my_msgs/srv/Weigh": (SERVICE, "my_msgs/All all\n---\nint8 OK=0\nfloat32 mass\n"),
    "my_msgs/action/Roll": (ACTION, "float64 distance\n---\n---\nint32[] sequence\n"),
}


def without_places(interface: spec.Interface) -> list[spec.Message]:
    return [
        message._replace(fields=tuple(field._replace(position=(0, 0)) for field in message.fields))
        for message in spec.messages_of(interface)
    ]


@pytest.mark.parametrize("name", PAIRS)
def test_a_file_defines_what_a_definition_of_ros_does(name: str) -> None:
    idl, text = PAIRS[name]
    ours, theirs = parse_idl(idl, name, "a.idl"), parse_interface(text, name)
    assert without_places(ours) == without_places(theirs)
    (known,) = spec.messages_of(parse_interface(SAME_MESSAGE, "my_msgs/msg/All"))
    find = lambda name: known if name == known.name else sources.find_message(name)  # noqa: E731
    assert type_hash(ours, find) == type_hash(theirs, find)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_content_equals_the_references(path: Path, deviations: dict[str, dict[str, str]]) -> None:
    assert "idl-struct-annotations" in deviations
    ours = json.loads(json.dumps(idl_contents.contents(path)))
    assert without_annotations(ours) == RECORDED[path.name]


def without_annotations(value: Any, *, inside: bool = False) -> Any:
    """Empty the annotations of the structs of services and actions, which the reference ignores."""
    if isinstance(value, list):
        is_whole = bool(value) and isinstance(value[0], list) and value[0][:1] == ["NamespacedType"]
        return [without_annotations(item, inside=inside or is_whole) for item in value]
    if inside and isinstance(value, dict) and "members" in value:
        return value | {"annotations": [], "comments": []}
    return value


def test_annotations_of_a_services_structs_are_kept() -> None:
    content = idl_parser.parse_idl_string((HERE / "idl" / "Srv.idl").read_text("utf-8"))
    assert content.elements[-1].request_message.structure.get_comment_lines() == ["To weigh."]


def test_by_the_references_names() -> None:
    from rosidl_parser.definition import IdlFile
    from rosidl_parser.definition import Message as TheirMessage
    from rosidl_parser.parser import parse_idl_string

    content = parse_idl_string(MESSAGE)
    (message,) = content.get_elements_of_type(TheirMessage)
    assert [include.locator for include in content.get_elements_of_type(Include)] == [
        "geometry_msgs/msg/Point.idl"
    ]
    assert [constant.name for constant in message.constants] == ["BYTE", "LENGTH", "RATIO", "NAME"]
    assert isinstance(message.constants[0], Constant)
    assert TheirMessage is Message
    assert IdlFile is not None
    with pytest.raises(NotImplementedError, match="leave png_file out"):
        parse_idl_string(MESSAGE, "tree.png")  # type: ignore[arg-type]


def in_struct(member: str) -> str:
    before = "module p { module msg {\ntypedef double d3[3];\nenum E { A, B };\nstruct A {\n"
    return f"{before}{member}\n}};\n}}; }};\n"


@pytest.mark.parametrize(
    ("text", "place", "reason"),
    [
        ("", "1:1", "a file defines one message, service or action, which is 1, 2 or 3 structs; this one has 0"),
        (in_struct(""), "4:8", "a struct has one member or more"),
        (in_struct("int32 a"), "6:1", "expected ';' after the member, got '}'"),
        (in_struct("int32 a; int32 a;"), "5:16", "'a' is defined twice"),
        (in_struct("Point a;"), "5:1", "there is no type 'Point' before this line"),
        (in_struct("E a;"), "5:1", "'E' is an enumeration, and a member of ROS is not: use uint8, and constants"),
        (in_struct("A a;\n};\nstruct B { A a;"), "5:1", "there is no type 'A' before this line"),
        (in_struct("int32 a;\n};\nstruct B { A a;"), "7:12", "write the full name of the struct 'A'"),
        (in_struct("double a[2][3];"), "5:8", "an array of ROS has one dimension"),
        (in_struct("sequence<d3> a;"), "5:1", "an element of a sequence or an array is not itself one"),
        (in_struct("d3 a[2];"), "5:4", "an element of a sequence or an array is not itself one"),
        (in_struct("double a[0];"), "5:10", "the length of an array is an integer of 1 or more, not 0"),
        (in_struct("double a[N];"), "5:10", "there is no constant 'N' before this line"),
        (in_struct("double a[1 / 0];"), "5:12", "a division by zero"),
        (in_struct("double a[1 << 99];"), "5:12", "a shift is by 0 to 63 bits, not by 99"),
        (in_struct(f"double a[{'9' * 5000}];"), "5:10", "an integer has 64 bits at most"),
        (in_struct(f"double a[{'(' * 60}1{')' * 60}];"), "5:61", "an expression is nested more than 50 deep"),
        (in_struct("map<int32, int32> a;"), "5:1", "a member of ROS is not of the type 'map'"),
        (in_struct("wchar a;"), "5:7", "tfloom has no fields of IDL's type 'wchar': use uint16"),
        (in_struct("p::Point a;"), "5:10", "a message is written 'package::msg::Name', not 'p::Point'"),
        (in_struct("@default (value=300) uint8 a;"), "5:28", "300 is outside uint8's range [0, 255]"),
        (in_struct('@default (value="x") uint8 a;'), "5:28", "'x' is not a value of the type 'uint8'"),
        (in_struct('@default (value="(1, 2)") d3 a;'), "5:30", "float64[3] takes 3 values, got 2"),
        (in_struct('@default (value="f()") d3 a;'), "5:27", "the default of 'float64[3]' is written \"(1, 2)\""),
        (in_struct("@default (value=1) q::msg::B a;"), "5:30", "a field of type 'q/msg/B' takes no default"),
        (in_struct("@default (3) uint8 a;"), "5:20", "a default is written '@default (value=...)', once"),
        (in_struct('string a; // "\nstring b = "c;'), "6:12", "the string has no closing quote on its line"),
        (in_struct('@unit("m) string a;'), "5:7", "the string has no closing quote on its line"),
        (in_struct("/* no end"), "5:1", "the comment has no end"),
        (in_struct("char a = 'x';"), "5:10", "ROS has no characters in single quotes"),
        ("#pragma once\n", "1:1", "of the preprocessor's directives, ROS has only #include \"file\""),
        ("union U {};\n", "1:1", "'union' starts no definition of ROS's IDL"),
        ("module p { const string S = 3; };", "1:29", "3 is not a value of the constant's type"),
        ("struct A { int32 a; };", "1:8", "the file defines the message 'A', and by its path the message 'p::msg::A'"),
        (
            "module p { module msg { struct A { int32 a; }; struct B { int32 b; }; }; };",
            "1:32",
            "a file with 2 structs has p::msg::A_Request and p::msg::A_Response",
        ),
        (
            "module p { module msg { struct A_Request { int32 a; }; struct A_Response { int32 b; }; }; };",
            "1:32",
            "the file defines the service 'p::msg::A', and by its path the message 'p::msg::A'",
        ),
    ],
)  # fmt: skip
def test_mistakes_are_named_with_line_and_column(text: str, place: str, reason: str) -> None:
    with pytest.raises(ParseError) as error:
        parse_idl(text, "p/msg/A", "A.idl")
    assert str(error.value).startswith(f"A.idl:{place}: {reason}")


@pytest.fixture
def share(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, forget_interfaces: None) -> Path:
    """Return the folder of packages of a sourced prefix, with the package my_msgs in .idl files alone."""
    share = write_files(tmp_path / "share", {f"{name}.idl": idl for name, (idl, _) in PAIRS.items()})
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    use_ros_names()
    return share


@pytest.mark.usefixtures("share")
def test_an_idl_file_of_a_sourced_package_is_a_type() -> None:
    all_fields = registry.get_message_class("my_msgs/msg/All")
    assert all_fields is importlib.import_module("my_msgs.msg").All
    message = all_fields(three=[1.0, 2.0, 3.0], text="seven")
    assert (message.flag, message.words, message.wide, message.far) == (True, ["a", "b"], "é", -7)
    assert cdr.decode(all_fields, cdr.encode(message)) == message
    assert registry.get_action_class("my_msgs/action/Roll").Feedback().sequence.tolist() == []
    service = registry.get_service_class("my_msgs/srv/Weigh")
    assert type(service.Request().all) is all_fields
    assert service.Response.OK == 0


def test_the_definition_precedes_the_idl_file_that_is_generated_from_it(share: Path) -> None:
    (share / "my_msgs" / "msg" / "All.msg").write_text("float64 only 1.5\n")
    assert registry.get_message_class("my_msgs/msg/All")().only == 1.5


@pytest.mark.usefixtures("forget_interfaces")
def test_a_folder_of_idl_files_is_defined(share: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("AMENT_PREFIX_PATH")
    monkeypatch.setattr(sources, "_defined", {})
    classes = dynamic.define_folder(share / "my_msgs")
    assert sorted(classes) == sorted(PAIRS)
    assert dynamic.define("my_msgs/msg/All", MESSAGE, "All.idl")().far == -7
    with pytest.raises(ParseError, match=r"^All\.idl:1:1: "):
        dynamic.define("my_msgs/msg/All", "float64 x", "All.idl")


def test_show_prints_the_file(share: Path) -> None:
    (share / "my_msgs" / "msg" / "Holder.msg").write_text("All all\n")
    for name, lines in {
        "All": MESSAGE.splitlines(),
        "Holder": ["All all", *(f"\t{line}" for line in MESSAGE.splitlines())],
    }.items():
        done = run_to_end([sys.executable, "-m", "tfloom", "interface", "show", f"my_msgs/msg/{name}"])
        assert (done.stdout.splitlines(), done.stderr) == (lines, "")
