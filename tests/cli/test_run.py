"""`run`: search for a program, and exit codes of tfloom's and of a workspace's programs."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from pathlib import Path

import pytest
import transcript
from tests.conftest import has_ended
from tests.each import for_each

from tfloom.cli import main as cli
from tfloom.cli import run
from tfloom.workspace import index

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the programs under test are scripts")


@pytest.fixture
def add_program(prefix: Path) -> Callable[..., Path]:
    """Put a Python program into the package `my_pkg` of a workspace."""

    def add(name: str, code: str) -> Path:
        path = prefix / "lib" / "my_pkg" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!{sys.executable}\n{code}\n")
        path.chmod(0o755)
        return path

    return add


@pytest.fixture
def run_verb(capfd: pytest.CaptureFixture[str]) -> Callable[..., tuple[str, int]]:
    """Run `run …` in this process; return what it and its program printed, and its exit code."""

    def run(*words: str) -> tuple[str, int]:
        code = cli.main(["run", *words], prog="ros2")
        return "".join(capfd.readouterr()).rstrip("\n"), code

    return run


@pytest.mark.parametrize("name", ["run_bad_pkg", "run_bad_exe"])
def test_unknown_package_or_program_error_matches_ros2(name: str) -> None:
    transcript.check(name)


def test_misspelt_package_or_program_gives_the_nearest(add_program: Callable[..., Path]) -> None:
    add_program("my_program", "")
    for words, said in (
        (("turtlesm", "x"), "Package 'turtlesm' not found\ndid you mean turtlesim"),
        (("my_pk", "x"), "Package 'my_pk' not found\ndid you mean my_pkg?"),
        (("turtlesim", "turtlesim_nod"), "No executable found\ndid you mean turtlesim_node"),
        (("my_pkg", "my_progam"), "No executable found\ndid you mean my_program?"),
    ):
        answer = transcript.run_here("run", *words)
        assert answer.exit_code == 1
        assert answer.text.startswith(said)


def test_program_that_is_hidden_is_named_with_the_remedy(add_program: Callable[..., Path]) -> None:
    hidden = add_program("hidden", "")
    hidden.chmod(0o644)
    answer = transcript.run_here("run", "my_pkg", "hidden")
    assert answer.text.startswith(
        f"No executable found: {hidden} is not marked as executable: chmod +x {hidden}\n"
    )
    stray = hidden.parents[2] / "bin" / "stray"
    stray.parent.mkdir()
    stray.touch()
    answer = transcript.run_here("run", "my_pkg", "stray")
    assert answer.exit_code == 1
    assert answer.text == (
        f"No executable found: it is {stray}, not in lib/my_pkg: setup.cfg lacks two lines: "
        "[install] and below it install_scripts=$base/lib/my_pkg"
    )


def test_a_package_alone_lists_its_programs(
    add_program: Callable[..., Path], capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("two", "one"):
        add_program(name, "")
    for words, hint in (
        (("turtlesim",), f"turtlesim has: {', '.join(sorted(index.PROGRAMS['turtlesim']))}"),
        (("my_pkg",), "my_pkg has: one, two"),
        (("--prefix", "x", "my_pkg"), "my_pkg has: one, two"),
        (("std_msgs",), "std_msgs has: no programs"),
        (("turtlesm",), "Package 'turtlesm' not found\ndid you mean turtlesim "),
        ((), "are required: package_name, executable_name"),  # before Python 3.14 also argv
    ):
        with pytest.raises(SystemExit, match="2"):
            cli.main(["run", *words])
        told = capsys.readouterr().err
        assert told.startswith("usage: tfloom run [-h] [--prefix PREFIX] package_name executable_name ...\n")
        assert hint in told


def test_a_package_without_programs_is_found(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["run", "std_msgs", "x"]) == 1
    assert capsys.readouterr().err == "No executable found\n"


@pytest.mark.parametrize(("quote", "options"), [("", ""), ('"', ""), ('"', " -x")])
def test_script_whose_interpreter_path_has_a_space_runs(
    quote: str,
    options: str,
    add_program: Callable[..., Path],
    run_verb: Callable[..., tuple[str, int]],
    tmp_path: Path,
) -> None:
    python = tmp_path / "a folder" / "python"
    python.parent.mkdir()
    python.symlink_to(Path(sys.executable).resolve())
    program = add_program("show", "")
    program.write_text(f"#!{quote}{python}{quote}{options}\nprint('runs')\n")
    assert run_verb("my_pkg", "show") == ("runs", 0)


def test_arguments_reach_the_program_unchanged(
    add_program: Callable[..., Path], run_verb: Callable[..., tuple[str, int]]
) -> None:
    add_program("show", "import sys; print(sys.argv[1:])")
    words = ["-h", "--prefix", "--ros-args", "-p", "a:=1", "two words", "--", "x"]
    assert run_verb("my_pkg", "show", *words) == (str(words), 0)


def test_exit_code_is_that_of_the_program(
    add_program: Callable[..., Path], run_verb: Callable[..., tuple[str, int]]
) -> None:
    add_program("fails", "raise SystemExit(3)")
    assert run_verb("my_pkg", "fails") == ("[ros2run]: Process exited with failure 3", 3)


def test_signal_that_ended_the_program_is_printed(
    add_program: Callable[..., Path], run_verb: Callable[..., tuple[str, int]]
) -> None:
    add_program("aborts", "import os; os.abort()")
    assert run_verb("my_pkg", "aborts") == ("[ros2run]: Aborted", -signal.SIGABRT)


def test_prefix_precedes_the_program(
    add_program: Callable[..., Path], run_verb: Callable[..., tuple[str, int]]
) -> None:
    path = add_program("show", "")
    path.write_text("#!/bin/sh\n")
    assert run_verb("--prefix", "echo 'a b'", "my_pkg", "show", "c") == (f"a b {path} c", 0)


def test_workspace_package_takes_precedence(tmp_path: Path, add_program: Callable[..., Path]) -> None:
    (tmp_path / index.RESOURCE_INDEX / "packages" / "turtlesim").touch()
    with pytest.raises(run.CommandError, match="No executable found"):
        run.find_command("turtlesim", "turtlesim_node")


def test_a_program_that_tfloom_has_too_is_named(
    tmp_path: Path, add_program: Callable[..., Path], run_verb: Callable[..., tuple[str, int]]
) -> None:
    mine = add_program("other", "print('mine')")
    assert run_verb("my_pkg", "other") == ("mine", 0)
    (tmp_path / index.RESOURCE_INDEX / "packages" / "turtlesim").touch()
    own = tmp_path / "lib" / "turtlesim" / "turtlesim_node"
    own.parent.mkdir(parents=True)
    mine.rename(own)
    text, _ = run_verb("turtlesim", "turtlesim_node")
    assert sorted(text.splitlines()) == [
        f"[ros2run]: starting {own} of the sourced workspace, not tfloom's own turtlesim_node",
        "mine",
    ]


def test_ambiguous_program_name_lists_all_paths(add_program: Callable[..., Path]) -> None:
    first, second = add_program("same", ""), add_program("deep/same", "")
    with pytest.raises(run.CommandError) as error:
        run.find_command("my_pkg", "same")
    assert str(error.value) == f"Multiple executables found:\n- {first}\n- {second}"


def test_program_that_cannot_start_gives_an_error_message(
    add_program: Callable[..., Path], run_verb: Callable[..., tuple[str, int]]
) -> None:
    add_program("broken", "").write_text("#!/no/such/interpreter\n")
    text, code = run_verb("my_pkg", "broken")
    assert (text.startswith("can't run "), code) == (True, 1)


WAITS_FOR_SIGNALS = """
import os, signal, sys, time
def told(number, frame):  # perhaps inside the `print` below, which can't be entered twice
    os.write(1, f"got {signal.Signals(number).name}\\n".encode())
