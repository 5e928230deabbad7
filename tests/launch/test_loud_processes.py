"""A launch obeys signals in time whatever its processes write, and wherever that goes."""

from __future__ import annotations

import errno
import io
import logging
import os
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import psutil
import pytest
from tests.conftest import python_with

from tfloom.launch.actions import process_output
from tfloom.launch.actions.event_actions import RegisterEventHandler, Shutdown
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.events.event_handlers import OnProcessIO
from tfloom.launch.logs import background_writing
from tfloom.launch.logs import logging as launch_logging
from tfloom.launch.logs.background_writing import SCREEN, BackgroundWriter

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the programs are of POSIX")

Launch = Callable[..., tuple]

SMALL_BACKLOG = {"tfloom.launch.logs.background_writing.MAX_BACKLOG": 100_000}
"""Which is soon reached."""
MAIN = "from tfloom.cli.start import main; sys.exit(main())"
OBEYED_S = 20.0
"""Time in which a launch with timeouts of a fifth of a second has ended, also beside the other tests."""

FILE = """
import sys
from launch import LaunchDescription
from launch.actions import ExecuteProcess

def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(
            cmd=[sys.executable, "-c", code], name="loud", sigterm_timeout="0.2", sigkill_timeout="0.2",
            output={output!r}, emulate_tty=emulate_tty,
        )
        for code, emulate_tty in {programs!r}
    ])
"""
WRITES = "import os, signal\n{before}\ndata = {data} * 1000\nwhile True:\n    os.write(1, data)"
DEAF = "signal.signal(signal.SIGINT, signal.SIG_IGN); signal.signal(signal.SIGTERM, signal.SIG_IGN)"
SHORT, LONG = "b'y\\n' * 30", "b'y' * 60"


def write_file(folder: Path, programs: Sequence[tuple[str, bool]], output: str) -> Path:
    """Write a launch file of deaf programs: what each writes, and whether it does to a terminal."""
    file = folder / "loud.launch.py"
    words = [(WRITES.format(before=DEAF, data=data), emulate_tty) for data, emulate_tty in programs]
    file.write_text(FILE.format(programs=words, output=output), "utf-8")
    return file


class Screen:
    """The stdout of a launch: a pipe or a terminal, which is read as fast as told."""

    def __init__(self, *, is_terminal: bool) -> None:
        self.ours, self.theirs = os.openpty() if is_terminal else os.pipe()
        self.text = b""
        self.size = 0
        self.heard: set[bytes] = set()
        """The processes whose names have come."""
        self.pause_s = 0.0
        """Time between two reads of a thousand bytes [s]; infinite: nothing more is read."""
        self._ends = threading.Event()
        self._thread = threading.Thread(target=self._read)
        self._thread.start()

    def _read(self) -> None:
        while not self._ends.is_set():
            if self.pause_s:
                self._ends.wait(min(self.pause_s, 0.05))
                if self.pause_s == float("inf"):
                    continue
            try:
                data = os.read(self.ours, 1000 if self.pause_s else 65536)
            except OSError:  # a terminal whose other end is closed
                return
            if not data:
                return
            self.size += len(data)
            self.heard.update(name for name in (b"loud-1", b"loud-2", b"loud-3") if b"[%s] y" % name in data)
            self.text = (self.text + data)[-5000:]

    def close(self) -> None:
        self._ends.set()
        self._thread.join(30)
        os.close(self.ours)


@contextmanager
def launched(file: Path, logs: Path, *, is_terminal: bool = False) -> Iterator[tuple[psutil.Popen, Screen]]:
    """Launch a file, and wait until its processes write."""
    screen = Screen(is_terminal=is_terminal)
    process = psutil.Popen(
        [sys.executable, *python_with(SMALL_BACKLOG, MAIN, "launch", file)],
        stdin=subprocess.DEVNULL,
        stdout=screen.theirs,
        stderr=subprocess.STDOUT,
        env={**os.environ, "ROS_LOG_DIR": str(logs)},
        start_new_session=True,
    )
    os.close(screen.theirs)
    try:
        yield process, screen
    finally:
        left = [process, *process.children(recursive=True)] if process.poll() is None else []
        for one in left:
            one.kill()
        process.wait(30)
        screen.close()


def seconds_until_it_ends(process: psutil.Popen, number: int) -> float:
    start = time.monotonic()
    process.send_signal(number)
    assert process.wait(60) == 0
    return time.monotonic() - start


