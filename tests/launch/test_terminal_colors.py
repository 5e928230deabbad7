"""A launch's output on a terminal: colors for levels and processes, and nothing else that a terminal obeys."""

from __future__ import annotations

import os

import pytest
from tests.terminals import on_a_terminal

PROGRAM = r"""
import logging
from tfloom.launch.logs.logging import get_logger, get_output_loggers
from tfloom.common.terminal import shown_on_terminals
with shown_on_terminals():
    get_logger("launch.user").warning("careful")
    get_logger("launch.user").info("a\x1b[2Jb")
    stdout, _ = get_output_loggers("talker-1", "screen")
    stdout.info("[talker-1] \x1b[31mred\x07")
"""


@pytest.mark.skipif(os.name != "posix", reason="pseudo-terminals are POSIX")
def test_levels_and_processes_are_colored_and_hostile_text_is_shown() -> None:
    warning, info, line, _ = on_a_terminal(PROGRAM).split("\n")
    assert warning == "\x1b[33m[WARNING] [launch.user]: careful\x1b[0m"
    assert info == r"[INFO] [launch.user]: a\x1b[2Jb"
    assert line.endswith("m[talker-1]\x1b[0m \x1b[31mred\\x07\x1b[0m")
    assert line.startswith("\x1b[")


@pytest.mark.skipif(os.name != "posix", reason="pseudo-terminals are POSIX")
def test_no_color_is_respected() -> None:
    lines = on_a_terminal(PROGRAM, NO_COLOR="1").split("\n")
    assert lines[0] == "[WARNING] [launch.user]: careful"
    assert lines[2].startswith("[talker-1] ")
