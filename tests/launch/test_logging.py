"""Logs: formats, levels, the folder, and errors."""

from __future__ import annotations

import errno
import io
import logging
import logging.handlers
import os
import re
import socket
import sys
from pathlib import Path
from typing import Any

import pytest

from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.log import LogInfo
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.launch_service import LaunchService
from tfloom.launch.logs import library_handlers
from tfloom.launch.logs import logging as launch_logging
from tfloom.launch.logs.log_handlers import BraceFormatter
from tfloom.launch.logs.logging import get_logger, get_output_loggers, launch_config


def lines(capsys: pytest.CaptureFixture[str]) -> list[str]:
    return capsys.readouterr().out.splitlines()


def test_a_record_is_on_the_screen_and_in_the_log(capsys: pytest.CaptureFixture[str]) -> None:
    get_logger("launch.user").warning("%d wheels", 3)
    assert lines(capsys) == ["[WARNING] [launch.user]: 3 wheels"]
    path = Path(launch_config.get_log_file_path())
    assert path.name == "launch.log"
    assert re.fullmatch(r"\d+\.\d{7} \[WARNING\] \[launch\.user\]: 3 wheels\n", path.read_text("utf-8"))


def test_the_folder_is_named_after_time_host_and_process() -> None:
    folder = Path(launch_config.log_dir)
    assert folder.parent == Path(os.environ["ROS_LOG_DIR"])
    stamp = r"\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d-\d{6}"
    assert re.fullmatch(f"{stamp}-{re.escape(socket.gethostname())}-{os.getpid()}", folder.name)
    assert launch_config.log_dir == str(folder)
    with pytest.raises(ValueError, match="Cannot set log directory"):
        launch_config.log_dir = str(folder.parent)
    with pytest.raises(ValueError, match="/elsewhere is not a directory"):
        launch_config.log_dir = "/elsewhere"


