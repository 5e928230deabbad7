"""Names that are picked from a list: with a fake fzf, by their numbers, and without a terminal."""

from __future__ import annotations

import os
import stat
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.terminals import on_a_terminal

from tfloom.cli.main import COMMANDS
from tfloom.cli.parser import VerbParser, build_parser
from tfloom.cli.shared import picking
from tfloom.cli.topic import rates

PROGRAM = """
import sys
import rclpy
from rclpy.action import ActionServer
from std_msgs.msg import Int32, String
from tfloom.cli.main import main
rclpy.init()
node = rclpy.create_node("talker", start_parameter_services=False)
ends = [node.create_publisher(String, "/words", 1), node.create_publisher(Int32, "/numbers", 1)]
print("exit", main({words!r}, prog="ros2"))
"""
FZF = """#!/bin/sh
echo "$@" > "$SEEN"
cat >> "$SEEN"
printf '%s' "$CHOSEN"
exit $CODE
"""
NAMES = ["/numbers", "/parameter_events", "/rosout", "/words"]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder for the PATH, with a fake fzf, which notes its arguments and its input in `seen`."""
    path = tmp_path / "bin" / "fzf"
    path.parent.mkdir()
    path.write_text(FZF)
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path.parent


def by_fzf(folder: Path, words: list[str], chosen: str, code: int = 0) -> tuple[str, list[str]]:
    """Return what a verb prints on a terminal, and the lines that fzf has seen."""
    seen = folder.parent / "seen"
    text = on_a_terminal(
        PROGRAM.format(words=words),
        PATH=f"{folder}:{os.environ['PATH']}",
        SEEN=str(seen),
        CHOSEN=chosen,
        CODE=str(code),
    )
    return text, seen.read_text().splitlines()


def test_a_name_is_picked_by_fzf(folder: Path) -> None:
    text, seen = by_fzf(folder, ["topic", "type"], "/words\n")
    assert text == "std_msgs/msg/String\nexit 0\n"
    assert seen == ["--prompt=topic name> ", *NAMES]


def test_what_follows_from_a_name_needs_no_question(folder: Path) -> None:
    text, seen = by_fzf(folder, ["topic", "pub", "--once", "-w", "0"], "/numbers\n")
    assert "std_msgs.msg.Int32(data=0)" in text
    assert text.endswith("exit 0\n")
    assert seen[0] == "--prompt=topic name> "


@pytest.mark.parametrize(
    ("chosen", "code", "said"),
    [
        ("", 130, "exit 2\n"),
        ("", 1, "nothing was picked\nexit 1\n"),
        ("/other\n", 0, "nothing was picked\nexit 1\n"),
        ("", 2, "/fzf has ended with exit code 2\nexit 1\n"),
    ],
)
def test_nothing_is_picked(chosen: str, code: int, said: str, folder: Path) -> None:
    text, _ = by_fzf(folder, ["topic", "type"], chosen, code)
    assert text.endswith(said)
    assert "String" not in text


def test_an_fzf_that_cannot_be_run(folder: Path) -> None:
    (folder / "fzf").write_bytes(b"\x7fELF nonsense")
    text = on_a_terminal(PROGRAM.format(words=["topic", "type"]), PATH=f"{folder}:{os.environ['PATH']}")
    assert "fzf can't be run: Exec format error\nexit 1\n" in text


def by_number(folder: Path, words: list[str], typed: str) -> str:
    """Return what a verb prints on a terminal without fzf."""
    (folder / "fzf").unlink()
    return on_a_terminal(PROGRAM.format(words=words), typed=typed, PATH=str(folder))


@pytest.mark.parametrize("typed", ["4\n", "/words\n", "wor\n", "0\n5\n1 2\nr\n\nnone\n4\n"])
def test_a_name_is_picked_by_its_number(typed: str, folder: Path) -> None:
    text = by_number(folder, ["topic", "type"], typed)
    assert "".join(f"{number}  {name}\n" for number, name in enumerate(NAMES, 1)) in text
    assert text.count("topic name (number or name):\n") == typed.count("\n")
    assert text.endswith("std_msgs/msg/String\nexit 0\n")


def test_the_end_of_the_input_ends_the_question(folder: Path) -> None:
    assert by_number(folder, ["topic", "type"], "\x04").endswith("nothing was picked\nexit 1\n")


def test_there_is_nothing_to_pick_from(folder: Path) -> None:
    text = by_number(folder, ["action", "info"], "")
    assert text == "there is no action name to pick from\nexit 1\n"


@pytest.mark.parametrize(
    "words", [["topic", "echo"], ["topic", "hz"], ["interface", "show"], ["node", "info"]]
)
def test_without_a_terminal_nothing_can_be_picked(words: list[str]) -> None:
    lyrical = refusal(words, "lyrical")
    assert lyrical == "Error: Interactive selection requires a TTY terminal.\n"
    if words != ["topic", "hz"]:
        assert "error: the following arguments are required: " in refusal(words, "kilted")
    # A value, which is free text, can't be picked from a list.
    assert "arguments are required: node_name, parameter_name, value" in refusal(["param", "set"], "lyrical")


def refusal(words: list[str], distribution: str) -> str:
    environment = os.environ | {"RMW_IMPLEMENTATION": "tfloom_local", "ROS_DISTRO": distribution}
    done = run_to_end([sys.executable, "-m", "tfloom", *words], env=environment)
    assert done.returncode != 0
    assert not done.stdout
    return done.stderr


def verb(*words: str) -> VerbParser:
    parser = build_parser("ros2", COMMANDS, pick=picking.values_of_missing)
    for word in words:
        parser = parser.words[word]
    parser.fill()
    return parser


def test_several_names_are_picked(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picking, "find_offer", lambda *_: lambda _: ["/a", "a", "/c", "/b", "-x", "", "/b\n"])
    monkeypatch.setattr(picking, "has_terminal", lambda: True)
    for name, value in {
        "PATH": f"{folder}:{os.environ['PATH']}",
        "SEEN": f"{folder}/seen",
        "CODE": "0",
    }.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setenv("CHOSEN", "/c\n/a\n")
    hz = verb("topic", "hz")
    assert rates.topics_of(hz.parse_args([])) == ["/c", "/a"]
    assert (folder / "seen").read_text().split("\n") == ["--prompt=topic name>  --multi", "/a", "/b", "/c"]
    assert rates.topics_of(hz.parse_args(["--all"])) == []
    describe = verb("param", "describe")
    parsed = describe.parse_args([])
    assert (parsed.node_name, parsed.parameter_names) == ("/c", ["/c", "/a"])


def test_arguments_that_are_given_are_not_picked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picking, "has_terminal", lambda: True)
    monkeypatch.setattr(picking, "picked", lambda *_, **__: pytest.fail("it asks"))
    assert verb("topic", "type").parse_args(["/a"]).topic_name == "/a"
    with pytest.raises(SystemExit):  # the type alone is missing, whose place is behind a name
        verb("topic", "pub").parse_args(["/a"])
    with pytest.raises(SystemExit):
        verb("topic", "type").parse_args(["/a", "/b"])
