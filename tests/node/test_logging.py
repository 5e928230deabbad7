"""Loggers: ROS's console format, levels by name, and filters."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from tfloom.interfaces.rcl_interfaces.msg import Log
from tfloom.node import implementation
from tfloom.node.clock.clock import Clock, ROSClock
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.log import logging, logging_filters
from tfloom.node.log.log_file import LogFile
from tfloom.node.log.log_output import LoggingSeverity
from tfloom.node.log.rcutils_logger import RcutilsLogger
from tfloom.node.node import Node
from tfloom.node.values.time import ClockType, Time

Capture = pytest.CaptureFixture[str]


def lines(capsys: Capture) -> list[str]:
    captured = capsys.readouterr()
    assert captured.out == ""
    return captured.err.splitlines()


def test_console_format_is_that_of_ros(capsys: Capture) -> None:
    logging.get_logger("talker").info('Publishing: "Hello World: 0"')
    (line,) = lines(capsys)
    assert re.fullmatch(r'\[INFO\] \[\d{10}\.\d{9}\] \[talker\]: Publishing: "Hello World: 0"', line)


@pytest.mark.parametrize("name", ["debug", "info", "warn", "warning", "error", "fatal"])
def test_each_severity_has_its_name(name: str, capsys: Capture) -> None:
    logger = logging.get_logger("x")
    logger.set_level(LoggingSeverity.DEBUG)
    assert getattr(logger, name)("text")
    (line,) = lines(capsys)
    assert line.startswith(f"[{'WARN' if name == 'warning' else name.upper()}]")


def test_levels_apply_to_child_loggers(capsys: Capture) -> None:
    child = logging.get_logger("a").get_child("b")
    assert child.name == "a.b"
    assert not child.debug("no")
    logging.get_logger("a").set_level(LoggingSeverity.DEBUG)
    assert child.debug("yes")
    assert child.get_effective_level() is LoggingSeverity.DEBUG
    assert not logging.get_logger("ab").debug("no")
    logging.set_logger_level("a.b", LoggingSeverity.ERROR)
    assert not child.warning("no")
    logging.set_logger_level("a.b", LoggingSeverity.UNSET)
    assert child.is_enabled_for(LoggingSeverity.DEBUG)
    assert logging.get_logger_level("a.b") is LoggingSeverity.UNSET
    assert len(lines(capsys)) == 1


def test_console_format_can_be_set(monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> None:
    monkeypatch.setenv(
        "RCUTILS_CONSOLE_OUTPUT_FORMAT", "{severity}|{name}|{message}|{function_name}|{nope}|{"
    )
    logging.get_logger("x").info("a {name} b")
    assert lines(capsys) == ["INFO|x|a {name} b|test_console_format_can_be_set|{nope}|{"]


def test_escapes_are_expanded_in_formats_and_kept_in_messages(
    monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.setenv("RCUTILS_CONSOLE_OUTPUT_FORMAT", r"\x1b[1m{name}\x1b[0m\t{message}\n \q{line_number")
    logging.get_logger("x").info(r"a\nb")
    assert lines(capsys) == ["\x1b[1mx\x1b[0m\t" + r"a\nb", r" \q{line_number"]


def test_colour_and_stdout_on_request(monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> None:
    monkeypatch.setenv("RCUTILS_COLORIZED_OUTPUT", "1")
    monkeypatch.setenv("RCUTILS_LOGGING_USE_STDOUT", "1")
    logging.get_logger("x").error("red")
    captured = capsys.readouterr()
    assert captured.err == ""
    assert captured.out.startswith("\033[31m[ERROR]")
    assert captured.out.endswith("red\033[0m\n")


def said(log: Callable[[int], bool]) -> list[int]:
    return [number for number in range(4) if log(number)]


def test_once_and_skip_first() -> None:
    logger = logging.get_logger("x")
    assert said(lambda number: logger.info(number, once=True)) == [0]
    assert said(lambda number: logger.info(number, skip_first=True)) == [1, 2, 3]
    assert said(logger.info) == [0, 1, 2, 3]


def test_throttle_by_a_clock() -> None:
    logger = logging.get_logger("x")
    clock = ROSClock()
    clock.set_ros_time_is_active(True)

    def log(second: int) -> bool:
        clock.set_ros_time_override(Time(seconds=second, clock_type=ClockType.ROS_TIME))
        return logger.info(second, throttle_duration_sec=2, throttle_time_source_type=clock)

    assert said(log) == [0, 2]


def test_the_first_call_that_is_not_skipped_is_the_one_of_once() -> None:
    logger = logging.get_logger("x")
    assert said(lambda number: logger.info(number, skip_first=True, once=True)) == [1]


def test_the_period_begins_with_the_call_that_is_skipped() -> None:
    logger = logging.get_logger("x")
    clock = ROSClock()
    clock.set_ros_time_is_active(True)

    def log(second: int) -> bool:
        clock.set_ros_time_override(Time(seconds=second, clock_type=ClockType.ROS_TIME))
        return logger.info(second, skip_first=True, throttle_duration_sec=3, throttle_time_source_type=clock)

    assert [second for second in range(10) if log(second)] == [3, 6, 9]


FETCHES: dict[str, Callable[[Node], RcutilsLogger]] = {
    "child": lambda node: node.get_logger().get_child("child"),
    "grandchild": lambda node: node.get_logger().get_child("child").get_child("grandchild"),
    "named": lambda _: logging.get_logger("fetched"),
    "child of named": lambda _: logging.get_logger("fetched").get_child("child"),
    "constructed": lambda _: RcutilsLogger("constructed"),
}


@pytest.mark.parametrize("fetch", FETCHES)
def test_filters_hold_for_the_name_where_each_call_fetches_its_logger(fetch: str, node: Node) -> None:
    def logger() -> RcutilsLogger:
        return FETCHES[fetch](node)

    assert said(lambda text: logger().info(text, once=True)) == [0]
    assert said(lambda text: logger().info(text, skip_first=True)) == [1, 2, 3]
    assert said(lambda text: logger().info(text, throttle_duration_sec=60)) == [0]
    assert said(lambda text: logger().get_child(f"c{text}").info(text, once=True)) == [0, 1, 2, 3]


def test_a_fetched_logger_may_be_called_in_another_way_as_a_new_one_there() -> None:
    def log(severity: LoggingSeverity, **options: Any) -> bool:
        return logging.get_logger("helper").log("x", severity, **options)

    calls = [
        lambda: log(LoggingSeverity.INFO, once=True),
        lambda: log(LoggingSeverity.WARN, once=True),
        lambda: log(LoggingSeverity.INFO, skip_first=True, once=True),
        lambda: log(LoggingSeverity.INFO, throttle_duration_sec=1.0, throttle_time_source_type=Clock()),
        lambda: log(LoggingSeverity.INFO, throttle_duration_sec=60.0, throttle_time_source_type=Clock()),
    ]
    assert [call() for call in calls * 2] == [True, True, False, True, True, False, False, True, False, False]


def test_the_next_node_of_a_name_begins_anew(make_node: Callable[..., Node]) -> None:
    logged = []
    for _ in range(2):
        node = make_node("twice")
        logged += [node.get_logger().get_child("child").info("x", once=True) for _ in range(2)]
        node.destroy_node()
    assert logged == [True, False, True, False]


def test_places_are_forgotten_beyond_a_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(logging_filters, "MAX_FILTERS", 10)
    table = logging_filters.FilterTable()
    logged = [RcutilsLogger(f"n{number}", table).info("x", once=True) for number in [*range(30), 29, 0]]
    assert logged == [True] * 30 + [False, True]
    assert len(table._filters) == 10


@pytest.mark.parametrize(
    ("seconds", "expected"),
    [
        ([0, 0, 0, 0.5, 1, 1.5, 2], [True, False, False, False, True, False, True]),
        ([0.2, 0.9, 1.1, 1.3], [True, False, False, True]),
        ([0, 0, 100, 100.5, 101], [True, False, True, False, True]),
        ([5, 5, 3, 3.5, 4.1], [True, False, True, False, True]),
        ([100, 100.5, 0, 0, 1], [True, False, True, False, True]),
    ],
)
@pytest.mark.parametrize(
    "fetch", [lambda logger: logger, lambda logger: logger.get_child("child")], ids=["one", "each"]
)
def test_throttle_begins_with_the_first_call_of_simulated_time(
    fetch: Callable[[RcutilsLogger], RcutilsLogger], seconds: list[float], expected: list[bool], node: Node
) -> None:
    clock = ROSClock()
    clock.set_ros_time_is_active(True)

    def log(second: float) -> bool:
        clock.set_ros_time_override(Time(seconds=second, clock_type=ClockType.ROS_TIME))
        return fetch(node.get_logger()).info("x", throttle_duration_sec=1, throttle_time_source_type=clock)

    assert [log(second) for second in seconds] == expected


def test_each_logger_counts_its_own_calls(make_node: Callable[..., Node]) -> None:
    loggers = [make_node(name).get_logger() for name in ("first", "second")]
    assert [logger.info("x", once=True) for logger in loggers * 2] == [True, True, False, False]


@pytest.mark.parametrize(
    ("first", "second", "what"),
    [
        ({"once": True}, {"once": False, "skip_first": True}, "Requested logging filters"),
        ({"skip_first": False, "once": False}, {"skip_first": True}, "Requested logging filters"),
        ({"throttle_duration_sec": 1.0}, {"throttle_duration_sec": 2.0}, "Logging filter parameters"),
        (
            {"throttle_duration_sec": 1.0},
            {"throttle_duration_sec": 1.0, "throttle_time_source_type": ROSClock()},
            "Logging filter parameters",
        ),
        ({"once": True, "name": "a"}, {"once": True, "name": "b"}, "Logger name"),
    ],
)
def test_a_place_whose_filters_change_raises(
    first: dict[str, object], second: dict[str, object], what: str
) -> None:
    logger = logging.get_logger("x")
    with pytest.raises(ValueError, match=f"^{what} cannot be changed between calls.$"):  # noqa: PT012  # one place
        for options in (first, second):
            logger.info("x", **options)


def test_a_call_below_the_level_does_not_count() -> None:
    logger = logging.get_logger("below")

    def log(severity: LoggingSeverity, **options: Any) -> bool:
        return logger.log("x", severity, **options)

    assert not log(LoggingSeverity.DEBUG, once=True)
    assert not log(LoggingSeverity.DEBUG, no_such_option=True)
    assert log(LoggingSeverity.INFO, skip_first=False, once=True)
    assert not log(LoggingSeverity.INFO, once=True)  # `skip_first=False` is as none
    with pytest.raises(TypeError, match="no_such_option"):
        log(LoggingSeverity.INFO, no_such_option=True)


def test_a_place_without_filters_may_change_its_severity() -> None:
    logger = logging.get_logger("x")
    assert all(logger.log("x", severity) for severity in (LoggingSeverity.INFO, LoggingSeverity.WARN))


def test_the_roots_logger_has_rclpys_name() -> None:
    assert logging._root_logger.name == ""
    assert logging._root_logger.get_child("a").name == "a"


def test_invalid_options_raise() -> None:
    logger = logging.get_logger("x")
    with pytest.raises(TypeError, match='"nope" is not one of the recognized logging options'):
        logger.info("x", nope=1)
    with pytest.raises(TypeError, match="throttle_duration_sec"):
        logger.info("x", throttle_time_source_type=ROSClock())
    with pytest.raises(TypeError, match="throttle_duration_sec must be a number of seconds, not str"):
        logger.info("x", throttle_duration_sec="1")
    with pytest.raises(ValueError, match='time_source_type of "5" is not a clock instance'):
        logger.info("x", throttle_duration_sec=1, throttle_time_source_type=5)
    with pytest.raises(ValueError, match="severity cannot be changed"):  # noqa: PT012  # one place, two severities
        for severity in (LoggingSeverity.INFO, LoggingSeverity.WARN):
            logger.log("x", severity, once=True)
    with pytest.raises(ValueError, match="must not be empty"):
        logging.get_logger("")
    with pytest.raises(RuntimeError, match="loud"):
        logging.get_logging_severity_from_string("loud")


def test_closed_stream_raises_no_error(monkeypatch: pytest.MonkeyPatch) -> None:
    import io

    stream = io.StringIO()
    stream.close()
    monkeypatch.setattr(sys, "stderr", stream)
    assert logging.get_logger("x").info("into the void")


def test_log_directory_follows_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_LOG_DIR", "/logs")
    assert str(logging.get_logging_directory()) == "/logs"
    monkeypatch.delenv("ROS_LOG_DIR")
    monkeypatch.setenv("ROS_HOME", "/home/ros")
    assert str(logging.get_logging_directory()) == "/home/ros/log"


def test_first_log_line_does_not_import_pathlib() -> None:
    code = """
