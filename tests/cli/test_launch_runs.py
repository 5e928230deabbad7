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


def start(start_program: StartProgram, words: list[str], **environment: str) -> Program:
    environment = {**os.environ, "RMW_IMPLEMENTATION": "tfloom_local", **environment}
    return start_program(sys.executable, *transcript.python_words(*words), cwd=LAUNCH_FILES, env=environment)


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


def test_a_description_in_python_that_ends_by_itself(start_program: StartProgram) -> None:
    recorded = transcript.golden("launch_py")
    program = start(start_program, recorded.command)
    assert program.wait() == recorded.exit_code
    assert masked_lines(program.output) == masked_lines(recorded.text)


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


def test_all_output_is_shown_on_request(start_program: StartProgram, tmp_path: Path) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_text(LOGGED.format(shlex.quote(sys.executable)))
    quiet = start(start_program, ["launch", str(path)])
    assert quiet.wait() == 0
    assert not any(line.endswith("-1] 42") for line in quiet.lines)
    shown = start(start_program, ["launch", "-a", str(path)])
    assert shown.wait() == 0
    assert any(line.endswith("-1] 42") for line in shown.lines)


def test_prefix_of_all_or_of_some_programs(start_program: StartProgram, tmp_path: Path) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_text('<launch><executable cmd="echo one" output="screen"/></launch>')
    prefix = ["--launch-prefix", "echo 'before it'"]
    for words, line in (
        (prefix, "[echo-1] before it echo one"),
        ([*prefix, "--launch-prefix-filter", "ech."], "[echo-1] before it echo one"),
        ([*prefix, "--launch-prefix-filter", "other"], "[echo-1] one"),
    ):
        program = start(start_program, ["launch", *words, str(path)])
        assert program.wait() == 0
        assert line in program.lines
        assert "WARNING" not in program.output


def test_launch_without_a_terminal(start_program: StartProgram) -> None:
    program = start(start_program, ["launch", "-n", "need.launch.py", "need:=1"])
    assert program.wait() == 0
    assert "[INFO] [launch.user]: 1" in program.lines
