"""`tfloom demo robot`: what it prints and records, and that no process is left at any end."""

from __future__ import annotations

import re
import signal
import threading
import urllib.request
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.demos.marked import alive, kill_when_there
from tests.docs import page

from tfloom.bag.opening import open_bag
from tfloom.demos import robot_show
from tfloom.demos.program_group import ShowError
from tfloom.demos.robot_show import RobotShow, example_folder, new_recording

Start = Callable[..., Any]


@pytest.mark.wire
def test_demonstration_prints_what_its_page_says_records_and_ends(
    start_program: Start, tmp_path: Path, mark: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("viser", reason="the page needs the extra: pip install 'tfloom[view]'")
    (command,) = page.commands(page.blocks(page.DOCS / "how_to" / "robot_in_a_room.md"))
    monkeypatch.setenv("BROWSER", f"sh -c 'touch {tmp_path}.opened' %s")
    monkeypatch.delenv("CI", raising=False)
    demo = start_program(*command.words.split(), "--view", cwd=tmp_path)
    line = demo.wait_for("See it in a browser: http://127.0.0.1:")
    with urllib.request.urlopen(line.removeprefix("See it in a browser: ")) as response:
        assert b"<title>tfloom view</title>" in response.read()
    assert demo.wait(150.0) == 0, demo.output
    assert page.pattern(command.output).match(page.MASKED.sub("#", demo.output + "\n")), demo.output
    assert Path(f"{tmp_path}.opened").exists()
    assert re.search(
        r"odometry is off by \d\.\d\d m, the corrected pose off by 0\.\d\d m$", demo.output, re.MULTILINE
    )
    (recording,) = tmp_path.iterdir()
    assert any(re.fullmatch(rf"The recording is in {recording} \(\d+\.\d MB\)", line) for line in demo.lines)
    assert re.match(r"odometry alone +\d+\.\d m +0\.\d{3} m", demo.lines[-2]), demo.output
    assert re.match(r"corrected +\d+\.\d m +0\.\d{3} m", demo.lines[-1]), demo.output
    assert "Traceback" not in demo.output
    with open_bag(recording) as bag:
        assert {"/tf", "/tf_static", "/scan", "/ground_truth", "/map", "/cmd_vel"} <= set(bag.topics)
        assert bag.topics["/ground_truth"].message_count > 10
    assert alive(mark) == {}


@pytest.mark.wire
@pytest.mark.parametrize("number", [signal.SIGINT, pytest.param(signal.SIGKILL, marks=pytest.mark.slow)])
def test_no_process_is_left_by_an_early_end(
    start_program: Start, wait_until: Callable[..., None], tmp_path: Path, mark: str, number: signal.Signals
) -> None:
    demo = start_program("tfloom", "demo", "robot", "--seconds", "60", cwd=tmp_path)
    wait_until(lambda: any("pose_errors.py" in command for command in alive(mark).values()))
    demo.signal(number)
    assert demo.wait() == (-signal.SIGKILL if number == signal.SIGKILL else 0), demo.output
    wait_until(lambda: alive(mark) == {}, what="the end of all processes")
    if number == signal.SIGINT:
        assert demo.lines[-1] == "It ended before the mapper worked, so there is nothing to compare."
    assert "Traceback" not in demo.output


@pytest.mark.wire
def test_program_that_ends_unexpectedly_is_reported(start_program: Start, tmp_path: Path, mark: str) -> None:
    demo = start_program("tfloom", "demo", "robot", "--seconds", "60", cwd=tmp_path)
    kill_when_there("mapper.py", mark)
    assert demo.wait() == 1
    assert "mapper ended unexpectedly with exit code -9" in demo.output
    assert alive(mark) == {}


def test_it_needs_processes(start_program: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    demo = start_program("tfloom", "demo", "robot", cwd=tmp_path)
    assert demo.wait() == 1
    assert demo.output == "`tfloom demo robot` needs a DDS library, because its programs are processes"
    unknown = start_program("tfloom", "demo", "dog")
    assert unknown.wait() == 2
    assert "invalid choice: 'dog'" in unknown.output


class Stopped:
    """A program that prints nothing and does not end."""

    log = ("the last line",)

    def __init__(self, code: int | None = None) -> None:
        self.code = code

    def exit_code(self) -> int | None:
        return self.code

    def request_end(self) -> None:
        self.code = 0

    def end(self, grace_s: float) -> None:
        assert self.code is not None


def test_mapper_that_does_not_work_is_reported(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(robot_show, "PATIENCE_S", 0.1)
    show = RobotShow(lambda *_: Stopped(), example_folder(), tmp_path / "x", has_page=False)
    with show, pytest.raises(ShowError, match="the robot's pose was not corrected in 0 s"):
        show.run(1.0)


class Working(Stopped):
    """A program that does not end, and reports that the mapper works."""

    def __init__(self, command: list[str], on_line: Callable[[str], object] | None) -> None:
        super().__init__()
        self.command = command
        if on_line is not None:
            on_line(f"After 1.0 m: {robot_show.IS_CORRECTED} 0.01 m")


def test_full_recording_ends_and_the_robot_drives_on(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(robot_show, "MAX_RECORDING_MB", 1)
    monkeypatch.setattr(robot_show, "LOOK_S", 0.0)
    recording = tmp_path / "x"
    recording.mkdir()
    (recording / "x_0.mcap").write_bytes(bytes(999_999))
    programs: list[Working] = []

    def start(command: list[str], on_line: Callable[[str], object] | None) -> Working:
        programs.append(Working(command, on_line))
        return programs[-1]

    def ended() -> list[str]:
        return [program.command[2] for program in programs if program.code is not None]

    with RobotShow(start, example_folder(), recording, has_page=False) as show:
        show.run(0.0)
        assert ended() == []
        (recording / "x_1.mcap").write_bytes(b"1")
        for _ in range(2):
            show.run(0.3)
            assert ended() == ["record"]
        others = next(program for program in programs if "robot.py" in program.command[0])
        others.code = 7
        with pytest.raises(ShowError, match="robot ended unexpectedly with exit code 7"):
            show.run(0.3)
    said = "The recording has 1 MB, and ends; the robot drives on."
    assert capsys.readouterr().out.count(said) == 1


def test_nothing_is_recorded_where_nobody_wants_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert "recorder" not in robot_show.robot_programs(example_folder(), None, has_page=False)
    with RobotShow(Working, example_folder(), None, has_page=False) as show:
        show.run(0.0)
    show.compare()
    assert "recording" not in capsys.readouterr().out


def test_a_page_that_is_slow_is_awaited(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its program needs longer to start than the others, and on a busy machine longer than the demonstration lasts."""

    def start(command: list[str], on_line: Callable[[str], object] | None) -> Stopped:
        if "view" in command:
            slow.append(on_line)
        elif on_line is not None:
            on_line(f"After 1.0 m: {robot_show.IS_CORRECTED} 0.01 m")
        return Stopped()

    slow: list[Any] = []
    show = RobotShow(start, example_folder(), tmp_path / "x", has_page=True)
    with show:
        opening = threading.Timer(0.5, lambda: slow[0]("Open http://127.0.0.1:1/"))
        opening.start()
        show.run(0.0)
    assert "See it in a browser: http://127.0.0.1:1/" in capsys.readouterr().out
    monkeypatch.setattr(robot_show, "PATIENCE_S", 0.1)
    with (
        RobotShow(start, example_folder(), tmp_path / "x", has_page=True) as late,
        pytest.raises(ShowError, match="the page was not there in 0 s"),
    ):
        late.run(0.0)


@pytest.mark.parametrize("opens_page", [False, True])
def test_address_of_a_page_that_was_asked_for_is_last(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, *, opens_page: bool
) -> None:
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    monkeypatch.setenv("CI", "yes")  # where nobody would see it

    def start(command: list[str], on_line: Callable[[str], object] | None) -> Stopped:
        if "view" in command and on_line is not None:
            on_line("Open http://127.0.0.1:1/")
        elif on_line is not None:
            for line in (
                "After 0.5 m: odometry alone",
                f"After 1.0 m: {robot_show.IS_CORRECTED} 0.01 m",
                "After 9 m",
            ):
                on_line(line)
        return Stopped()

    show = RobotShow(start, example_folder(), tmp_path / "x", has_page=True, opens_page=opens_page)
    with show:
        show.run(0.5)
    lines = capsys.readouterr().out.splitlines()
    address = lines.index("See it in a browser: http://127.0.0.1:1/")
    assert (address, len(lines)) == ((2, 3) if opens_page else (0, 4))
    assert opened == []
    monkeypatch.delenv("CI")
    monkeypatch.setenv("DISPLAY", ":7")
    with RobotShow(start, example_folder(), tmp_path / "y", has_page=True, opens_page=opens_page):
        assert opened == ["http://127.0.0.1:1/"] * opens_page


def test_comparison_that_fails_or_hangs_is_reported(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for code, text in (
        (1, "compare ended unexpectedly with exit code 1\nthe last line"),
        (None, "has not ended"),
    ):
        monkeypatch.setattr(robot_show, "PATIENCE_S", 0.1)
        show = RobotShow(
            lambda *_, code=code: Stopped(code), example_folder(), tmp_path / "x", has_page=False
        )
        show._works = True
        with pytest.raises(ShowError, match=text):
            show.compare()


def test_recording_gets_a_new_name(tmp_path: Path) -> None:
    paths = set()
    for _ in range(4):
        path = new_recording(tmp_path)
        path.mkdir()
        paths.add(path)
    assert len(paths) == 4


def test_example_that_was_left_out_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    assert (example_folder() / "compare.py").is_file()
    monkeypatch.setattr(robot_show, "EXAMPLE", "robot_on_the_moon")
    with pytest.raises(
        ShowError, match=r"the example's programs are not in .*robot_on_the_moon: install tfloom again"
    ):
        example_folder()