import sys, rclpy, rclpy.logging
before = set(sys.modules)
rclpy.init()
rclpy.logging.get_logger("x").info("first")
print(sorted({"pathlib", "urllib.parse", "ipaddress"} & set(sys.modules) - before))
"""
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True
    )
    assert result.stdout == "[]\n"


@pytest.fixture
def log_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the folder of log files; it does not exist yet."""
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    return tmp_path / "log"


def test_records_are_also_written_to_a_file(log_folder: Path, capsys: Capture) -> None:
    arguments = ["--ros-args", "--log-file-name", "mine", "--disable-stdout-logs"]
    context = Context()
    context.init(arguments)
    logging.get_logger("x").info("kept")
    context.destroy()
    assert lines(capsys) == []
    (path,) = log_folder.iterdir()
    assert path.name.startswith(f"mine_{os.getpid()}_")
    assert re.fullmatch(r"\[INFO\] \[\d{10}\.\d{9}\] \[x\]: kept\n", path.read_text())


def test_no_log_file_without_records_or_if_disabled(log_folder: Path) -> None:
    for arguments in ([], ["--ros-args", "--disable-external-lib-logs"]):
        context = Context()
        context.init(arguments)
        if arguments:
            logging.get_logger("x").info("not kept")
        context.destroy()
    assert not log_folder.exists()