STOPPED_S = float("inf")


@pytest.mark.parametrize(
    ("number", "pause_s", "is_terminal"),
    [
        (signal.SIGINT, STOPPED_S, True),
        (signal.SIGTERM, 0.05, False),
        pytest.param(signal.SIGTERM, STOPPED_S, False, marks=pytest.mark.slow),
        pytest.param(signal.SIGINT, 0.05, True, marks=pytest.mark.slow),
    ],
)
def test_a_screen_that_takes_nothing_delays_no_signal(
    tmp_path: Path, wait_until: Callable[..., None], number: int, pause_s: float, is_terminal: bool
) -> None:
    file = write_file(tmp_path, [(SHORT, False)] * 2, "both")
    with launched(file, tmp_path / "log", is_terminal=is_terminal) as (process, screen):
        wait_until(lambda: screen.size > 10_000, timeout_s=60)
        screen.pause_s = pause_s
        wait_until(lambda: is_blocked_on_output(process), timeout_s=60, what="the screen to be full")
        assert seconds_until_it_ends(process, number) < OBEYED_S
    (log,) = (tmp_path / "log").rglob("launch.log")
    text = log.read_text("utf-8")
    assert "escalating to 'SIGKILL'" in text
    assert re.search(r"\[WARNING\] \[launch\]: \d+ lines are lost: screen did not take them in time\n", text)


def is_blocked_on_output(process: psutil.Popen) -> bool:
    """Return whether the programs of a launch wait, because nobody reads what they write."""
    loud = [child for child in process.children() if "os.write(1, data)" in " ".join(child.cmdline())]
    before = [child.num_ctx_switches() for child in loud]
    time.sleep(0.3)
    return bool(loud) and before == [child.num_ctx_switches() for child in loud]


@pytest.mark.parametrize(
    "output", ["full", *(pytest.param(output, marks=pytest.mark.slow) for output in ("screen", "both"))]
)
def test_deaf_processes_that_write_at_full_speed_are_ended_in_time(
    tmp_path: Path, wait_until: Callable[..., None], output: str
) -> None:
    """One writes short lines, one no line end, and one to a terminal."""
    file = write_file(tmp_path, [(SHORT, False), (LONG, False), (SHORT, True)], output)
    with launched(file, tmp_path / "log") as (process, screen):
        wait_until(lambda: screen.size > 1_000_000 and len(screen.heard) == 3, timeout_s=60)
        assert seconds_until_it_ends(process, signal.SIGTERM) < OBEYED_S
    (log,) = (tmp_path / "log").rglob("launch.log")
    killed = re.findall(rb"sending signal 'SIGKILL' to process\[loud-(\d)\]", log.read_bytes())
    assert sorted(killed) == [b"1", b"2", b"3"]


