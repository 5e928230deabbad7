"""Invalid command lines: every verb prints an error message, and none a traceback."""

from __future__ import annotations

import argparse
import io
import re
import sys
from pathlib import Path

import pytest
from test_usage import VERBS

from tfloom.cli import main as cli
from tfloom.cli.shared.numbers import finite, rate, whole

NAMES = [
    "",
    "/",
    "a b",
    "ü",
    "~",
    "-",
    "/1",
    "{",
    "\udcff",
    "a\nb",
    "..",
    "/tmp",
    "a/b/c/d",
    "x" * 5000,
]
BOMB = "[" + ", ".join(["&a0 [x]", *(f"&a{n} [{f'*a{n - 1}, ' * 9}]" for n in range(1, 20))]) + "]"
"""YAML whose aliases stand for more values than fit into memory."""
VALUES = [
    "",
    "{",
    "[1]",
    "5",
    "null",
    "{x: }",
    "{linear: {x: [1]}}",
    "{1: 2}",
    "{null: 1}",
    "{linear: !!python/object:os.system 1}",
    "{linear: *a}",
    "&a [*a]",
    "{linear: &a {x: *a}}",
    "linear: 2020-01-01",
    "{linear: {x: !!binary aGk=}}",
    '"\\x00"',
    "? {a: b}\n: c",
    "--- a\n--- b",
    "\t{}",
    "!!set {a}",
    "<<: 5",
    "\udcff",
    "{linear: !!int x}",
    "{linear: 2026-13-01}",
]
NUMBERS = ["nan", "-1", "abc", "", "1.5x", "9" * 20 + "x"]


