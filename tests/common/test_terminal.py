"""Control characters on a terminal are shown; a pipe gets them as they are."""

from __future__ import annotations

import io
import os
import subprocess
import sys
from pathlib import Path

import pytest
from tests.terminals import on_a_terminal

from tfloom.common.terminal import (
    TerminalOutput,
    report,
    shown,
    shown_in_colors,
    shown_on_terminals,
    unescaped,
)

HOSTILE = "a\x1b[2J\x07\r\x7f\x9b1m\u202eb\u2066c\td\nä\u200f漢"
SHOWN = "a\\x1b[2J\\x07\\x0d\\x7f\\x9b1m\\u202eb\\u2066c\td\nä\u200f漢"


def test_what_a_terminal_obeys_is_shown() -> None:
    assert shown(HOSTILE) == SHOWN
    assert shown("plain ü 漢 \t\n") == "plain ü 漢 \t\n"


def test_colours_remain_and_end_with_the_line() -> None:
    assert shown_in_colors(HOSTILE) == SHOWN
    assert shown_in_colors("\x1b[1;31ma\x1b[2Jb\x1b[0m") == "\x1b[1;31ma\\x1b[2Jb\x1b[0m"
    assert shown_in_colors("\x1b[1;31ma\x1b[mb\x1b[38:5:9m") == "\x1b[1;31ma\x1b[mb\x1b[38:5:9m\x1b[0m"


def test_every_control_character_is_shown_except_tab_and_line_feed() -> None:
    obeyed = [*range(0x20), *range(0x7F, 0xA0), *range(0x202A, 0x202F), *range(0x2066, 0x206A)]
    for code in range(0x3000):
        expected = code in obeyed and chr(code) not in "\t\n"
        assert (shown(chr(code)) != chr(code)) is expected, hex(code)