def test_unusable_log_directory_is_reported_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "file" / "log"))
    context = Context()
    context.init([])
    for _ in range(2):
        logging.get_logger("x").info("said")
    context.destroy()
    assert [line.startswith("tfloom: no log file in ") for line in lines(capsys)] == [False, True, False]


TELLS_IN_VAIN = """
import os
import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from turtlesim.action import RotateAbsolute

def fail(*_):
    raise ValueError("in vain")

rclpy.init()
node = Node("full")
node.context.on_shutdown(fail)
node.context.on_shutdown(lambda: print("every hook"))
executor = MultiThreadedExecutor()
executor.add_node(node)
node.get_logger().error("in vain")
future = rclpy.Future()
future.add_done_callback(fail)
future.add_done_callback(lambda _: print("every done callback"))
future.set_result(None)
server = ActionServer(node, RotateAbsolute, "count", fail)
client = ActionClient(node, RotateAbsolute, "count")
goal = client.send_goal_async(RotateAbsolute.Goal())
executor.spin_until_future_complete(goal, 30)
result = goal.result().get_result_async()
executor.spin_until_future_complete(result, 30)
print("status", result.result().status)
unfetched = rclpy.Future()
unfetched.set_exception(ValueError("in vain"))
del unfetched
executor.shutdown()
node.destroy_node()
rclpy.shutdown()
print("the end")
"""


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device without room")
def test_a_program_goes_on_where_stderr_takes_nothing(tmp_path: Path) -> None:
    """As where it is a file on a full disk, which holds the log files, too."""
    with Path("/dev/full").open("w") as full:
        environment = {
            **os.environ,
            "ROS_LOG_DIR": str(tmp_path / "file" / "log"),
            "RMW_IMPLEMENTATION": "tfloom_local",
        }
        (tmp_path / "file").touch()
        done = subprocess.run(
            [sys.executable, "-c", TELLS_IN_VAIN],
            env=environment,
            stdout=subprocess.PIPE,
            stderr=full,
            text=True,
            timeout=60,
            check=False,
        )
    assert done.stdout.splitlines() == ["every done callback", "status 6", "every hook", "the end"]


