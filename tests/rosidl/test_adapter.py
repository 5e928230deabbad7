"""The specifications of `rosidl_adapter.parser`."""

from __future__ import annotations

from pathlib import Path

import pytest
from rosidl_adapter.parser import (
    BaseType,
    Constant,
    Field,
    InvalidActionSpecification,
    InvalidFieldDefinition,
    InvalidResourceName,
    InvalidServiceSpecification,
    InvalidValue,
    MessageSpecification,
    Type,
    UnknownMessageType,
    parse_action_string,
    parse_message_file,
    parse_message_string,
    parse_service_string,
    validate_field_types,
)

from tfloom.rosidl.definition_files import own_folders


def test_message() -> None:
    message = parse_message_string(
        "pkg",
        "Foo",
        "# A foo.\nuint8 A=3 # first\nstring S='it s'\nbyte B=7\nPoint[2] points\n"
        'string<=5[<=3] names ["a", "b"] # who\nfloat32 x 1.5\nother/msg/Bar bar\n',
    )
    assert (str(message.base_type), message.msg_name) == ("pkg/Foo", "Foo")
    assert message.annotations["comment"] == ["A foo."]
    assert [(c.type, c.name, c.value) for c in message.constants] == [
        ("uint8", "A", 3),
        ("string", "S", "it s"),
        ("byte", "B", 7),
    ]
    assert message.constants[0].annotations["comment"] == ["first"]
    points, names, x, bar = message.fields
    assert (points.type.pkg_name, points.type.type, points.type.array_size) == ("pkg", "Point", 2)
    assert points.type.is_fixed_size_array()
    assert not points.type.is_primitive_type()
    assert (names.type.string_upper_bound, names.type.array_size, names.type.is_upper_bound) == (5, 3, True)
    assert names.type.is_dynamic_array()
    assert (names.default_value, names.annotations["comment"]) == (["a", "b"], ["who"])
    assert (str(x), x.default_value, str(bar.type)) == ("float32 x 1.5", 1.5, "other/Bar")


COMMENTS = """\
# one
#
# two

## a
#
#
#  b
int32 v # c [m/s]
  # d
#
# e
bool K=true

# f
\t
bool w
string t # [1, 2] and [m] and [s]
"""


def test_comments_and_units() -> None:
    message = parse_message_string("pkg", "Foo", COMMENTS)
    assert message.annotations == {"comment": ["one", "", "two"]}
    v, w, t = message.fields
    assert v.annotations == {"comment": ["a", "", " b", "c", "d"], "unit": "m/s"}
    assert message.constants[0].annotations == {"comment": ["e"]}
    assert w.annotations == {"comment": ["f"]}
    assert t.annotations == {"comment": ["[1, 2] and [m] and [s]"]}  # which of the two is the unit?
    service = parse_service_string("pkg", "Ask", "# ask\nint8 a # [V]\n---\n# answer\n\n# b\nbool b\n")
    assert service.request.annotations == {"comment": ["ask"]}
    assert service.request.fields[0].annotations == {"comment": [], "unit": "V"}
    assert service.response.annotations == {"comment": ["answer"]}
    assert service.response.fields[0].annotations == {"comment": ["b"]}


def test_text_of_a_message() -> None:
    text = 'int32[<=3] a [1,2] # x\nstring<=5 b "q"\nfloat64 K=1.5\nstring S="x y"\nstd_msgs/Header h\nbool c true\n'
    assert str(parse_message_string("pkg", "Foo", text)).splitlines() == [
        "# pkg/Foo",
        "float64 K=1.5",
        "string S='x y'",
        "int32[<=3] a [1, 2]",
        "string<=5 b 'q'",
        "std_msgs/Header h",
        "bool c True",
    ]
    assert str(parse_message_string("pkg", "Foo", "")) == "# pkg/Foo"


def test_service_and_action() -> None:
    service = parse_service_string("pkg", "Ask", "int8 a\n---\nbool b\n")
    assert (service.srv_name, service.pkg_name) == ("Ask", "pkg")
    assert str(service) == "# pkg/Ask\n# pkg/Ask_Request\nint8 a\n---\n# pkg/Ask_Response\nbool b"
    assert str(service.request.base_type) == "pkg/Ask_Request"
    assert service.response.fields == [Field(Type("bool"), "b")]
    action = parse_action_string("pkg", "Go", "int8 a\n---\nbool b\n---\nstring c\n")
    assert [part.msg_name for part in (action.goal, action.result, action.feedback)] == [
        "Go_Goal",
        "Go_Result",
        "Go_Feedback",
    ]


@pytest.mark.parametrize(
    "path", sorted(path for f in own_folders() for path in f.rglob("*.msg"))[::9], ids=str
)
def test_message_files(path: Path) -> None:
    message = parse_message_file(path.parts[-3], str(path))
    assert str(message.base_type) == f"{path.parts[-3]}/{path.stem}"


def test_errors() -> None:
    with pytest.raises(InvalidFieldDefinition, match=r":2:\d+: .*Foo"):
        parse_message_string("pkg", "A", "int8 a\nint8 Foo\n")
    with pytest.raises(ValueError, match="'a' is defined twice"):
        parse_message_string("pkg", "A", "int8 a\nint8 a\n")
    with pytest.raises(InvalidServiceSpecification, match="1 of its 2 parts"):
        parse_service_string("pkg", "A", "")
    with pytest.raises(InvalidActionSpecification, match="2 of its 3 parts"):
        parse_action_string("pkg", "A", "---")
    with pytest.raises(InvalidResourceName):
        parse_message_string("pkg", "a", "")
    with pytest.raises(InvalidResourceName):
        BaseType("pkg/point")
    with pytest.raises(InvalidValue, match="'x' can not be converted to type 'int8'"):
        Field(Type("int8"), "a", "x")
    with pytest.raises(TypeError, match="does not contain a"):
        Type("bool]")
    with pytest.raises(ValueError, match="must not be 'None'"):
        Constant("bool", "X", None)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="field 0 must be a 'Field' instance, not 'x'"):
        MessageSpecification("pkg", "A", ["x"], [])  # type: ignore[list-item]
    with pytest.raises(TypeError, match="> 0"):
        Type("int8[0]")
    with pytest.raises(NameError):
        Constant("int8", "a", "1")
    with pytest.raises(ValueError, match="a"):
        MessageSpecification("pkg", "A", [Field(Type("int8"), "a"), Field(Type("bool"), "a")], [])


def test_types_of_fields_are_validated() -> None:
    message = parse_message_string("pkg", "A", "Point[] p\nint8 a\n")
    validate_field_types(message, [BaseType("pkg/Point")])
    with pytest.raises(UnknownMessageType, match=r"pkg/Point\[\] p"):
        validate_field_types(message, [BaseType("pkg/Pose")])
