"""Parameter values are read from text as by rcl, and written such that each comes back with its type."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from tfloom.launch.ros.utilities.parameter_text import parameter_file_text, parameter_rule, untyped_value
from tfloom.node.parameters.parameter import Parameter, get_parameter_value, parameter_value_to_python
from tfloom.node.parameters.parameter_file import checked_value, read_parameter_file
from tfloom.node.values.scalars import parse_documents, parse_scalar, parse_value
from tfloom.node.values.value_text import tree_text, value_text

LONG = "1" * 5000
# What rclpy 7.1.6 on rcl 9.2.8 makes of them.
SCALARS: dict[str, Any] = {
    "5": 5,
    "+5": 5,
    "05": 5,
    "017": 15,
    "08": 8.0,
    "0888": 888.0,
    "0x10": 16,
    "0X1F": 31,
    "0b1": "0b1",
    "0o7": "0o7",
    "1_000": "1_000",
    "1:30": "1:30",
    "2024-01-01": "2024-01-01",
    "9223372036854775807": 2**63 - 1,
    "9223372036854775808": 2.0**63,
    "-9223372036854775808": -(2**63),
    "0x8000000000000000": 2.0**63,
    "0" * 5000 + "7": 7,
    "1e3": 1000.0,
    "12e03": 12000.0,
    ".5": 0.5,
    "5.": 5.0,
    ".": ".",
    "1e": "1e",
    "1e400": "1e400",
    "-1e400": "-1e400",
    "1e-320": "1e-320",
    "1e-400": "1e-400",
    "0e-400": 0.0,
    LONG: LONG,
    "0x1p3": 8.0,
    "0x1.8": 1.5,
    "0x.8p1": 1.0,
    "0xp1": "0xp1",
    "0x": "0x",
    "0x1p99999": "0x1p99999",
    "0x1p-1074": 5e-324,
    "0x1p-1075": "0x1p-1075",
    "0x0p-9999": 0.0,
    "inf": math.inf,
    "-inf": -math.inf,
    "+INF": math.inf,
    "iNfInItY": math.inf,
    ".inf": math.inf,
    "-.Inf": -math.inf,
    "+.INF": math.inf,
    ".iNf": ".iNf",
    "nan": math.nan,
    "-NaN": math.nan,
    "nan(a1_)": math.nan,
    "nan(-)": "nan(-)",
    ".NaN": math.nan,
    "-.nan": "-.nan",
    "y": True,
    "On": True,
    "no": False,
    "yEs": "yEs",
    "tRUE": "tRUE",
    "~": "~",
    "null": "null",
}


def same(first: Any, second: Any) -> bool:
    """Return whether values are equal, and of one type; NaN is equal to itself."""
    return repr(first) == repr(second)


@pytest.mark.parametrize("text", SCALARS, ids=lambda text: text[:30])
def test_a_scalar_has_rcls_value(text: str) -> None:
    assert same(parse_scalar(text), SCALARS[text])
    assert same(parse_value(text), SCALARS[text])
    assert same(parse_value(f"'{text}'"), text)
    assert same(parse_value(f"!!str {text}"), text)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("a\n\tb", "a b"),
        ("|\n  5", 5),
        ("|\n  5\n", "5\n"),
        (">-\n  true", True),
        ("5\n---\n6", 6),
        ("--- 5", 5),
        ("!!binary aGk=", [b"h", b"i"]),
        ("{a: 1, a: 2, b: {c: 1}, b: {d: 2}}", {"a": 2, "b": {"c": 1, "d": 2}}),
        ("{p: &p {a: 1, b: 1}, q: {<<: *p, b: 2}}", {"p": {"a": 1, "b": 1}, "q": {"a": 1, "b": 2}}),
        ("{b: 2, <<: [{a: 1}, {a: 3, b: 3, c: 3}]}", {"a": 1, "b": 2, "c": 3}),
        ("{'<<': {a: 1}}", {"<<": {"a": 1}}),
        ("# nothing", ""),
    ],
)
def test_yaml_has_rcls_value(text: str, value: Any) -> None:
    assert same(parse_value(text), value) or parse_value(text) == value


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("x:", r"there is no value at line 1, column 3"),
        ("x: !!str", "there is no value"),
        ("x: |\ny: 1", "there is no value at line 1, column 4"),
        ("x: >-", "there is no value"),
        ("[a, !!str ]", "there is no value"),
        ("- 1\n-", "there is no value at line 2, column 2"),
        ("5\n---\n", "there is no value"),
        ("? [a]\n: 1", "a key is a list or a mapping at line 1, column 3"),
        ("a:\n- b: 1\na:\n  c: 1", "'a' is a list of mappings, and is there twice"),
        ("a: 1\n<<: 5", "'<<' is there without a mapping at line 2, column 1"),
        ("{<<: [{a: 1}, 5]}", "'<<' is there without a mapping"),
    ],
)
def test_a_missing_value_is_refused_with_its_place(text: str, problem: str) -> None:
    with pytest.raises(ValueError, match=problem):
        parse_value(text)


XML = """<?xml version="1.0"?>
<!-- a note: with a colon, and "quotes" -->
<robot name="r">	<link name="a"/>

    # [text
  <link name="b"/>   <!-- y: -->