def test_many_threads_write_one_log_file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path))
    opened: list[object] = []

    class SlowToOpen(LogFile):
        def _open(self) -> object:
            time.sleep(0.01)  # a second thread would open another file
            opened.append(self)
            return super()._open()

    file = SlowToOpen("program")
    threads = [Thread(target=file.write, args=(f"line {number}",)) for number in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    file.close()
    file.write("too late")
    (path,) = tmp_path.iterdir()
    assert sorted(path.read_text("utf-8").splitlines()) == [f"line {number}" for number in range(8)]
    assert len(opened) == 1


def test_node_of_an_ended_context_does_not_block_logging_of_its_namesake(capsys: Capture) -> None:
    with Context() as context:
        Node("talker", context=context)
    with Context() as context:
        node = Node("talker", context=context)
        node.get_logger().info("still here")
        assert lines(capsys)[-1].endswith("[talker]: still here")
        node.destroy_node()


def test_lone_surrogates_are_logged_as_escapes(
    log_folder: Path, make_node: Callable[..., Node], capsys: Capture
) -> None:
    heard: list[str] = []
    node = make_node("talker")
    node.create_subscription(Log, "/rosout", lambda log: heard.append(log.msg), 10)
    node.get_logger().info("a file name: \udcff")
    node.get_logger().info("ü")
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        while len(heard) < 2:
            executor.spin_once(timeout_sec=10)
    assert heard == ["a file name: \\udcff", "ü"]
    (path,) = log_folder.iterdir()
    assert [line.partition("]: ")[2] for line in path.read_text("utf-8").splitlines()] == heard


def test_a_program_logs_by_the_compiled_module_s_name(capsys: Capture) -> None:
    """As handlers of Python's logging do, which know the place already."""
    logger = logging.get_logger("forwarded")
    logger.set_level(LoggingSeverity.WARN)
    for severity in (LoggingSeverity.INFO, LoggingSeverity.ERROR):
        implementation.rclpy_logging_rcutils_log(severity, "forwarded", severity.name, "work", "work.py", 7)
    assert [line.rpartition(" ")[2] for line in lines(capsys)] == ["ERROR"]
