"""The table of verbs: usage, exit codes, and ends without traceback."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

import pytest
import transcript
from tests.conftest import run_to_end
from tests.each import for_each

from tfloom.cli import main as cli
from tfloom.cli.parser import Group, VerbCode, VerbParser, command_module, load_verb


def code_of(word: str, verb: str = "") -> VerbCode:
    command = cli.COMMANDS[word]
    return command.code_of(word, verb) if isinstance(command, Group) else (command_module(word), "")


def all_code() -> list[VerbCode]:
    return [
        code_of(word, verb)
        for word, command in cli.COMMANDS.items()
        for verb in (command.verbs if isinstance(command, Group) else [""])
    ]


@for_each(all_code())
def test_each_verb_of_the_table_has_both_functions(code: VerbCode) -> None:
    add_arguments, main = load_verb(code)
    assert callable(add_arguments)
    assert callable(main)


def test_all_functions_of_a_file_of_verbs_are_those_of_verbs_in_the_table() -> None:
    for word, command in cli.COMMANDS.items():
        if isinstance(command, Group) and command.file:
            names = vars(import_module(f"tfloom.cli.{command.file}"))
            verbs = {name.removesuffix("_main") for name in names if name.endswith("_main")}
            assert verbs == set(command.verbs) - set(command.own_files), word
            assert set(command.own_files) <= set(command.verbs), word


def test_commands_page_lists_exactly_the_verbs() -> None:
    page = (Path(__file__).parents[2] / "docs" / "commands.md").read_text("utf-8")
    first_table = page.split("| word | verbs |\n")[1].split("\n\n")[0]
    rows = [line.strip("|").split("|") for line in first_table.splitlines() if line.startswith("| `")]
    named = {
        word: set(re.findall(r"`(\w+)`", verbs)) if isinstance(cli.COMMANDS.get(word), Group) else set()
        for words, verbs in rows
        for word in re.findall(r"`(\w+)`", words)
    }
    table = {
        word: set(command.verbs) if isinstance(command, Group) else set()
        for word, command in cli.COMMANDS.items()
    }
    # The page states without the verbs that there is no daemon.
    assert named | {"daemon": set()} == table | {"daemon": set()}, (
        "docs/commands.md, its first table, and COMMANDS of src/tfloom/cli/main.py: a verb gets a place in both"
    )


@pytest.mark.parametrize("word", ["topic", "param", "run", "doctor"])
def test_flags_on_the_commands_page_exist(word: str) -> None:
    page = (Path(__file__).parents[2] / "docs" / "commands.md").read_text("utf-8")
    asked = re.findall(rf"`(?:ros2 )?{word} ?(\w*)[^`]*?(--[\w-]+)", page)
    for verb, flag in asked:
        add_arguments, _ = load_verb(code_of(word, verb))
        parser = VerbParser()
        add_arguments(parser)
        assert flag in parser.flags(), (word, verb, flag)


def test_no_verb_prints_help() -> None:
    answer = transcript.run_here()
    assert answer.exit_code == 0
    assert answer.text.startswith(
        "usage: ros2 [-h] [--use-python-default-buffering]\n"
        "            Call `ros2 <command> -h` for more detailed usage. ..."
    )
    for word in cli.COMMANDS:
        assert f"\n    {word} " in answer.text


def test_group_without_verb_prints_help() -> None:
    answer = transcript.run_here("topic")
    assert answer.exit_code == 0
    assert answer.text.startswith("usage: ros2 topic [-h] [--include-hidden-topics]\n")


@pytest.mark.skipif(sys.version_info >= (3, 12), reason="argparse words it anew in each version")
def test_unknown_verb_error_matches_the_recording() -> None:
    transcript.check("bad_verb")


def test_unknown_flag_of_a_verb_is_reported_by_the_main_parser() -> None:
    answer = transcript.run_here("topic", "list", "--no-such")
    assert answer.exit_code == 2
    assert answer.text.endswith("ros2: error: unrecognized arguments: --no-such")


@pytest.mark.parametrize(
    ("words", "near"),
    [
        (("topc", "list"), "topic"),
        (("topic", "ecko"), "echo"),
        (("topic", "list", "--show-typs"), "--show-types"),
        (("topic", "echo", "--qos-reliability", "relable", "/x"), "reliable"),
    ],
)
def test_misspelt_verb_flag_or_choice_gives_the_nearest(words: tuple[str, ...], near: str) -> None:
    answer = transcript.run_here(*words)
    assert answer.exit_code == 2
    assert answer.text.endswith(f"\ndid you mean {near}?")


def test_unknown_wire_gives_an_error_message() -> None:
    answer = transcript.run("topic", "list", env={**os.environ, "RMW_IMPLEMENTATION": "rmw_none"})
    assert answer.exit_code == 1
    assert answer.text.startswith("RMW_IMPLEMENTATION is 'rmw_none', which is none of: ")


def test_ctrl_c_ends_without_output(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def interrupted(_: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr("tfloom.cli.node.list_main", interrupted)
    assert cli.main(["node", "list", "--no-daemon"]) == signal.SIGINT
    assert capfd.readouterr() == ("", "")


@pytest.mark.skipif(os.name != "posix", reason="a process signals itself otherwise elsewhere")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signal_during_interpreter_exit_keeps_the_exit_code(number: int) -> None:
    """At exit, the interpreter restores the default action of signals that have handlers."""
    code = f"""
