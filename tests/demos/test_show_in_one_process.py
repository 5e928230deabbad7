"""`tfloom demo` without DDS: the same demonstration, on threads of one process."""

from __future__ import annotations

import io
import os
import re
import signal
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from tests.conftest import python_with

from tfloom.cli.demo import NOBODY_WATCHES, UNWATCHED_S, describe_end, describe_wire
from tfloom.cli.main import main
from tfloom.demos.show import Show, ShowError
from tfloom.demos.threads import WINDOWLESS_PROGRAMS, ThreadProgram, thread_starter
from tfloom.node.context.utilities import get_default_context
from tfloom.rmw.cyclone.library import Library

CHOSEN = (
    "RMW_IMPLEMENTATION is tfloom_local, a wire within one process, so all programs run within this process, "
    "and other terminals can't join in."
)
MISSING = re.compile(
    r"No DDS library \(libddsc\) can be used, so all programs run within this process, and other terminals can't "
    r"join in: there is no DDS: .*install.*\."
)
Start = Callable[..., Any]


@pytest.fixture
def local(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")


@pytest.fixture
def without_library(monkeypatch: pytest.MonkeyPatch) -> dict[str, object]:
    """Return the constants of a module with which no libddsc is found."""
    monkeypatch.delenv("RMW_IMPLEMENTATION", raising=False)
    monkeypatch.delenv("TFLOOM_LIBDDSC", raising=False)
    module = "tfloom.rmw.cyclone.library"
    return {f"{module}._PACKAGES": (), f"{module}._SYSTEM_FOLDERS": (), f"{module}._ROS_FOLDER": ""}


def test_demonstration_prints_draws_and_ends(
    start_program: Start, tmp_path: Path, without_library: dict[str, object]
) -> None:
    constants = without_library | {"tfloom.cli.demo.UNWATCHED_S": 0.5}
    run = "from tfloom.cli.main import main; sys.exit(main())"
    demo = start_program(sys.executable, *python_with(constants, run, "demo"), cwd=tmp_path)
    assert demo.wait(60.0) == 0, demo.output
    assert MISSING.fullmatch(demo.lines[3])
    assert "ROS_DOMAIN_ID" not in demo.output
    assert demo.lines[2] == "It has no terminal, so it ends after 0.5 s, or after --seconds N."
    drawn = demo.lines.index(f"The tree of frames is drawn in {tmp_path / 'frames.pdf'}")
    assert demo.lines[drawn + 1] == f"The turtles, drawn anew each second, are in {tmp_path / 'turtles.png'}"
    assert demo.lines[-1] == f"The picture of the turtles is in {tmp_path / 'turtles.png'}"
    first = next(i for i, line in enumerate(demo.lines) if line.startswith("At time"))
    echoed = "\n".join(demo.lines[first : first + 9])
    number = r" ?-?\d+\.\d{3}"
    row = rf" (?:{number} ){{3}}{number}"
    assert re.match(rf"At time \d+\.\d{{9}}\n- Translation: \[{number}, {number}, 0\.100\]\n", echoed)
    assert re.search(rf"\n- Matrix:\n(?:{row}\n){{2}}{row}$", echoed), echoed
    graph = (tmp_path / "frames.gv").read_text()
    for ends in ('"world" -> "turtle1"', '"world" -> "turtle2"', '"turtle1" -> "laser"'):
        assert ends in graph
    assert (tmp_path / "frames.pdf").read_bytes().startswith(b"%PDF-")
    with Image.open(tmp_path / "turtles.png") as picture:
        colours = picture.convert("RGB").getcolors(picture.width * picture.height)
    assert colours is not None
    (_, background), (pen_pixels, _) = sorted(colours, reverse=True)[:2]
    assert background == (69, 86, 255)
    assert pen_pixels > 500, "the turtles have drawn next to nothing"


@pytest.mark.skipif(sys.platform != "linux", reason="counts the process's children in /proc")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signal_ends_the_process(
    start_program: Start, tmp_path: Path, local: None, number: signal.Signals
) -> None:
    demo = start_program("tfloom", "demo", cwd=tmp_path)
    demo.wait_for("At time")
    assert demo.lines[3] == CHOSEN
    pid = demo.process.pid
    children = [path.read_text() for path in Path(f"/proc/{pid}/task").glob("*/children")]
    assert "".join(children) == ""
    demo.signal(number)
    assert demo.wait() == 0
    assert demo.lines[-2:] == [
        f"The picture of the turtles is in {tmp_path / 'turtles.png'}",
        "The demonstration has ended.",
    ]
    assert "Traceback" not in demo.output


def test_failing_program_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], local: None
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "frames.pdf").mkdir()
    assert main(["demo"]) == 1
    error = capsys.readouterr().err
    assert "view_frames ended unexpectedly with exit code 1\n" in error
    assert re.search(r"\[view_frames\]: can't write .*frames.pdf: Is a directory", error)
    assert "Traceback" not in error