for number in (signal.SIGINT, signal.SIGTERM):
    signal.signal(number, told)
print("ready", flush=True)
while True:
    time.sleep(60)
"""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signal_is_passed_on_to_the_program(
    number: int, add_program: Callable[..., Path], start_program: Callable[..., object]
) -> None:
    add_program("waits", WAITS_FOR_SIGNALS)
    program = start_program("tfloom", "run", "my_pkg", "waits")
    program.wait_for("ready")
    program.signal(number)
    program.wait_for(f"got {signal.Signals(number).name}")
    assert program.process.poll() is None


IN_A_TERMINAL = "import pty, sys; pty.spawn(sys.argv[1:])"


def test_ctrl_c_at_the_terminal_reaches_the_program_once(
    add_program: Callable[..., Path], start_program: Callable[..., object]
) -> None:
    add_program("waits", f"import os; print(os.getppid(), flush=True)\n{WAITS_FOR_SIGNALS}")
    terminal = start_program(
        "python",
        "-c",
        IN_A_TERMINAL,
        transcript.PROGRAM,
        "run",
        "my_pkg",
        "waits",
        stdin=subprocess.PIPE,
    )
    terminal.wait_for("ready")
    command = int(terminal.lines[0])
    try:
        terminal.process.stdin.write("\x03")
        terminal.process.stdin.flush()
        terminal.wait_for("got SIGINT")
        # Passed on after the grace period, within which a second SIGINT would have been passed on.
        os.kill(command, signal.SIGTERM)
        terminal.wait_for("got SIGTERM")
        assert terminal.output.count("got SIGINT") == 1
        terminal.process.stdin.close()
    finally:
        with suppress(ProcessLookupError):
            os.kill(
                command, signal.SIGKILL
            )  # the terminal's session is its own, and its end does not end them


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux ends a child with its parent")
def test_kill_of_the_command_kills_the_program(
    add_program: Callable[..., Path], start_program: Callable[..., object], wait_until: Callable[..., None]
) -> None:
    add_program("waits", f"import os; print(os.getpid(), flush=True)\n{WAITS_FOR_SIGNALS}")
    program = start_program("tfloom", "run", "my_pkg", "waits")
    program.wait_for("ready")
    pid = int(program.lines[0])
    program.signal(signal.SIGKILL)
    wait_until(lambda: has_ended(pid))


@pytest.mark.parametrize(
    ("code", "exit_code", "printed"),
    [
        ("None", 0, ""),
        ("0", 0, ""),
        ("4", 4, "[ros2run]: Process exited with failure 4\n"),
        ("sys.exit(5)", 5, "[ros2run]: Process exited with failure 5\n"),
        ("sys.exit()", 0, ""),
        ("sys.exit('what went wrong')", 1, "what went wrong\n[ros2run]: Process exited with failure 1\n"),
    ],
)
def test_exit_codes_of_own_programs(
    code: str,
    exit_code: int,
    printed: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / "a_program.py").write_text(
        f"import sys\ndef main(args):\n    print(args)\n    return {code}\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "a_program", raising=False)
    monkeypatch.setattr(sys, "argv", ["tfloom"])
    monkeypatch.delenv(index.PREFIX_PATH_VARIABLE, raising=False)
    monkeypatch.setitem(index.PROGRAMS, "our_pkg", {"our_program": "a_program:main"})
    assert cli.main(["run", "our_pkg", "our_program", "a", "--b"]) == exit_code
    assert sys.argv == ["our_program", "a", "--b"]
    assert capsys.readouterr() == ("['a', '--b']\n", printed)


@for_each(sorted({target for programs in index.PROGRAMS.values() for target in programs.values()}))
def test_each_own_program_exists(target: str) -> None:
    module, _, function = target.partition(":")
    assert callable(getattr(import_module(module), function))


@for_each(index.PROGRAMS)
def test_own_programs_are_sorted(package: str) -> None:
    assert list(index.PROGRAMS[package]) == sorted(index.PROGRAMS[package])


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["-p", "background_r:=abc"], "turtlesim_node: Trying to set parameter 'background_r' to 'abc'"),
        (["-p", "background_r:=999"], "turtlesim_node: Invalid parameter value (999)"),
        (["-r", "bad"], "turtlesim_node: Failed to parse ROS arguments: cannot understand '-r bad'"),
        (["--params-file", "no.yaml"], "turtlesim_node: Failed to parse ROS arguments: cannot understand"),
    ],
)
def test_invalid_program_arguments_give_an_error_message(
    words: list[str], text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setattr(sys, "argv", ["tfloom"])
    answer = transcript.run_here("run", "turtlesim", "turtlesim_node", "--ros-args", *words)
    assert answer.exit_code == 1
    *said, last = answer.text.splitlines()
    assert said[-1].startswith(text)
    assert last == "[ros2run]: Process exited with failure 1"
    assert "Traceback" not in answer.text


def test_undecodable_arguments_are_rejected() -> None:
    answer = transcript.run_here("run", "tf2_ros", "tf2_echo", os.fsdecode(b"\xff"), "b")
    assert answer.exit_code == 1
    assert answer.text == "the argument b'\\xff' isn't text in this terminal's encoding"


def test_prefix_with_an_open_quotation_is_rejected() -> None:
    answer = transcript.run_here("run", "--prefix", '"', "turtlesim", "turtlesim_node")
    assert (answer.exit_code, answer.text) == (1, "can't read --prefix '\"': No closing quotation")
