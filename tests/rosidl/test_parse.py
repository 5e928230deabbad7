"""Definition text: results, and errors with their place."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tfloom.rosidl import spec
from tfloom.rosidl.literal import parse_value
from tfloom.rosidl.parse import ParseError, parse_interface, parse_type
from tfloom.rosidl.type_text import split_type


def message(text: str) -> spec.Message:
    parsed = parse_interface(text, "my_msgs/msg/A")
    assert isinstance(parsed, spec.Message)
    return parsed


@pytest.mark.parametrize(
    ("text", "type_"),
    [
        ("float64", spec.Type("float64")),
        ("float64[36]", spec.Type("float64", 0, "array", 36)),
        ("uint8[]", spec.Type("uint8", 0, "unbounded")),
        ("string<=10[<=5]", spec.Type("string", 10, "bounded", 5)),
        ("wstring<=10", spec.Type("wstring", 10)),
        ("Point", spec.Type("my_msgs/msg/Point")),
        ("Header", spec.Type("std_msgs/msg/Header")),
        ("geometry_msgs/Point[]", spec.Type("geometry_msgs/msg/Point", 0, "unbounded")),
        ("geometry_msgs/msg/Point[2]", spec.Type("geometry_msgs/msg/Point", 0, "array", 2)),
    ],
)
def test_types_are_parsed(text: str, type_: spec.Type) -> None:
    assert parse_type(text, "my_msgs") == type_
    assert split_type(str(type_)) == tuple(type_)
    assert parse_type(str(type_)) == type_


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("int33", "'int33' is neither a primitive type nor a message's name"),
        ("float64[0]", "'float64[0]': the length must be 1 or more"),
        ("float64[<=0]", "'float64[<=0]': the length must be 1 or more"),
        ("float64[-1]", "'float64[-1]' is not a type"),
        ("float64[", "'float64[' is not a type"),
        ("float64<=5", "only strings have a bound of characters, 'float64' has none"),
        ("string<=0", "'string<=0': the bound must be 1 or more"),
        ("a/b/c/D", "'a/b/c/D' is neither a primitive type nor a message's name"),
        ("point", "'point' is neither a primitive type nor a message's name"),
    ],
)
def test_invalid_types_are_rejected(text: str, reason: str) -> None:
    with pytest.raises(ValueError) as raised:
        parse_type(text, "my_msgs")
    assert str(raised.value) == reason


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("int32 a\nint32", "2:6: 'int32' is not followed by a name"),
        ("\n  foo bar", "2:3: 'foo' is neither a primitive type nor a message's name"),
        ("int32 A", "1:7: 'A' is not a field name: lower case letters, digits and single underscores"),
        ("int32 a__b", "1:7: 'a__b' is not a field name: lower case letters, digits and single underscores"),
        ("int32 a_", "1:7: 'a_' is not a field name: lower case letters, digits and single underscores"),
        ("int32 a=5", "1:7: 'a' is not a constant's name: upper case letters, digits and underscores"),
        ("int32[2] A=5", "1:1: a constant has a plain primitive type, not 'int32[2]'"),
        ("int8 A=300", "1:8: 300 is outside int8's range [-128, 127]"),
        ("int8 A = ", "1:9: expected an integer, got nothing"),
        ("int8 a x", "1:8: expected an integer, got x"),
        ("float32 a x", "1:11: expected a number, got x"),
        ("bool a maybe", "1:8: expected true or false, got maybe"),
        ("int32 a\nint32 a", "2:7: 'a' is defined twice"),
        ("int32[2] a [1]", "1:12: int32[2] takes 2 values, got 1"),
        ("int32[<=2] a [1,2,3]", "1:14: int32[<=2] takes at most 2 values, got 3"),
        ("int32[] a 5", "1:11: expected a list in brackets, got 5"),
        ("string<=2 a 'abc'", "1:13: string<=2 takes at most 2 characters, got 3"),
        ("string a 'abc", "1:10: the quotes of 'abc don't match"),
        ("geometry_msgs/Point p 5", "1:23: a field of type 'geometry_msgs/msg/Point' takes no default"),
        ("int32 a\n---\nint32 b", "2:1: the definition has 0 lines '---', this is one too many"),
        ("= 5", "1:1: expected 'type name'"),
    ],
)
def test_errors_have_line_and_column(text: str, where: str) -> None:
    with pytest.raises(ParseError) as raised:
        message(text)
    assert str(raised.value) == f"my_msgs/msg/A.msg:{where}"
    assert f"{raised.value.line}:{raised.value.column}: " == where[: where.index(" ") + 1]


def test_parts_of_services_and_actions_are_parsed() -> None:
    with pytest.raises(
        ParseError, match=r"^a.srv:1:1: the definition has 1 of its 2 parts, divided by '---'$"
    ):
        parse_interface("int32 a", "my_msgs/srv/A", "a.srv")
    with pytest.raises(ParseError, match=r":2:1: the definition has 2 of its 3 parts, divided by '---'$"):
        parse_interface("int32 a\n---", "my_msgs/action/A")
    with pytest.raises(ParseError, match=r":3:1: the definition has 1 lines '---', this is one too many"):
        parse_interface("---\nint32 a\n---", "my_msgs/srv/A")
    action = parse_interface("int32 a\n---\n# Says how.\nint32 b\n---\n", "my_msgs/action/A")
    assert isinstance(action, spec.Action)
    assert [field.name for field in action.goal.fields + action.result.fields] == ["a", "b"]
    assert action.result.comment == "Says how."
    assert action.feedback.fields == ()
    assert [message.name for message in action.messages][3:6] == [
        f"my_msgs/action/A_SendGoal_{part}" for part in ("Request", "Response", "Event")
    ]


@pytest.mark.parametrize(
    "name", ["A", "my_msgs/msg/a", "my_msgs/idl/A", "My/msg/A", "my_msgs/msg/A_B", "a__b/msg/A"]
)
def test_invalid_names_are_rejected(name: str) -> None:
    with pytest.raises(ValueError, match="is not an interface name"):
        parse_interface("", name)


@pytest.mark.parametrize(
    ("type_text", "text", "value"),
    [
        ("int32", "0x10", 16),
        ("int32", "-007", -7),
        ("uint64", "18446744073709551615", 2**64 - 1),
        ("float64", "1e3", 1000.0),
        ("float32", "-inf", float("-inf")),
        ("bool", "True", True),
        ("bool", "0", False),
        ("byte", "255", b"\xff"),
        ("string", "plain words", "plain words"),
        ("string", r"'it\'s \t \\'", "it's \t \\"),
        ("string", '"a, b"', "a, b"),
        ("string[]", """["a, b", 'c']""", ["a, b", "c"]),
        ("int32[]", "[]", []),
        ("bool[2]", "[true, false]", [True, False]),
    ],
)
def test_values_are_parsed(type_text: str, text: str, value: spec.Value) -> None:
    assert parse_value(parse_type(type_text), text) == value


def test_comments_and_line_ends_are_parsed() -> None:
    parsed = message(
        "# One.\r\n# Two.\r\n\r\nint32 a\t# of a\r\nstring s 'x # y' # of s\nstring C=a 'b # c'#d"
    )
    assert parsed.comment == "One. Two."
    assert [(field.name, field.default, field.comment) for field in parsed.fields] == [
        ("a", None, "of a"),
        ("s", "x # y", "of s"),
    ]
    assert (parsed.constants[0].value, parsed.constants[0].comment) == ("a 'b # c'", "d")
    assert message("string s it's # a\n").fields[0].default == "it's"


@given(st.text(max_size=60))
def test_any_text_is_parsed_or_rejected_with_its_place(text: str) -> None:
    try:
        message(text)
    except ParseError as error:
        where = (error.line, error.column)
    else:
        return
    assert min(where) >= 1