def test_exception_in_a_program_is_printed_with_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a_broken_program.py").write_text("def main(args):\n    raise ValueError(args[0])\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.chdir(tmp_path)
    default = get_default_context()
    programs = WINDOWLESS_PROGRAMS | {"driver": ["a_broken_program:main", "no fuel"]}
    with (
        thread_starter() as start,
        pytest.raises(ShowError) as caught,
        Show(start, programs) as show,
    ):
        show.run(None)
    first, second, *_, last = str(caught.value).splitlines()
    assert first == "driver ended unexpectedly with exit code 1"
    assert second == "Traceback (most recent call last):"
    assert last == "ValueError: no fuel"
    assert capsys.readouterr().err == ""
    left = [thread.name for thread in threading.enumerate() if thread.name.startswith(("tfloom", "a_broken"))]
    assert left == []
    assert get_default_context() is default, "a program took the process's default context"


@pytest.mark.parametrize(
    ("ending", "code", "log"),
    [
        ("return None", 0, []),
        ("return 3", 3, []),
        ("sys.exit(2)", 2, []),
        ("sys.exit('no more')", 1, ["no more"]),
        ("print('one\\ntwo', end='')", 0, ["one", "two"]),
        ("print('out'); print('err', file=sys.stderr)", 0, ["out", "err"]),
    ],
)
def test_program_exit_codes_match_those_of_a_process(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    wait_until: Callable[..., None],
    ending: str,
    code: int,
    log: list[str],
) -> None:
    (tmp_path / "a_program.py").write_text(f"import sys\ndef main(args):\n    {ending}\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "a_program", raising=False)
    lines: list[str] = []
    with thread_starter() as start:
        program = start(["a_program:main"], lines.append)
        wait_until(lambda: program.exit_code() is not None)
    assert program.exit_code() == code
    assert list(program.log) == lines == log


def test_program_ends_if_requested_before_its_start(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a_slow_starter.py").write_text(
        "from threading import Event\n"
        "from tfloom.node.client_library import create_node, spin\n"
        "from tfloom.node.program import run_program\n"
        "may_begin = Event()\n"
        "def main(args):\n"
        "    may_begin.wait()\n"
        "    return run_program(args, lambda: spin(create_node('slow')), if_stopped=7)\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    with thread_starter() as start:
        program = start(["a_slow_starter:main"], None)
        assert isinstance(program, ThreadProgram)
        program.request_end()
        sys.modules["a_slow_starter"].may_begin.set()
        program.end(10.0)
    assert program.exit_code() == 7


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("requested_s", "opens_page", "stream", "expected"),
    [
        (4.5, False, Terminal(), (4.5, "It ends after 4.5 s.")),
        (None, False, Terminal(), (None, "Ctrl-C ends the demonstration.")),
        (None, True, None, (None, "Ctrl-C ends the demonstration.")),
        (None, False, None, (UNWATCHED_S, NOBODY_WATCHES.format(seconds=UNWATCHED_S))),
    ],
)
def test_end_is_as_requested(
    monkeypatch: pytest.MonkeyPatch,
    requested_s: float | None,
    opens_page: bool,
    stream: Terminal | None,
    expected: tuple[float | None, str],
) -> None:
    monkeypatch.delenv("MAKELEVEL", raising=False)
    monkeypatch.setattr(sys, "stdin", stream)
    monkeypatch.setattr(sys, "stdout", None)  # as for a program without a console
    assert describe_end(requested_s, opens_page=opens_page) == expected


def test_under_make_it_says_what_make_prints(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MAKELEVEL", "1")
    _, said = describe_end(None, opens_page=True)
    assert said == "Ctrl-C ends the demonstration. (`make` then prints `Interrupt`, which is not a failure.)"


def test_processes_are_used_if_the_library_is_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("RMW_IMPLEMENTATION", raising=False)
    library = Library("libddsc.so", "0.10.5", "the system")
    monkeypatch.setattr("tfloom.rmw.cyclone.library.open_library", lambda: library)
    assert describe_wire() == ("They meet over DDS, by libddsc 0.10.5 of the system.", True)
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    assert describe_wire() == (CHOSEN, False)
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    said = "RMW_IMPLEMENTATION is left aside: over Zenoh they would need a router."
    assert describe_wire() == (f"They meet over DDS, by libddsc 0.10.5 of the system. {said}", True)


def test_environment_and_streams_are_restored(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("RMW_IMPLEMENTATION", raising=False)
    monkeypatch.setenv("ROS_DOMAIN_ID", "5")
    before = dict(os.environ), sys.stdout, sys.stderr
    with thread_starter():
        assert os.environ["RMW_IMPLEMENTATION"] == "tfloom_local"
        assert sys.stdout is not before[1]
    assert (dict(os.environ), sys.stdout, sys.stderr) == before
