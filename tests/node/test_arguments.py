"""ROS arguments on a command line."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from tfloom.node.context.arguments import (
    RCLInvalidROSArgsError,
    UnknownROSArgsError,
    parse_arguments,
    remove_ros_args,
    warn_of_deprecated_remaps,
)
from tfloom.node.context.context import Context
from tfloom.node.log.log_output import LoggingSeverity
from tfloom.node.values.exceptions import RCLError
from tfloom.node.values.scalars import parse_value


def test_other_arguments_are_unchanged() -> None:
    line = ["prog", "a", "--ros-args", "-p", "x:=1", "--", "b", "--ros-args", "-r", "a:=b"]
    assert remove_ros_args(line) == ["prog", "a", "b"]


def test_node_name_and_namespace_are_remapped() -> None:
    parsed = parse_arguments(["--ros-args", "-r", "__node:=bob", "--remap", "__ns:=/here"])
    assert parsed.node_name("alice") == "bob"
    assert parsed.namespace("alice", "/") == "/here"


def test_rule_for_one_node_does_not_apply_to_others() -> None:
    parsed = parse_arguments(["--ros-args", "-r", "alice:__node:=bob", "-r", "alice:a:=b"])
    assert parsed.node_name("alice") == "bob"
    assert parsed.node_name("carol") == "carol"
    assert parsed.remap("/a", "alice", "/") == "/b"
    assert parsed.remap("/a", "carol", "/") is None


def test_topics_and_services_are_remapped_by_their_full_names() -> None:
    parsed = parse_arguments(
        [
            "--ros-args",
            "-r",
            "chatter:=/talk",
            "-r",
            "rosservice://s:=t",
            "-r",
            "rostopic://~/p:=q",
            "-r",
            "chatter:=late",
        ]
    )
    assert parsed.remap("/ns/chatter", "me", "/ns") == "/talk"
    assert parsed.remap("/chatter", "me", "/ns") is None
    assert parsed.remap("/ns/s", "me", "/ns", is_service=True) == "/ns/t"
    assert parsed.remap("/ns/s", "me", "/ns") is None
    assert parsed.remap("/ns/me/p", "me", "/ns") == "/ns/q"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1", 1),
        ("-0x10", -16),
        ("010", 8),
        ("1.5", 1.5),
        ("1e3", 1000.0),
        (".5", 0.5),
        ("-.inf", -math.inf),
        ("true", True),
        ("off", False),
        ("hello", "hello"),
        ("'1'", "1"),
        ("a b", "a b"),
        ("/turtle1/pose", "/turtle1/pose"),
        ("[1, 2]", [1, 2]),
        ("[1, 2.5]", [1.0, 2.5]),
        ("[a, 'b']", ["a", "b"]),
        ("''", ""),
        ("1.2.3", "1.2.3"),
        ("!!binary AQI=", [b"\x01", b"\x02"]),
        ("[!!binary AQ==, !!binary Ag==]", [b"\x01", b"\x02"]),
        ("!!str 5", "5"),
        ("!!str off", "off"),
        ("[!!str 1, !!str 2]", ["1", "2"]),
        ("!!float 5", 5),
    ],
)
def test_values_are_parsed_by_the_rules_of_ros(text: str, value: object) -> None:
    parsed_value = parse_value(text)
    assert parsed_value == value
    assert type(parsed_value) is type(value)
    parsed = parse_arguments(["--ros-args", "-p", f"x:={text}"])
    assert parsed.parameter_overrides("/any/node") == {"x": value}


def test_last_value_takes_precedence_and_a_node_can_be_named() -> None:
    parsed = parse_arguments(["--ros-args", "-p", "x:=1", "-p", "x:=2", "-p", "bob:x:=3", "-p", "bob:y:=4"])
    assert parsed.parameter_overrides("/alice") == {"x": 2}
    assert parsed.parameter_overrides("/ns/bob") == {"x": 3, "y": 4}


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (["-r"], "-r needs a value: \\[node:\\]from:=to"),
        (["-p", "x=1"], "cannot understand '-p x=1'"),
        (["-p", "x:="], "has no value"),
        (["-p", "x:=[1, "], "not valid YAML"),
        (["-p", "x:={a: 1}"], "can't be a mapping"),
        (["-p", "x:=[1, a]"], "the list of 'x' must be of one scalar type, not int, str"),
        (["-p", "x:=[[1]]"], "the list of 'x' must be of one scalar type, not list"),
        (["-r", "a b:=c"], "'a b': topic name must not contain"),
        (["-r", "__node:=a/b"], "'a/b': node name must not contain"),
        (["-r", "__ns:=/a b"], "namespace must not contain"),
        (["-r", "__ns:=a"], "namespace must be absolute"),
        (["-r", "{node}:=a"], "a rule has no substitutions"),
        (["-r", "a:=b__c"], "a rule has no"),
        (["-r", "__node:=b__c"], "a rule has no"),
        (["--log-level", "loud"], "'loud' is not a level; known are unset, debug"),
        (["--params-file", "/no/such/file"], "No such file"),
        (["--log-file-name", "a/b"], "without a directory"),
        (["-e", "robot"], "enclave must be absolute"),
    ],
)
def test_invalid_arguments_raise_with_the_reason(arguments: list[str], text: str) -> None:
    with pytest.raises(RCLInvalidROSArgsError, match=text):
        parse_arguments(["--ros-args", *arguments])


LONG = "x" * 300


@pytest.mark.parametrize(
    "arguments",
    [
        ["-p", f"x=:{LONG}"],
        ["-p", f"{LONG} :=1"],
        ["-p", f"x:=[1, {LONG}]"],
        ["-r", LONG],
        ["-r", f"a:={LONG}!"],
        ["-r", f"{{{LONG}}}:=a"],
        ["-e", LONG],
        ["--log-level", LONG],
        ["--log-file-name", f"a/{LONG}"],
        ["<robot", *LONG],
    ],
    ids=lambda arguments: arguments[1][:10],
)
def test_an_error_shows_the_beginning_of_a_long_value(arguments: list[str]) -> None:
    with pytest.raises((RCLInvalidROSArgsError, UnknownROSArgsError)) as caught:
        parse_arguments(["--ros-args", *arguments])
    said = str(caught.value)
    assert max(map(len, re.findall("x+", said))) <= 200
    assert len(said) < 700
    assert "…" in said


def test_a_description_is_a_value() -> None:
    text = '<robot name="r">\n  <!-- a: b -->\n</robot>'
    parsed = parse_arguments(["--ros-args", "-p", f"robot_description:={text}"])
    assert parsed.parameter_overrides("/any/node") == {"robot_description": text}


def test_all_unknown_arguments_are_named() -> None:
    with pytest.raises(UnknownROSArgsError, match=r"\['--nope', 'x'\]"):
        parse_arguments(["--ros-args", "--nope", "x"])


FLAGS = {
    "-r": ("a:=b", "nothing"),
    "--remap": ("a:=b", ":=b"),
    "-p": ("x:=1", "x"),
    "--param": ("x:=1", ":=1"),
    "--params-file": (None, "/not/there.yaml"),
    "--log-level": ("debug", "loud"),
    "--log-file-name": ("mine", "a/b"),
    "--log-config-file": ("spdlog.conf", ""),
    "-e": ("/robot", "robot"),
    "--enclave": ("/robot", "/a//b"),
}
SWITCHES = [
    f"--{to}able-{what}-logs" for to in ("en", "dis") for what in ("rosout", "stdout", "external-lib")
]


@pytest.mark.parametrize("flag", FLAGS)
def test_each_flag_takes_its_value_or_names_the_expected_one(flag: str, tmp_path: Path) -> None:
    good, bad = FLAGS[flag]
    if good is None:
        (tmp_path / "p.yaml").write_text("/**:\n  ros__parameters:\n    x: 1\n")
        good = str(tmp_path / "p.yaml")
    parse_arguments(["prog", "--ros-args", flag, good])
    with pytest.raises(RCLInvalidROSArgsError, match=f"cannot understand '{flag} "):
        parse_arguments(["prog", "--ros-args", flag, bad])
    with pytest.raises(RCLInvalidROSArgsError, match=f"{flag} needs a value: "):
        parse_arguments(["prog", "--ros-args", flag])


@pytest.mark.parametrize("switch", SWITCHES)
def test_each_switch_is_accepted(switch: str) -> None:
    attribute = switch.removeprefix("--enable-").removeprefix("--disable-").replace("-", "_")
    parsed = parse_arguments(["prog", "--ros-args", switch])
    assert getattr(parsed, attribute) is switch.startswith("--enable")
    assert parsed.rest == ["prog"]


def test_log_configuration_file_is_rejected_at_init() -> None:
    line = ["prog", "--ros-args", "--log-config-file", "spdlog.conf"]
    context = Context()
    with pytest.raises(
        RCLError, match=r"failed to initialize logging: --log-config-file spdlog\.conf: the logg"
    ):
        context.init(line)
    assert not context.ok()
    context.init([*line, "--disable-external-lib-logs"])
    context.destroy()


def test_log_levels_are_parsed() -> None:
    parsed = parse_arguments(["--ros-args", "--log-level", "debug", "--log-level", "a.b:=ERROR"])
    assert parsed.log_levels == [("", LoggingSeverity.DEBUG), ("a.b", LoggingSeverity.ERROR)]


FILE = """
/**:
  ros__parameters:
    everywhere: 1
/ns/alice:
  ros__parameters:
    text: "12"
    nested: {deep: {x: 1.0}}
    list: [1, 2.5]
ns:
  bob:
    ros__parameters:
      everywhere: 2
/*/carol:
  ros__parameters:
    only: [a, b]
