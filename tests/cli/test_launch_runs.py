"""`launch` with processes: the lines that the reference printed, and nothing left at the end."""

from __future__ import annotations

import os
import re
import shlex
import signal
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from test_launch import LAUNCH_FILES
from tests.conftest import Program, wait_until

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the programs under test are POSIX's")

StartProgram = Callable[..., Program]


@pytest.fixture(autouse=True)
def _local_wire(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")


_MASKS = (
    (r"(?<=found below ).*", "FOLDER"),
    (r"(?<=pid )\d+|(?<=pid \[)\d+", "PID"),
    (r"\[\d+\.\d+\]", "[TIME]"),
    (r"(?<=Hello World: )\d+", "NUMBER"),
)
_END_OF_TALKER = re.compile(r"\[(?:INFO|ERROR)\] \[talker-1\]: process has .*")
"""A machine that starts the talker too late for its signal handler reports another end."""


def masked_lines(text: str) -> set[str]:
    for pattern, mask in _MASKS:
        text = re.sub(pattern, mask, text)
    text = _END_OF_TALKER.sub("[talker-1]: process has ended", text)
    return {line for line in text.splitlines() if not line.startswith(("[talker-1] ", "[crash-1] "))}


def start(start_program: StartProgram, words: list[str]) -> Program:
    return start_program(sys.executable, *transcript.python_words(*words), cwd=LAUNCH_FILES)


def test_processes_that_crash_respawn_and_ignore_signals(start_program: StartProgram) -> None:
    recorded = transcript.golden("launch_processes")
    program = start(start_program, recorded.command)
    for text in ("err", "[deaf-3]: process started", "[re-2]: process has finished"):
        program.wait_for(text)

    def ends() -> int:
        return sum(line.startswith("[INFO] [re-2]: process has finished") for line in program.lines)

    wait_until(
        lambda: ends() > 1, what="the end of a process that was started again"
    )  # the third start is in 1 s
    program.signal(signal.SIGINT)
    assert program.wait() == 0
    assert masked_lines(program.output) == masked_lines(recorded.text)
    assert "[crash-1] out" in program.lines
    assert "[crash-1] err" in program.lines


def test_a_description_in_python_that_ends_by_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(LAUNCH_FILES)
    recorded = transcript.golden("launch_py")
    launched = transcript.launch_here(*recorded.command[1:])
    assert launched.exit_code == recorded.exit_code
    assert masked_lines(launched.text) == masked_lines(recorded.text)


@pytest.mark.parametrize(
    ("name", "last"), [("launch_xml", "[echo-2]: process has"), ("launch_yaml", "Publishing")]
)
def test_a_description_in_xml_and_yaml(name: str, last: str, start_program: StartProgram) -> None:
    recorded = transcript.golden(name)
    program = start(start_program, recorded.command)
    program.wait_for(last)
    program.signal(signal.SIGINT)
    assert program.wait() == 0
    assert masked_lines(program.output) == masked_lines(recorded.text)


LOGGED = '<launch><executable cmd="{} -c \'print(41 + 1)\'" output="log"/></launch>'


def test_all_output_is_shown_on_request(tmp_path: Path) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_text(LOGGED.format(shlex.quote(sys.executable)))
    quiet = transcript.launch_here(str(path))
    assert (quiet.exit_code, "-1] 42" in quiet.text) == (0, False)
    shown = transcript.launch_here("-a", str(path))
    assert (shown.exit_code, "-1] 42" in shown.text) == (0, True)


def test_prefix_of_all_or_of_some_programs(tmp_path: Path) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_text('<launch><executable cmd="echo one" output="screen"/></launch>')
    prefix = ["--launch-prefix", "echo 'before it'"]
    for words, line in (
        (prefix, "[echo-1] before it echo one"),
        ([*prefix, "--launch-prefix-filter", "ech."], "[echo-1] before it echo one"),
        ([*prefix, "--launch-prefix-filter", "other"], "[echo-1] one"),
    ):
        launched = transcript.launch_here(*words, str(path))
        assert launched.exit_code == 0
        assert line in launched.text.splitlines()
        assert "WARNING" not in launched.text


def test_launch_without_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(LAUNCH_FILES)
    launched = transcript.launch_here("-n", "need.launch.py", "need:=1")
    assert launched.exit_code == 0
    assert "[INFO] [launch.user]: 1" in launched.text.splitlines()


def test_the_log_file_has_the_name_of_the_option(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    path = tmp_path / "a.launch.xml"
    path.write_text('<launch><executable cmd="echo one" output="log"/></launch>')
    assert transcript.launch_here("-f", "mine", str(path)).exit_code == 0
    (log,) = (tmp_path / "log").glob("*-*/*.log")
    assert log.name == "mine.log"
    assert "one" in log.read_text("utf-8")
    wrong = transcript.launch_here("--log-file-name", "../mine", str(path))
    assert wrong.exit_code == 1
    assert "--log-file-name: '../mine.log' is not the name of a log file" in wrong.text