def fails(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    """Run an invalid command line and return its stderr. An exception fails the test."""
    try:
        code = cli.main(list(words), prog="ros2")
    except SystemExit as end:
        code = int(end.code or 0)
    told = capsys.readouterr().err
    assert code in {1, 2}, (code, told)
    assert told.strip()
    assert "Traceback" not in told
    return told


@pytest.fixture(autouse=True)
def alone(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("tfloom.cli.shared.graph.MIN_WAIT_S", 0.0)
    monkeypatch.setattr("tfloom.cli.shared.graph.QUIET_S", 0.0)


ONE = ["topic info", "topic type", "topic echo", "node info", "service type", "service info", "service echo",
       "action type", "param dump", "lifecycle list", "interface show", "interface proto",
       "interface package", "pkg prefix", "pkg xml", "pkg create"]  # fmt: skip


@pytest.mark.parametrize("verb", ONE)
def test_invalid_names_are_rejected(
    verb: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO("nope/msg/X\n"))
    for name in NAMES:
        fails(capsys, *verb.split(), name)


@pytest.mark.parametrize("verb", ["topic pub", "service call", "service echo", "action send_goal"])
def test_unknown_types_are_rejected(verb: str, capsys: pytest.CaptureFixture[str]) -> None:
    for kind in [*NAMES, "os/path/join", "rclpy/msg/X", "std_msgs/action/String", "a/msg/B/c"]:
        if kind or verb != "service echo":
            fails(capsys, *verb.split(), "/x", kind)


@pytest.mark.parametrize(
    "words",
    [
        ("topic", "pub", "-1", "-w", "0", "/x", "geometry_msgs/msg/Twist"),
        ("service", "call", "--timeout", "0", "/x", "turtlesim/srv/Spawn"),
        ("param", "set", "/x", "p"),
    ],
)
def test_invalid_values_are_rejected(words: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    for value in VALUES:
        if value not in {"", "null"} or "pub" not in words:
            fails(capsys, *words, value)


@pytest.mark.parametrize(
    "words",
    [
        ("topic", "pub", "-1", "-w", "0", "/x", "geometry_msgs/msg/Twist"),
        ("service", "call", "--timeout", "0", "/x", "turtlesim/srv/Spawn"),
        ("action", "send_goal", "/x", "turtlesim/action/RotateAbsolute"),
        ("param", "set", "/x", "p"),
    ],
)
@pytest.mark.parametrize(
    ("value", "reason"), [(BOMB, "aliases stand for"), ("[" * 200, "nested deeper than")]
)
def test_values_beyond_yamls_limits_have_a_sentence(
    words: tuple[str, ...], value: str, reason: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert reason in fails(capsys, *words, value)


@pytest.mark.parametrize(
    ("value", "pair"),
    [
        ("{linear: {x:0.5}}", "x: 0.5"),
        ("{linear: {x:0.5, y: 1}}", "x: 0.5"),
        ("{linear: x:0.5}", "x: 0.5"),
        ("linear:1", "linear: 1"),
        ("linear:{x: 1}", "linear: {x"),
    ],
)
def test_a_space_that_is_missing_after_a_colon(
    value: str, pair: str, capsys: pytest.CaptureFixture[str]
) -> None:
    told = fails(capsys, "topic", "pub", "-1", "-w", "0", "/x", "geometry_msgs/msg/Twist", value)
    assert told.endswith(f"\na space is missing after the colon: {pair}\n")


@pytest.mark.parametrize("value", ["{linear: {q: 1}}", "{linear: a}", "{linear: {x: a:b}}", "[a]"])
def test_other_mistakes_miss_no_space(value: str, capsys: pytest.CaptureFixture[str]) -> None:
    told = fails(capsys, "topic", "pub", "-1", "-w", "0", "/x", "geometry_msgs/msg/Twist", value)
    assert "space" not in told


def type_of(verb: str, flag: str) -> object:
    return VERBS[verb]._option_string_actions[flag].type


FLAGS_WITH_NUMBERS = [
    (verb, flag)
    for verb, parser in VERBS.items()
    for flag in parser.flags()
    if getattr(type_of(verb, flag), "__module__", "") == "tfloom.cli.shared.numbers"
]


@pytest.mark.parametrize(("verb", "flag"), FLAGS_WITH_NUMBERS)
def test_invalid_numbers_are_rejected(verb: str, flag: str, capsys: pytest.CaptureFixture[str]) -> None:
    action = VERBS[verb]._option_string_actions[flag]
    for number in NUMBERS:
        if number == "-1" and action.type in {finite, whole, rate}:
            continue
        with pytest.raises(argparse.ArgumentTypeError, match=re.escape(repr(number))):
            action.type(number)
    told = fails(capsys, *verb.split(), f"{flag}=abc" if flag.startswith("--") else f"{flag}abc")
    assert any(name in told for name in action.option_strings)


def test_flags_with_numbers_exist() -> None:
    assert {flag for _, flag in FLAGS_WITH_NUMBERS} >= {
        "--timeout",
        "--rate",
        "--window",
        "--qos-depth",
        "--times",
    }
    assert not [
        verb for verb, parser in VERBS.items() for action in parser._actions if action.type in {int, float}
    ]


@pytest.mark.parametrize("number", ["inf", "1e308", "1e20"])
def test_very_long_durations_are_accepted(number: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = ("-1", "-w", "0", "--keep-alive", "0", "--spin-time", number)
    lease = ("--qos-liveliness-lease-duration-seconds", number)
    assert cli.main(["topic", "pub", *words, *lease, "/x", "std_msgs/msg/Empty"]) == 0
    assert cli.main(["topic", "list", "--spin-time", number]) == 0


def test_very_low_rates_are_accepted(capsys: pytest.CaptureFixture[str]) -> None:
    for low in ("1e-308", "1e308", "inf"):
        assert cli.main(["topic", "pub", "-r", low, "-t", "1", "-w", "0", "/x", "std_msgs/msg/Empty"]) == 0


@pytest.mark.parametrize(
    "words",
    [
        ("topic", "pub", "--stdin", "/x", "std_msgs/msg/String"),
        ("service", "call", "--stdin", "/x", "std_srvs/srv/Empty"),
        ("action", "send_goal", "--stdin", "/x", "turtlesim/action/RotateAbsolute"),
        ("interface", "show", "-"),
    ],
)
def test_closed_or_undecodable_input_is_rejected(
    words: tuple[str, ...], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stdin", None)
    assert fails(capsys, *words) == "standard input is closed\n"
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"\xff\xfe"), "utf-8"))
    assert fails(capsys, *words) == "ros2: octet 0xff of what was read isn't utf-8 text\n"


@pytest.mark.parametrize("domain", ["-1", "233", "abc", "1.5", "99999999999999999999", "ü"])
@pytest.mark.parametrize(
    "words", [("topic", "list"), ("node", "info", "/x"), ("topic", "echo", "/x"), ("doctor",)]
)
def test_invalid_domain_is_rejected(
    domain: str, words: tuple[str, ...], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", domain)
    if words == ("doctor",):
        assert cli.main(["doctor"]) == 1
        assert "ROS_DOMAIN_ID must be an integer from 0 to" in capsys.readouterr().out
    else:
        assert fails(capsys, *words).startswith("ROS_DOMAIN_ID must be an integer from 0 to")


@pytest.mark.parametrize("expression", ["", "m.x >", "import os", "raise", "(", "m = 1", "\x00"])
def test_invalid_expressions_are_rejected(expression: str, capsys: pytest.CaptureFixture[str]) -> None:
    for verb in ("echo", "hz"):
        told = fails(capsys, "topic", verb, "/x", "--filter", expression)
        assert told.startswith("--filter isn't a Python expression")


@pytest.mark.parametrize(
    "flags",
    [
        ("--node-name", ""),
        ("--node-name", "a b"),
        ("--node-name", "class"),
        ("--build-type", "x"),
        ("--destination-directory", "/proc/x"),
        ("--destination-directory", __file__),
        ("--dependencies", "a b"),
        ("--package-format", "2"),
    ],
)
def test_invalid_package_names_are_rejected(
    flags: tuple[str, str], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    fails(capsys, "pkg", "create", "my_pkg", *flags)
    assert not list(tmp_path.iterdir())