import os, sys
from tfloom.cli import main

class Late:
    def __del__(self):
        os.kill(os.getpid(), {int(number)})

late = Late()
sys.exit(main.main(prog="ros2"))
"""
    done = subprocess.run(
        [sys.executable, "-c", code, "topc"], stderr=subprocess.PIPE, timeout=60, check=False
    )
    assert done.returncode == 2, done


def test_terminated_command_leaves_the_domain(
    domain_id: int, start_program: Callable[..., object], wait_until: Callable[..., None]
) -> None:
    program = start_program("tfloom", "topic", "pub", "-n", "a_node", "/x", "std_msgs/msg/Empty")
    program.wait_for("publishing #1")
    assert transcript.run_here("node", "list").text == "/a_node"
    program.signal(signal.SIGTERM)
    assert program.wait() == 128 + signal.SIGTERM
    assert transcript.run_here("node", "list").text == ""
    assert "Traceback" not in program.output


@pytest.mark.skipif(os.name != "posix", reason="a pipe breaks differently elsewhere")
def test_closed_pipe_ends_without_output() -> None:
    code = "import sys; from tfloom.cli import main; sys.stdin.read(1)\nsys.exit(main.main(['topic', 'list', '-v']))"
    process = subprocess.Popen(
        [sys.executable, "-c", code],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env={**os.environ, "RMW_IMPLEMENTATION": "tfloom_local"},
    )
    assert process.stdout is not None
    process.stdout.close()  # Before it prints its first line.
    _, errors = process.communicate(b"x", timeout=60)
    assert errors == b""
    assert process.returncode == cli.PIPE_CLOSED


@pytest.mark.skipif(os.name != "posix", reason="closes a file descriptor")
def test_closed_output_gives_no_traceback() -> None:
    command = f"exec '{sys.executable}' -m tfloom pkg list >&-"
    done = run_to_end(["sh", "-c", command], timeout_s=30)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_full_disk_gives_an_error_message() -> None:
    command = f"exec '{sys.executable}' -m tfloom pkg list >/dev/full"
    done = run_to_end(["sh", "-c", command], timeout_s=30)
    assert (done.returncode, done.stderr) == (1, "tfloom: No space left on device\n")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
@pytest.mark.parametrize("stderr", [">/dev/full", ">&-"])
def test_hint_that_can_not_be_printed_ends_nothing(stderr: str, tmp_path: Path) -> None:
    command = f"exec '{sys.executable}' -m tfloom pkg create --build-type ament_python made 2{stderr}"
    done = subprocess.run(
        ["sh", "-c", command], cwd=tmp_path, stdout=subprocess.PIPE, text=True, timeout=60, check=False
    )
    assert done.returncode == 0
    assert (tmp_path / "made" / "package.xml").exists()
    assert "colcon build" not in done.stdout  # the hint is not among the results
