"""A launch's output on a terminal: colors for levels and processes, and nothing else that a terminal obeys."""

from __future__ import annotations

import os
import pty
import subprocess
import sys

import pytest

PROGRAM = r"""
import logging
from tfloom.launch.logging import get_logger, get_output_loggers
from tfloom.terminal_text import shown_on_terminals
with shown_on_terminals():
    get_logger("launch.user").warning("careful")
    get_logger("launch.user").info("a\x1b[2Jb")
    stdout, _ = get_output_loggers("talker-1", "screen")
    stdout.info("[talker-1] \x1b[31mred\x07")
"""


def on_a_terminal(**environment: str) -> str:
    ours, theirs = pty.openpty()
    env = {**os.environ, "TERM": "xterm", **environment}
    env.pop("NO_COLOR", None) if "NO_COLOR" not in environment else None
    process = subprocess.Popen(
        [sys.executable, "-c", PROGRAM], stdin=theirs, stdout=theirs, stderr=theirs, env=env
    )
    os.close(theirs)
    read = b""
    try:
        while part := os.read(ours, 65536):
            read += part
    except OSError:  # the terminal's other end is closed
        pass
    finally:
        os.close(ours)
        process.wait(timeout=60)
    return read.decode().replace("\r\n", "\n")


@pytest.mark.skipif(os.name != "posix", reason="pseudo-terminals are POSIX")
def test_levels_and_processes_are_colored_and_hostile_text_is_shown() -> None:
    warning, info, line, _ = on_a_terminal().split("\n")
    assert warning == "\x1b[33m[WARNING] [launch.user]: careful\x1b[0m"
    assert info == r"[INFO] [launch.user]: a\x1b[2Jb"
    assert line.endswith("m[talker-1]\x1b[0m \x1b[31mred\\x07\x1b[0m")
    assert line.startswith("\x1b[")


@pytest.mark.skipif(os.name != "posix", reason="pseudo-terminals are POSIX")
def test_no_color_is_respected() -> None:
    lines = on_a_terminal(NO_COLOR="1").split("\n")
    assert lines[0] == "[WARNING] [launch.user]: careful"
    assert lines[2].startswith("[talker-1] ")