def test_ros_home_holds_the_logs_otherwise(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv("ROS_LOG_DIR")
    monkeypatch.setenv("ROS_HOME", str(tmp_path))
    assert Path(launch_config.log_dir).parent == tmp_path / "log"


def test_nothing_is_written_before_the_first_record() -> None:
    get_logger("launch.quiet").debug("not logged")
    assert list(Path(os.environ["ROS_LOG_DIR"]).iterdir()) == []


def test_the_level_applies_to_all_loggers(capsys: pytest.CaptureFixture[str]) -> None:
    early = get_logger("early")
    early.debug("no")
    launch_config.level = "DEBUG"
    early.debug("yes")
    get_logger("late").debug("yes")
    launch_config.level = logging.ERROR
    early.warning("no")
    assert lines(capsys) == ["[DEBUG] [early]: yes", "[DEBUG] [late]: yes"]


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("default_with_timestamp", r"\d+\.\d{7} \[INFO\] \[a\]: hi"),
        ("{name}/{levelname}/{msg}", "a/INFO/hi"),
        ("{wrong}", "INFO a: hi"),
        ("{message} of {name}", "hi of a"),
        ("{message:>4}|{msg}", r"  hi\|hi"),
        ("{asctime} {message}", r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d,\d{3} hi"),
    ],
)
def test_the_screen_has_the_format_of_the_environment(
    text: str, line: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("OVERRIDE_LAUNCH_SCREEN_FORMAT", text)
    launch_logging.reset()
    get_logger("a").info("hi")
    (printed,) = lines(capsys)
    assert re.fullmatch(line, printed)


@pytest.mark.parametrize("text", ["{message} of {name}", "{asctime}: {message}", "{{message}} {message}"])
def test_lines_of_a_process_have_the_format_of_the_environment(
    text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A loud process's lines are formatted together."""
    record = logging.LogRecord("talker-1", logging.INFO, "", 0, "one", (), None)
    formatter = BraceFormatter(text)
    around = formatter.around_message(record)
    line = formatter.format(record)
    assert line.endswith(("one", "one of talker-1"))
    assert around is None or line == "one".join(around)


def test_a_log_folder_is_made_anew_after_it_was_reset(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path))
    first = launch_config.log_dir
    launch_config.log_dir = None
    assert launch_config.log_dir != first
    launch_config.log_dir = None
    launch_config.log_dir = str(tmp_path)
    assert launch_config.log_dir == str(tmp_path)


@pytest.mark.parametrize("config", ["file", {"stdin": "screen"}, {"both": ["screen", "disk"]}])
def test_an_output_that_does_not_exist_is_named(config: object) -> None:
    with pytest.raises(ValueError, match="'talker-1'"):
        get_output_loggers("talker-1", config)


def test_a_traceback_is_logged_with_its_record(capsys: pytest.CaptureFixture[str]) -> None:
    try:
        {}["wheel"]
    except KeyError:
        get_logger("a").exception("lost")
    printed = lines(capsys)
    assert printed[0] == "[ERROR] [a]: lost"
    assert printed[-1] == "KeyError: 'wheel'"


def test_a_screen_that_nobody_reads_any_more_is_no_error(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Closed(io.StringIO):
        def write(self, _: str) -> int:
            raise BrokenPipeError

    with monkeypatch.context() as patch:
        patch.setattr(sys, "stdout", Closed())
        get_logger("launch.user").warning("unread")
    assert capsys.readouterr().err == ""
    assert "unread" in Path(launch_config.get_log_file_path()).read_text("utf-8")


def test_a_full_disk_is_said_once_and_not_by_tracebacks(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Full(io.StringIO):
        def write(self, _: str) -> int:
            raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(sys, "stdout", Full())
        get_logger("launch.user").warning("unread")
        get_logger("launch.user").warning("unread, too")
    assert capsys.readouterr().err == "[launch]: lines of stdout are lost: No space left on device\n"


def test_a_log_folder_that_cannot_be_created_is_named_once_and_the_launch_goes_on(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "file" / "log"))
    launch_logging.log_launch_config(logger=get_logger("launch"))
    get_logger("launch.user").warning("on the screen")
    output, _ = get_output_loggers("talker", "both")
    output.info("on the screen, too")
    printed = capsys.readouterr()
    assert printed.out.splitlines()[1:] == ["[WARNING] [launch.user]: on the screen", "on the screen, too"]
    assert "lines of launch.log are lost" in printed.err
    assert "set ROS_LOG_DIR" in printed.err
    assert len(printed.err.splitlines()) == 1
    with pytest.raises(OSError, match="set ROS_LOG_DIR"):
        print(launch_config.log_dir)


def test_a_new_launch_tells_of_its_own_log_folder(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    for _ in range(2):
        monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "file" / "log"))
        get_logger("launch.user").warning("nowhere")
        launch_logging.reset()
    assert capsys.readouterr().err.count("are lost") == 2
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    get_logger("launch.user").warning("somewhere")
    assert "somewhere" in Path(launch_config.get_log_file_path()).read_text("utf-8")


@pytest.mark.parametrize("variable", ["OVERRIDE_LAUNCH_SCREEN_FORMAT", "OVERRIDE_LAUNCH_LOG_FORMAT"])
def test_the_environment_overrides_the_format_that_a_program_sets(
    variable: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv(variable, r"{levelname}\t{msg}")
    launch_config.set_screen_format("%(msg)s", screen_style="%")
    launch_config.set_log_format("$name", log_style="$")
    get_logger("a").info("hi")
    log = Path(launch_config.get_log_file_path()).read_text("utf-8")
    if "SCREEN" in variable:
        assert (lines(capsys), log) == (["INFO\thi"], "a\n")
    else:
        assert (lines(capsys), log) == (["hi"], "INFO\thi\n")


def test_a_format_applies_to_loggers_that_are_there(capsys: pytest.CaptureFixture[str]) -> None:
    logger = get_logger("a")
    logger.info("one")
    launch_config.set_screen_format("default_with_timestamp")
    launch_config.set_log_format("{msg}!")
    logger.info("two")
    assert re.fullmatch(r"\d+\.\d{7} \[INFO\] \[a\]: two", lines(capsys)[1])
    assert Path(launch_config.get_log_file_path()).read_text("utf-8").splitlines()[1] == "two!"


def test_a_style_that_does_not_exist_or_is_that_of_a_default_is_refused() -> None:
    with pytest.raises(ValueError, match=r"'\?' is not a style of formats: use one of \{ % "):
        launch_config.set_screen_format("{msg}", screen_style="?")
    with pytest.raises(ValueError, match="a style can't be set for the format 'default'"):
        launch_config.set_screen_format("default", screen_style="{")
    with pytest.raises(ValueError, match="a style can't be set for the format 'default'"):
        launch_config.set_log_format("default", log_style="%")


def test_the_handlers_that_a_logger_has_write_a_record_once(capsys: pytest.CaptureFixture[str]) -> None:
    logger = get_logger("some-process")
    logger.addHandler(launch_config.get_screen_handler())
    logger.addHandler(launch_config.get_log_file_handler())
    logger.error("once")
    assert lines(capsys) == ["[ERROR] [some-process]: once"]
    assert len(Path(launch_config.get_log_file_path()).read_text("utf-8").splitlines()) == 1


def test_a_factory_makes_the_handlers_of_log_files() -> None:
    written: dict[str, list[str]] = {}

    class Keeping(library_handlers.Handler):
        def __init__(self, path: str) -> None:
            super().__init__()
            self._path = path

        def emit(self, record: logging.LogRecord) -> None:
            written.setdefault(self._path, []).append(self.format(record))

    launch_config.log_handler_factory = lambda path, encoding=None: Keeping(f"{path} {encoding}")
    get_logger("a").error("bar")
    launch_logging.reset()
    assert written.popitem()[1][0].endswith("[ERROR] [a]: bar")
    launch_config.log_handler_factory = Keeping
    get_logger("b").error("bar")
    assert written.popitem()[0] == launch_config.get_log_file_path()


def test_library_handlers_format_by_logger() -> None:
    stream = io.StringIO()
    handler = library_handlers.StreamHandler(stream)
    handler.setFormatter(logging.Formatter("%(message)s"))
    loud, quiet = logging.Logger("loud"), logging.Logger("quiet")  # noqa: LOG001  # not in the registry
    for logger in (loud, quiet):
        logger.addHandler(handler)
    handler.setFormatterFor(loud, logging.Formatter("%(message)s!"))
    loud.info("a")
    quiet.info("b")
    handler.unsetFormatterFor(loud)
    loud.info("c")
    assert stream.getvalue() == "a!\nb\nc\n"
    assert handler.getFormatterFor(loud) is handler.formatter


@pytest.mark.parametrize("name", library_handlers.__all__)
def test_each_standard_handler_is_one_of_that_name(name: str) -> None:
    base = getattr(logging, name, None) or getattr(logging.handlers, name)
    assert issubclass(getattr(library_handlers, name), base)


def test_private_names_that_programs_use(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import launch.logging

    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "there"))
    assert launch.logging._get_logging_directory() == str(tmp_path / "there")
    made = Path(launch.logging._make_unique_log_dir(base_path=str(tmp_path / "here")))
    assert made.is_dir()
    assert made.parent == tmp_path / "here"
    assert launch.logging._make_unique_log_dir(base_path=str(tmp_path / "here")) != str(made)


def test_the_link_latest_leads_to_the_last_launchs_folder() -> None:
    link = Path(os.environ["ROS_LOG_DIR"], "latest")
    folder = launch_config.log_dir
    assert link.is_symlink()
    assert link.resolve() == Path(folder).resolve()
    launch_config.reset()
    assert launch_config.log_dir != folder
    assert link.resolve() == Path(launch_config.log_dir).resolve()
    assert sorted(path.name for path in link.parent.iterdir()) == sorted(
        [Path(folder).name, Path(launch_config.log_dir).name, "latest"]
    )


@pytest.mark.parametrize("kind", ["file", "folder"])
def test_what_is_called_latest_and_is_no_link_stays(kind: str, tmp_path: Path) -> None:
    folder, latest = tmp_path / "log", tmp_path / "latest"
    folder.mkdir()
    if kind == "file":
        latest.write_text("mine")
    else:
        latest.mkdir()
    assert not launch_logging._renew_latest_log_dir(log_dir=str(folder))
    assert not latest.is_symlink()
    latest.rename(tmp_path / "mine")
    assert launch_logging._renew_latest_log_dir(log_dir=str(folder))
    assert latest.resolve() == folder.resolve()


def test_a_link_that_can_not_be_created_ends_nothing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def refuse(*args: object, **kwargs: object) -> None:
        raise OSError(errno.EPERM, "a required privilege is not held by the client")

    monkeypatch.setattr(Path, "symlink_to", refuse)
    folder = launch_config.log_dir
    assert Path(folder).is_dir()
    assert [path.name for path in Path(folder).parent.iterdir()] == [Path(folder).name]
    monkeypatch.undo()
    monkeypatch.setattr(Path, "replace", refuse)
    assert not launch_logging._renew_latest_log_dir(log_dir=folder)
    assert [path.name for path in Path(folder).parent.iterdir()] == [Path(folder).name]


def test_log_file_has_the_name_that_the_launch_gives_it() -> None:
    service = LaunchService(log_file_name="mine.log")
    service.include_launch_description(
        LaunchDescription(
            [LogInfo(msg="first"), ExecuteProcess(cmd=[sys.executable, "-c", "print(1)"], output="log")]
        )
    )
    assert service.run() == 0
    folder = Path(launch_config.log_dir)
    text = (folder / "mine.log").read_text("utf-8")
    assert "[launch.user]: first" in text
    assert [line.split()[-1] for line in text.splitlines() if "[python" in line and "] 1" in line] == ["1"]
    assert not (folder / "launch.log").exists()
    launch_logging.reset()
    LaunchService()
    get_logger("launch.user").info("second")
    assert "second" in Path(launch_config.get_log_file_path()).read_text("utf-8")
    assert Path(launch_config.get_log_file_path()).name == "launch.log"


@pytest.mark.parametrize("name", ["", "a/b.log", "/tmp/a.log", "..", "a\0b", 5])
def test_log_file_is_in_the_log_folder(name: Any) -> None:
    with pytest.raises(ValueError, match="is not the name of a log file: give one without folders"):
        LaunchService(log_file_name=name)
    assert launch_config.log_file_name == "launch.log"
