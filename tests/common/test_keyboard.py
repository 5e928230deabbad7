"""Keys in the input of terminals."""

from __future__ import annotations

import os
import pty
import signal
import termios
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tfloom.common.keyboard import (
    FINALS,
    NAMES,
    NUMBERS,
    Keyboard,
    NoTerminalError,
    decode_keys,
    without_repetitions,
)


@pytest.mark.parametrize(
    ("text", "keys"),
    [
        ("\x1b[A\x1b[B\x1b[C\x1b[D", ["up", "down", "right", "left"]),
        ("\x1bOA", ["up"]),
        ("\x1b[1;5C", ["right"]),
        ("gq", ["g", "q"]),
        ("\x1b[A\x1b[A\x1b[D\x1b[A", ["up", "up", "left", "up"]),
        ("\x1b[3~\x1b[E\x1bOPx", ["x"]),
        (
            "\x1b[H\x1b[F\x1b[1~\x1b[4~\x1b[7~\x1b[8~\x1bOH",
            ["home", "end", "home", "end", "home", "end", "home"],
        ),
        ("\x1b[5~\x1b[6;2~\x1b[15~", ["page up", "page down"]),
        ("a/\r\n\x7f\b\x15激", ["a", "/", "enter", "enter", "backspace", "backspace", "clear", "激"]),
        ("\x1b", ["escape"]),
        ("\x1b\x1b[A", ["escape", "up"]),
        ("\x1b[", []),
        ("\x1b[1;", []),
        ("", []),
    ],
)
def test_key_sequences_are_decoded(text: str, keys: list[str]) -> None:
    assert decode_keys(text) == keys


@given(st.text(alphabet="\x1b[O;1ABCDEFgq~\r\x7f"))
def test_decoding_accepts_any_text(text: str) -> None:
    named = {*NAMES.values(), *FINALS.values(), *NUMBERS.values()}
    assert all(key in named or len(key) == 1 for key in decode_keys(text))


def test_a_key_that_is_held_down_counts_once() -> None:
    assert without_repetitions(["up"] * 40 + ["left", "up", "up"]) == ["up", "left", "up"]


def test_input_without_terminal_raises(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "isatty", lambda fd: False)
    with pytest.raises(NoTerminalError), Keyboard():
        pass


SCRIPT = """
from tfloom.common.keyboard import Keyboard
with Keyboard() as keyboard:
    print("ready", flush=True)
    keys = []
    while "q" not in keys:
        if found := keyboard.read(0.1):
            keys += found
            print(keys, flush=True)
        if "x" in keys:
            raise RuntimeError("on purpose")
"""


@pytest.fixture
def in_terminal(start_program: Callable[..., Any]) -> Any:
    """Start the script in a separate terminal, by the words in front of it; return also its mode before."""
    ours, theirs = pty.openpty()

    def start(*words: str) -> tuple[Any, int, list]:
        before = termios.tcgetattr(ours)
        program = start_program("python", "-c", *words, SCRIPT, stdin=theirs)
        program.wait_for("ready")
        assert not termios.tcgetattr(ours)[3] & (termios.ICANON | termios.ECHO)
        return program, ours, before

    yield start
    os.close(ours)
    os.close(theirs)


InTerminal = Callable[..., tuple[Any, int, list]]


def test_keys_are_read_from_a_terminal(in_terminal: InTerminal) -> None:
    program, terminal, before = in_terminal()
    os.write(terminal, b"\x1b")  # an arrow that arrives in two parts
    os.write(terminal, b"[Agg")
    os.write(terminal, "é".encode()[:1])  # a letter, too
    program.wait_for("['up', 'g', 'g']")
    os.write(terminal, "é".encode()[1:] + b"q")
    assert program.wait() == 0
    assert program.lines[-1] == "['up', 'g', 'g', 'é', 'q']"
    assert termios.tcgetattr(terminal) == before


@pytest.mark.parametrize("end", ["error", signal.SIGHUP, signal.SIGQUIT, signal.SIGINT])
def test_terminal_mode_is_restored(in_terminal: InTerminal, end: Any) -> None:
    program, terminal, before = in_terminal()
    if end == "error":
        os.write(terminal, b"x")
    else:
        program.signal(end)
    assert program.wait() != 0
    assert termios.tcgetattr(terminal) == before


# The kernel stops no program in an orphaned process group, so this process acts as the shell.
SHELL = """
import os, subprocess, sys
program = subprocess.Popen([sys.executable, "-c", sys.argv[1]], preexec_fn=os.setpgrp)
print("pid", program.pid, flush=True)
while os.WIFSTOPPED(status := os.waitpid(program.pid, os.WUNTRACED)[1]):
    print("stopped", flush=True)
sys.exit(os.waitstatus_to_exitcode(status))
"""


def test_stopped_program_restores_the_terminal_mode(
    in_terminal: InTerminal, wait_until: Callable[..., None]
) -> None:
    shell, terminal, before = in_terminal(SHELL)
    pid = int(next(line for line in shell.lines if line.startswith("pid")).split()[1])
    os.kill(pid, signal.SIGTSTP)
    shell.wait_for("stopped")
    assert termios.tcgetattr(terminal) == before
    os.kill(pid, signal.SIGCONT)
    wait_until(lambda: not termios.tcgetattr(terminal)[3] & termios.ICANON, what="single keys again")
    os.write(terminal, b"q")
    assert shell.wait() == 0
    assert termios.tcgetattr(terminal) == before