def test_handlers_that_are_slower_than_the_output_delay_no_signal(
    launch: Launch, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each event of output is handled in its turn, and so is that of the end: few may wait."""
    monkeypatch.setattr(process_output, "MAX_EVENTS", 8)
    contexts: list[LaunchContext] = []
    waiting: list[int] = []

    def on_stdout(_: object) -> None:
        time.sleep(0.002)
        waiting.append(contexts[0].run_state.events.qsize())
        if len(waiting) == 100:
            os.kill(os.getpid(), signal.SIGTERM)

    code = WRITES.format(before="signal.signal(signal.SIGINT, signal.SIG_DFL)", data=LONG)
    loud = [ExecuteProcess(cmd=[sys.executable, "-c", code], output="own_log") for _ in range(4)]
    ran = launch(
        OpaqueFunction(function=contexts.append),
        RegisterEventHandler(OnProcessIO(on_stdout=on_stdout)),
        *loud,
    )
    assert ran.code == 0
    assert max(waiting) < 2 * 8 + len(loud)
    assert len(waiting) < 200


class SlowFile(io.TextIOWrapper):
    """A log file on a disk that takes some time for each write, and may fail."""

    def __init__(self, path: str, pause_s: float) -> None:
        super().__init__(Path(path).open("ab"), "utf-8")  # noqa: SIM115  # closed with this
        self.pause_s = pause_s

    def write(self, text: str) -> int:
        time.sleep(self.pause_s)
        return super().write(text)


def slow_handler(path: str, pause_s: float) -> logging.Handler:
    handler = launch_logging._file_handler(path)
    handler.stream.close()
    handler.stream = SlowFile(path, pause_s)
    return handler


def test_what_was_read_is_in_a_log_file_on_a_slow_disk(
    launch: Launch, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A signal comes while much waits to be written; each line of the processes that was passed on is in the file."""
    monkeypatch.setattr(background_writing, "MAX_BACKLOG", 100_000)
    launch_logging.launch_config.log_handler_factory = lambda path: slow_handler(path, 0.02)
    events: list[bytes] = []

    def on_stdout(event: object) -> None:
        events.append(event.text)
        if len(events) == 5:
            os.kill(os.getpid(), signal.SIGTERM)

    loud = ExecuteProcess(
        cmd=[
            sys.executable,
            "-c",
            "import signal\nsignal.signal(2, signal.SIG_DFL)\nn = 0\nwhile True:\n    print(n)\n    n += 1",
        ],
        additional_env={"PYTHONUNBUFFERED": ""},
        name="loud",
        output="log",
    )
    start = time.monotonic()
    ran = launch(RegisterEventHandler(OnProcessIO(target_action=loud, on_stdout=on_stdout)), loud)
    assert time.monotonic() - start < OBEYED_S
    assert ran.code == 0
    lines = b"".join(events).decode().splitlines()
    folder = Path(launch_logging.launch_config.log_dir)
    launch_logging.reset()
    logged = re.findall(r"\[loud-1\] (\d+)\n", (folder / "launch.log").read_text("utf-8"))
    assert logged == lines
    assert len(lines) > 10_000


def test_a_launch_that_ends_by_itself_waits_for_a_slow_screen(
    tmp_path: Path, wait_until: Callable[..., None]
) -> None:
    file = tmp_path / "some.launch.py"
    code = "for number in range(8000): print(number)"  # more than a pipe holds, less than the backlog
    file.write_text(
        "import sys\nfrom launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n"
        "def generate_launch_description():\n"
        f"    return LaunchDescription([ExecuteProcess(cmd=[sys.executable, '-c', {code!r}], output='screen')])\n",
        "utf-8",
    )
    with launched(file, tmp_path / "log") as (process, screen):
        screen.pause_s = float("inf")
        logs = (tmp_path / "log").rglob
        started = (
            "process started with pid"  # looked for in the log, because the process may end between two looks
        )
        wait_until(lambda: any(started in log.read_text("utf-8") for log in logs("launch.log")), timeout_s=60)
        wait_until(lambda: len(process.children()) < 2, timeout_s=60, what="the process to end or wait")
        screen.pause_s = 0.0
        assert process.wait(60) == 0
        wait_until(lambda: b"finished cleanly" in screen.text)
        assert b"7999\n" in screen.text


def test_a_long_line_may_come_in_single_characters(launch: Launch) -> None:
    """What has come of it is not copied with each character: that takes minutes for some hundred thousand."""
    code = "import os\nfor _ in range(60_000): os.write(1, b'y' * 10)\nos.write(1, b'\\nend\\n')"
    ran = launch(ExecuteProcess(cmd=[sys.executable, "-c", code], name="dots", output="screen"))
    assert [line for line in ran.lines if line.startswith("[dots-1] ")] == [
        f"[dots-1] {'y' * 600_000}",
        "[dots-1] end",
    ]


def test_a_process_that_is_not_read_is_read_to_its_end_when_the_screen_goes_on(
    launch: Launch, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(background_writing, "MAX_BACKLOG", 1000)
    launch_logging.launch_config.log_handler_factory = lambda path: slow_handler(path, 0.01)
    code = "for number in range(100_000): print(number)"
    ran = launch(ExecuteProcess(cmd=[sys.executable, "-c", code], name="loud", output="log"))
    assert ran.code == 0
    folder = Path(launch_logging.launch_config.log_dir)
    launch_logging.reset()
    logged = re.findall(r"\[loud-1\] (.*)\n", (folder / "launch.log").read_text("utf-8"))
    assert logged == [str(number) for number in range(100_000)]


def test_no_thread_is_left_and_the_next_launch_writes(launch: Launch) -> None:
    before = set(threading.enumerate())
    for _ in range(2):
        launch(ExecuteProcess(cmd=["echo", "heard"], output="both"))
        text = Path(launch_logging.launch_config.get_log_file_path()).read_text("utf-8")
        assert text.splitlines()[-2].endswith(" [echo-1] heard") or " [echo-1] heard\n" in text
    assert set(threading.enumerate()) == before


def test_users_handlers_get_a_record_of_each_line(launch: Launch) -> None:
    records: list[logging.LogRecord] = []

    class Collects(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            records.append(record)

    launch_logging.launch_config.log_handler_factory = lambda _: Collects()
    launch(ExecuteProcess(cmd=["printf", "a\\nb\\n"], name="two", output="log"))
    assert [record.getMessage() for record in records if record.name == "two-1-stdout"] == [
        "[two-1] a",
        "[two-1] b",
    ]


@pytest.mark.parametrize(
    "line_format", ["{line}", "<{this.process_details[name]}> {line:>3}!", "{{line}} {line}"]
)
def test_lines_have_the_format_of_their_action(launch: Launch, line_format: str) -> None:
    ran = launch(
        ExecuteProcess(cmd=["printf", "a\\nb\\n"], name="two", output="screen", output_format=line_format)
    )
    expected = {
        "{line}": ["a", "b"],
        "<{this.process_details[name]}> {line:>3}!": ["<two-1>   a!", "<two-1>   b!"],
        "{{line}} {line}": ["{line} a", "{line} b"],
    }
    assert [line for line in ran.lines if "[INFO]" not in line] == expected[line_format]


class Gate:
    """A destination that takes nothing until it is opened."""

    def __init__(self) -> None:
        self.opened = threading.Event()
        self.texts: list[str] = []

    def write(self, text: str) -> None:
        assert self.opened.wait(30)
        self.texts.append(text)


def test_a_writer_keeps_the_order_and_what_it_cannot_write_yet(wait_until: Callable[..., None]) -> None:
    gate, writer = Gate(), BackgroundWriter("file")
    for number in range(10):
        writer.put(gate.write, f"{number}" * 20_000, is_droppable=True)
    assert not writer.is_behind
    assert writer.idle_s() > 0.0
    for _ in range(10):
        writer.put(gate.write, "a" * 100_000, is_droppable=True)
    assert writer.is_behind
    gate.opened.set()
    wait_until(lambda: writer.idle_s() is None)
    assert not writer.is_behind
    text = "".join(gate.texts)
    assert text == "".join(f"{number}" * 20_000 for number in range(10)) + "a" * 1_000_000
    writer.end()


def test_a_writer_of_the_screen_that_hurries_leaves_out_what_may_be(wait_until: Callable[..., None]) -> None:
    gate, writer = Gate(), BackgroundWriter(SCREEN)
    writer.put(gate.write, "a" * (background_writing.MAX_BACKLOG + 1), is_droppable=True)
    writer.hurry()
    assert not writer.is_behind
    writer.put(gate.write, "lost\nlost\n", is_droppable=True)
    writer.put(gate.write, "kept\n", is_droppable=False)
    assert writer.dropped_lines == 2
    gate.opened.set()
    wait_until(lambda: writer.idle_s() is None)
    assert "".join(gate.texts).endswith("akept\n")
    writer.end()


def test_a_file_that_takes_nothing_is_given_up_after_some_seconds(monkeypatch: pytest.MonkeyPatch) -> None:
    gate, writer = Gate(), BackgroundWriter("file")
    writer.put(gate.write, "a" * (background_writing.MAX_BACKLOG + 1), is_droppable=True)
    writer.hurry()
    assert writer.is_behind
    monkeypatch.setattr(background_writing, "STUCK_S", 0.0)
    assert not writer.is_behind
    writer.put(gate.write, "lost\n", is_droppable=True)
    assert writer.dropped_lines == 1
    writer.end()
    gate.opened.set()


def test_a_destination_that_fails_in_the_background_is_named_once(
    launch: Launch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Full(io.StringIO):
        def write(self, _: str) -> int:
            raise OSError(errno.ENOSPC, "No space left on device")

    def full_handler(path: str) -> logging.Handler:
        handler = launch_logging._file_handler(path)
        handler.stream.close()
        handler.stream = Full()
        return handler

    launch_logging.launch_config.log_handler_factory = full_handler
    errors: list[str] = []
    code = "for number in range(3): print(number, flush=True)"
    ran = launch(
        RegisterEventHandler(
            OnProcessIO(on_stdout=lambda _: errors.append(capsys.readouterr().err) or Shutdown())
        ),
        ExecuteProcess(cmd=[sys.executable, "-c", code], output="both"),
    )
    assert ran.code == 0
    said = "".join(errors)
    assert said.count("lines of") == said.count("No space left on device") >= 1
    assert "Traceback" not in said