"""


def test_parameter_file_is_read_per_node(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(FILE)
    parsed = parse_arguments(["--ros-args", "--params-file", str(path), "-p", "last:=1"])
    assert parsed.parameter_overrides("/ns/alice") == {
        "everywhere": 1,
        "text": "12",
        "nested.deep.x": 1.0,
        "list": [1.0, 2.5],
        "last": 1,
    }
    assert parsed.parameter_overrides("/ns/bob") == {"everywhere": 2, "last": 1}
    assert parsed.parameter_overrides("/x/carol") == {"everywhere": 1, "only": ["a", "b"], "last": 1}
    assert parsed.parameter_overrides("/x/y/carol") == {"everywhere": 1, "last": 1}


@pytest.mark.parametrize(
    ("pattern", "is_meant"),
    [
        ("/**", True),
        ("/*/remote", True),
        ("/ns/*", True),
        ("/ns/remote", True),
        ("/**/remote", True),
        ("/*", False),
        ("/other/remote", False),
        ("/*/*/remote", False),
        ("remote", False),
        ("/ns/remot", False),
    ],
)
def test_pattern_of_a_parameter_file_matches_some_nodes(tmp_path: Path, pattern: str, is_meant: bool) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(f"{pattern}:\n  ros__parameters:\n    x: 1\n")
    parsed = parse_arguments(["--ros-args", "--params-file", str(path)])
    assert bool(parsed.parameter_overrides("/ns/remote")) == is_meant


LAUGHS = "\n".join(
    [
        "a0: &a0 [lol, lol]",
        *(f"a{n}: &a{n} [*a{n - 1}, *a{n - 1}, *a{n - 1}, *a{n - 1}]" for n in range(1, 40)),
    ]
)


@pytest.mark.parametrize("flag", ["-p", "--param"])
def test_an_argument_beyond_yamls_limits_is_refused(flag: str) -> None:
    bombs = ", ".join(["&a0 [lol]", *(f"&a{n} [{f'*a{n - 1}, ' * 9}]" for n in range(1, 20))])
    with pytest.raises(RCLInvalidROSArgsError, match="its aliases stand for more than 1000000 values"):
        parse_arguments(["--ros-args", flag, f"x:=[{bombs}]"])


@pytest.mark.parametrize(
    ("content", "text"),
    [
        ("[1]", "mapping of node names"),
        ("a: 1", "/a: expected 'ros__parameters' below it"),
        ("a: {ros__parameters: 1}", "must hold names and values"),
        ("a: {ros__parameters: {x: [1, a]}}", "list of 'x' must be of one scalar type"),
        ("a: {ros__parameters: {x: [[1]]}}", "list of 'x' must be of one scalar type"),
        ("a: [", r"p\.yaml: it is not valid YAML: expected the node content, .* at line 1, column 5"),
        ("a: &x {ros__parameters: {x: *x}}", r"p\.yaml: the alias \*x contains itself at line 1, column 29"),
        (
            LAUGHS,
            r"p\.yaml: its aliases stand for more than 1000000 values and characters at line 10, column ",
        ),
        ("[" * 300, r"p\.yaml: it is nested deeper than 100 levels at line 1, column 101"),
    ],
)
def test_malformed_parameter_file_raises_with_the_place(content: str, text: str, tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(content)
    with pytest.raises(RCLInvalidROSArgsError, match=text):
        parse_arguments(["--ros-args", "--params-file", str(path)])


@pytest.mark.parametrize(
    ("rule", "is_meant"),
    [
        ("/ns/remote:x:=1", True),
        ("ns/remote:x:=1", True),
        ("remote:x:=1", True),
        ("/**:x:=1", True),
        ("**:x:=1", True),
        ("/*/remote:x:=1", True),
        ("/ns/*:x:=1", True),
        ("**/remote:x:=1", True),
        ("*:x:=1", False),
        ("/*:x:=1", False),
        ("/remote:x:=1", False),
        ("other:x:=1", False),
    ],
)
def test_pattern_of_a_rule_matches_as_in_a_file(rule: str, is_meant: bool) -> None:
    parsed = parse_arguments(["--ros-args", "-p", rule])
    assert parsed.parameter_overrides("/ns/remote") == ({"x": 1} if is_meant else {})


@pytest.mark.parametrize(
    "name",
    [
        "a b",
        "a=b",
        '"x"',
        " x",
        "x ",
        ":x",
        "5",
        "x.5",
        "x-y",
        "é",
        "x..y",
        ".x",
        "x.",
        "~x",
        "__x",
        "a.__b",
        "{node}",
    ],
)
def test_a_rule_for_what_is_no_parameter_is_refused(name: str) -> None:
    for rule in (f"{name}:=1", f"remote:{name}:=1"):
        with pytest.raises(RCLInvalidROSArgsError, match="is not a parameter's name"):
            parse_arguments(["--ros-args", "-p", rule])


def test_a_long_name_is_read_in_time() -> None:
    with pytest.raises(RCLInvalidROSArgsError):
        parse_arguments(["--ros-args", "-p", f"{'a' * 5000}!:=1"])
    with pytest.raises(RCLInvalidROSArgsError):
        parse_arguments(["--ros-args", "-p", f"{'a/' * 5000}!:=1"])


def test_rules_of_ros_1_act_with_a_warning(capfd: pytest.CaptureFixture[str]) -> None:
    words = ["program", "chat:=x", "__node:=q", "__ns:=/s", "word", "a b:=c", "x:=5", ":=x", "x:="]
    parsed = parse_arguments([*words, "--ros-args", "-r", "chat:=y"])
    assert parsed.rest == ["program", "word", "a b:=c", "x:=5", ":=x", "x:="]
    assert parsed.node_name("nd") == "q"
    assert parsed.namespace("nd", "/") == "/s"
    assert parsed.remap("/s/chat", "q", "/s") == "/s/x"
    warn_of_deprecated_remaps(parsed)
    lines = capfd.readouterr().err.splitlines()
    assert [line.partition("[rcl]: ")[2] for line in lines] == [
        f"Found remap rule '{rule}'. This syntax is deprecated. Use '--ros-args --remap {rule}' instead."
        for rule in ("chat:=x", "__node:=q", "__ns:=/s")
    ]


@pytest.mark.parametrize("key", ["the_n*", "/a/", "//a", "''", "a b", "a-b", "/a/**b", "5"])
def test_a_file_for_what_is_no_node_is_refused(tmp_path: Path, key: str) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(f"{key}:\n  ros__parameters:\n    x: 1\n")
    with pytest.raises(RCLInvalidROSArgsError, match="is not a name of nodes"):
        parse_arguments(["--ros-args", "--params-file", str(path)])


def test_the_root_may_hold_nodes_in_a_file(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(
        "/:\n  remote:\n    ros__parameters:\n      x: 1\n---\n/remote: {ros__parameters: {y: 2}}\n"
    )
    parsed = parse_arguments(["--ros-args", "--params-file", str(path)])
    assert parsed.parameter_overrides("/remote") == {"x": 1, "y": 2}