def test_a_stream_that_is_no_terminal_is_unchanged(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = io.StringIO()
    monkeypatch.setattr(sys, "stdout", stream)
    with shown_on_terminals():
        assert sys.stdout is stream
        print(HOSTILE)
    assert stream.getvalue() == f"{HOSTILE}\n"


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_a_terminal_is_wrapped_once_and_restored(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = Terminal()
    monkeypatch.setattr(sys, "stdout", stream)
    with shown_on_terminals():
        wrapped = sys.stdout
        with shown_on_terminals():
            assert sys.stdout is wrapped
        assert isinstance(wrapped, TerminalOutput)
        assert unescaped(wrapped) is stream
        print(HOSTILE, end="")
        wrapped.writelines(["\x1b", "x"])
    assert sys.stdout is stream
    assert stream.getvalue() == f"{SHOWN}\\x1bx"


LOG = f"""
from tfloom.node.log.logging import get_logger
get_logger("na\\x1b\\nme").info({HOSTILE!r})
"""


def test_a_log_on_a_terminal_shows_them() -> None:
    text = on_a_terminal(LOG, RCUTILS_CONSOLE_OUTPUT_FORMAT="{name}: {message}")
    assert text == f"\x1b[0mna\\x1b\\x0ame: {SHOWN}\x1b[0m\n"
    plain = on_a_terminal(
        LOG, RCUTILS_CONSOLE_OUTPUT_FORMAT="\\x1b[1m{message}", RCUTILS_COLORIZED_OUTPUT="0"
    )
    assert plain == f"\x1b[1m{SHOWN}\n"


def test_a_log_in_a_pipe_has_them() -> None:
    env = os.environ | {"RCUTILS_CONSOLE_OUTPUT_FORMAT": "{name}: {message}", "PYTHONUTF8": "1"}
    done = subprocess.run([sys.executable, "-c", LOG], capture_output=True, env=env, check=True)
    assert done.stderr.decode() == f"na\x1b\nme: {HOSTILE}\n"


# A verb's output, and an error with a name in it.
VERB = f"""
import sys
from types import ModuleType
from tfloom.cli import main as cli
from tfloom.cli.shared.errors import CommandError
import tfloom.cli.topic.queries as verb
def main(args):
    print({HOSTILE!r})
    raise CommandError({HOSTILE!r})
verb.list_main = main
sys.argv = ["tfloom", "topic", "list"]
sys.exit(cli.main())
"""


def test_a_verb_on_a_terminal_shows_them() -> None:
    assert on_a_terminal(VERB) == f"{SHOWN}\n{SHOWN}\n"


def test_a_verb_in_a_pipe_prints_them() -> None:
    env = os.environ | {"PYTHONUTF8": "1"}
    done = subprocess.run([sys.executable, "-c", VERB], capture_output=True, env=env, check=False)
    assert (done.returncode, done.stdout.decode(), done.stderr.decode()) == (
        1,
        f"{HOSTILE}\n",
        f"{HOSTILE}\n",
    )


PROGRAM = f"""
from tfloom.node.program import run_program
from tfloom.node.log.logging import get_logger
def body():
    print({HOSTILE!r}, flush=True)
    get_logger("x").info("y")
run_program([], body)
"""


def test_a_program_on_a_terminal_shows_them_and_keeps_the_colours_of_its_log() -> None:
    text = on_a_terminal(PROGRAM, RCUTILS_CONSOLE_OUTPUT_FORMAT="{message}")
    assert text == f"{SHOWN}\n\x1b[0my\x1b[0m\n"


def test_doctors_colours_are_obeyed() -> None:
    text = on_a_terminal(
        "import sys\nfrom tfloom.cli.main import main\nsys.argv = ['tfloom', 'doctor']\nmain()"
    )
    assert "\x1b[32m     ok\x1b[0m  " in text
    assert "\\x1b" not in text


def test_a_list_on_a_terminal_has_a_line_for_each_name() -> None:
    program = "from tfloom.cli.shared.listing import print_names\nprint_names(['/a\\n/b\\tc', '/d'])"
    assert on_a_terminal(program) == "/a\\x0a/b\\x09c\n/d\n"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "/a\n/b\tc\n/d\n"


def test_echo_on_a_terminal_obeys_nothing() -> None:
    program = f"""
import sys
from tfloom.cli.shared import message_text
from tfloom.cli.main import main
import tfloom.cli.topic.echo as verb
from tfloom.cli.shared.selection import field_picker
from tfloom.interfaces.std_msgs.msg import String
def echo(args):
    print(message_text.message_text(args)(field_picker(args.field)(String(data={HOSTILE!r}))))
verb.main = echo
for flags in (["--field", "data"], ["--csv"], ["--json"], []):
    sys.argv = ["tfloom", "topic", "echo", "/x", *flags]
    main()
"""
    text = on_a_terminal(program)
    assert shown(text) == text
    assert [text.count(f"a\\{escape}[2J") for escape in ("x1b", "u001b", "e")] == [2, 1, 1]


# Where stderr takes nothing.

STDERRS = {
    "full": pytest.param(
        ">/dev/full", marks=pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device")
    ),
    "closed": pytest.param(">&-", marks=pytest.mark.skipif(os.name != "posix", reason="a shell closes it")),
}


@pytest.mark.parametrize("stderr", STDERRS.values(), ids=STDERRS)
def test_report_that_nobody_can_read_ends_nothing(stderr: str) -> None:
    program = "from tfloom.common.terminal import report; report('said'); report('again'); print('done')"
    done = subprocess.run(
        ["sh", "-c", f'exec "$0" -c "$1" 2{stderr}', sys.executable, program],
        stdout=subprocess.PIPE,
        text=True,
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stdout) == (0, "done\n")


@pytest.mark.parametrize("failure", [OSError(28, "full"), ValueError("I/O operation on closed file")])
def test_report_to_a_stream_that_fails_is_lost(failure: Exception, monkeypatch: pytest.MonkeyPatch) -> None:
    class Failing(io.StringIO):
        def write(self, _: str) -> int:
            raise failure

    monkeypatch.setattr(sys, "stderr", Failing())
    report("said")