</robot>"""


@pytest.mark.parametrize("text", [XML, f"\n\n{XML}\n", f"\ufeff{XML}", "<", "<a: b #c", "<<: 5"])
def test_xml_is_its_text_as_it_is(text: str) -> None:
    assert parse_value(text) == text
    assert get_parameter_value(text).string_value == text
    assert untyped_value(text) == text


@pytest.mark.parametrize("xml", [XML, f"\n \t{XML}", f"\ufeff\n{XML}", f"\u2003{XML}"])
def test_xml_in_a_rule_is_yaml_that_a_stock_ros_2_reads_too(xml: str) -> None:
    _, _, text = parameter_rule("x", xml).partition(":=")
    assert parse_documents(text) == [xml]
    assert parse_value(text) == xml


def test_all_documents_are_read() -> None:
    assert parse_documents("a: 1\n---\nb: &b 2\n...\n---\n&b 3\n") == [{"a": 1}, {"b": 2}, 3]
    assert parse_documents("") == []


VALUES: list[Any] = [
    *[text for text in SCALARS if text is not LONG],
    *[
        "",
        " ",
        " x ",
        "a: b",
        "@x",
        "# x",
        "[a]",
        "'q'",
        "a\nb",
        "a\n",
        "\t",
        "\x85",
        "a\u2028b",
        "\x07",
        "ä😀",
        "- a",
    ],
    *["---", "...", "a #b", "%a", "&a", "*a", "!a", "|", "\ufeff", "\xa0", "a\r\nb", "a: \x85 b"],
    *[
        1.0,
        1e20,
        -1e-7,
        5e-324,
        -2.5e-310,
        math.inf,
        -math.inf,
        math.nan,
        -0.0,
        0,
        -(2**63),
        2**63 - 1,
        True,
        False,
    ],
    *[["x", "y", "z"], ["08", "09"], ["a", "1e3"], ["a, b"], [""], ["a]"], ["a\nb", "\x85"], ["1", "true"]],
    *[[1.0, 2.5], [1e20], [math.inf, 1.0], [True, False], [1, 2], [b"\x00", b"\xff"], [b"7"]],
]


@pytest.mark.parametrize("value", VALUES, ids=repr)
def test_each_value_comes_back_with_its_type(value: Any, tmp_path: Path) -> None:
    assert "\n" not in value_text(value)
    assert same(checked_value("x", parse_value(value_text(value))), value)
    assert same(parameter_value_to_python(get_parameter_value(value_text(value))), value)
    rule = parameter_rule("x", value)
    assert rule.startswith("x:=")
    assert same(checked_value("x", parse_value(rule[3:])), value)
    for text in (
        parameter_file_text("/n", {"x": value}),
        tree_text({"/n": {"ros__parameters": {"x": value}}}),
    ):
        path = tmp_path / "p.yaml"
        path.write_text(text, "utf-8")
        (read,) = read_parameter_file(path)
        assert (read.node, read.name) == ("/n", "x")
        assert same(read.value, value)


def test_names_are_written_in_quotes_too() -> None:
    tree = {"/n": {"ros__parameters": {"y": 1, "1e3": 2, "a": [1], "b": [1]}}}
    assert parse_value(tree_text(tree)) == tree
    shared = [1]
    assert "&" not in tree_text({"a": shared, "b": shared})


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("y", "y"),
        ("N", "N"),
        ("yes", True),
        ("[x, y, z]", ["x", "y", "z"]),
        ("[1, 2.5]", [1.0, 2.5]),
        ("[1, a]", "[1, a]"),
        ("'1'", "1"),
        ("inf", math.inf),
        ("x:", "x:"),
        ("", ""),
        ("# c", "# c"),
    ],
)
def test_a_text_of_the_command_line_has_a_value(text: str, value: Any) -> None:
    message = get_parameter_value(text)
    assert same(parameter_value_to_python(message), value)
    assert message.type == Parameter("x", value=value).type_.value
