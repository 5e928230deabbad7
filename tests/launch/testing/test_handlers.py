"""Recorded events of processes, and the assertions on them, with events made here."""

from __future__ import annotations

import re
import signal
import threading
import time

import pytest

from tfloom.launch.actions.executable import Executable
from tfloom.launch.actions.execute_local import ExecuteLocal
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.events.process import ProcessExited, ProcessStarted, ProcessStderr, ProcessStdout
from tfloom.launch.substitutions.variables import LocalSubstitution
from tfloom.launch.testing.assert_exit_codes import EXIT_SIGINT, assertExitCodes
from tfloom.launch.testing.assert_output import (
    assertDefaultStream,
    assertInStderr,
    assertInStdout,
    assertInStream,
)
from tfloom.launch.testing.assert_sequential_output import SequentialTextChecker, assertSequentialStdout
from tfloom.launch.testing.io_handler import ActiveIoHandler, IoHandler
from tfloom.launch.testing.output import basic_output_filter
from tfloom.launch.testing.proc_info_handler import ActiveProcInfoHandler, ProcInfoHandler
from tfloom.launch.testing.proc_lookup import NO_CMD_ARGS, NoMatchingProcessException, resolveProcesses
from tfloom.launch.testing.process import ProcessProxy


class Process:
    """A process that never runs: its action, and its events."""

    def __init__(self, name: str, *words: str) -> None:
        self.action = ExecuteProcess(cmd=["program", *words])
        self.details = {
            "action": self.action,
            "name": name,
            "cmd": ["program", *words],
            "cwd": None,
            "env": None,
            "pid": 7,
        }
        self.action._details = self.details

    def started(self) -> ProcessStarted:
        return ProcessStarted(**self.details)

    def exited(self, code: int) -> ProcessExited:
        return ProcessExited(returncode=code, **self.details)

    def stdout(self, text: str) -> ProcessStdout:
        return ProcessStdout(text=text.encode(), **self.details)

    def stderr(self, text: str) -> ProcessStderr:
        return ProcessStderr(text=text.encode(), **self.details)


@pytest.fixture
def one() -> Process:
    return Process("talker-1")


@pytest.fixture
def two() -> Process:
    return Process("talker-2", "--fast", "red")


@pytest.fixture
def output(one: Process, two: Process) -> IoHandler:
    handler = IoHandler()
    handler.track("talker-1")
    for event in (
        one.stdout("first\nsec"),
        two.stdout("of two\n"),
        one.stdout("ond\nthird\n"),
        one.stderr("\x1b[33mwarn\x1b[0ming\n"),
    ):
        handler.append(event)
    return handler


def test_output_is_kept_by_process(output: IoHandler, one: Process, two: Process) -> None:
    assert len(list(output)) == 4
    assert output.processes() == [one.action, two.action]
    assert output.process_names() == ["talker-1", "talker-2"]
    assert [event.text for event in output["talker-2"]] == [b"of two\n"]
    assert output[two.action] == output["talker-2"]
    with pytest.raises(KeyError):
        output["talker-3"]


def test_processes_are_found_by_name_and_arguments(output: IoHandler, one: Process, two: Process) -> None:
    assert resolveProcesses(output) == resolveProcesses(output, process="") == [one.action, two.action]
    assert resolveProcesses(output, process=two.action) == [two.action]
    assert resolveProcesses(output, process="er-2") == [two.action]
    assert resolveProcesses(output, process="talker", cmd_args="--fast") == [two.action]
    assert resolveProcesses(output, process="talker", cmd_args=["red", "--fast"]) == [two.action]
    assert resolveProcesses(output, process="talker", cmd_args=NO_CMD_ARGS) == [one.action]
    assert resolveProcesses(output, process="talker", strict_proc_matching=False) == [one.action, two.action]


@pytest.mark.parametrize(
    ("words", "text"),
    [
        ({"process": "listener"}, "any process with 'listener' in its name; recorded are: talker-1, talker-2"),
        ({"process": "talker", "cmd_args": "blue"}, "Did not find any process with 'talker' in its name and arguments"),
        ({"process": "talker"}, "Found multiple processes with 'talker' in their names: talker-1, talker-2"),
    ],
)  # fmt: skip
def test_wrong_name_is_an_error(output: IoHandler, words: dict[str, str], text: str) -> None:
    with pytest.raises(Exception, match=re.escape(text)):
        resolveProcesses(output, **words)


def test_process_that_never_started_is_described() -> None:
    with pytest.raises(NoMatchingProcessException, match="python -c"):
        resolveProcesses(ProcInfoHandler(), process=ExecuteProcess(cmd=["python", "-c", ""]))
    unknown = ExecuteProcess(cmd=[LocalSubstitution("word"), "-c"])
    with pytest.raises(NoMatchingProcessException, match="Unknown"):
        resolveProcesses(ProcInfoHandler(), process=unknown)
    with pytest.raises(NoMatchingProcessException, match="No processes were recorded"):
        resolveProcesses(ProcInfoHandler())
    with pytest.raises(TypeError, match="ExecuteLocal action or a text"):
        resolveProcesses(ProcInfoHandler(), process=7)  # type: ignore[arg-type]


def test_expected_output_is_found(output: IoHandler, one: Process) -> None:
    assertInStdout(output, "second", one.action)
    assertInStdout(output, "of two", None)
    assertInStdout(output, re.compile(r"^sec.nd$", re.MULTILINE), "talker-1")
    assertInStdout(output, ["first", re.compile("th.rd")], "talker-1")
    assertInStderr(output, "warning", "talker-1")
    assert assertDefaultStream() == "stderr"
    assertInStream(output, "warning", "talker-1")
    assertInStdout(output, "third", "talker-1", output_filter=basic_output_filter(["first"]))


@pytest.mark.parametrize(
    ("words", "text"),
    [
        ({"expected_output": "fourth"}, "Did not find 'fourth' in stderr of any of the matching processes: talker-1"),
        ({"expected_output": "first"}, "talker-1; it is in their stdout"),
        ({"expected_output": "warning", "strip_ansi_escape_sequences": False}, "Did not find 'warning'"),
        ({"expected_output": ["third", "first"], "stream": "stdout"}, "Did not find"),
        ({"expected_output": "x", "stream": "stdout", "output_filter": lambda _: "y"}, "Did not find 'x' in stdout"),
    ],
)  # fmt: skip
def test_output_that_is_not_there_fails(output: IoHandler, words: dict[str, object], text: str) -> None:
    with pytest.raises(AssertionError, match=re.escape(text)):
        assertInStream(output, process="talker-1", **words)


def test_unknown_stream_is_an_error(output: IoHandler) -> None:
    with pytest.raises(ValueError, match="'stdout' or 'stderr', and is 'stdlog'"):
        assertInStream(output, "first", None, stream="stdlog")


def test_order_is_checked(output: IoHandler) -> None:
    with assertSequentialStdout(output, "talker-1") as checker:
        checker.assertInStdout("first")
        checker.assertInStdout("second")
        with pytest.raises(AssertionError, match="'first' not found in sequence after previous match"):
            checker.assertInStdout("first")
        checker.assertInText("third")
    assert checker.get_nearby_lines() == "first\nsecond\nthird"
    checker = SequentialTextChecker([f"line {number}\n" for number in range(20)])
    checker.assertInStdout("line 5")
    assert checker.get_nearby_lines() == "\n".join(f"line {number}" for number in range(3, 9))
    checker.assertInStdout("li")
    assert checker.get_nearby_lines() == "\n".join(f"line {number}" for number in range(4, 9))
    with pytest.raises(Exception, match="multiple processes"), assertSequentialStdout(output, None):
        pass


def test_a_text_over_several_lines_is_found() -> None:
    checker = SequentialTextChecker(["output 10\n", "output 15\n"])
    checker.assertInStdout("output 10\noutput")
    checker.assertInStdout("15\n")


def test_a_process_is_found_by_any_action_that_runs_it() -> None:
    action = ExecuteLocal(process_description=Executable(cmd=["talker"]))
    with pytest.raises(NoMatchingProcessException, match="'talker', which was not started"):
        resolveProcesses(ProcInfoHandler(), process=action)


def test_order_within_a_line() -> None:
    checker = SequentialTextChecker(["one two one\n"])
    checker.assertInStdout("two")
    checker.assertInStdout("one")
    with pytest.raises(AssertionError):
        checker.assertInStdout("one")


def test_exit_codes(one: Process, two: Process) -> None:
    info = ProcInfoHandler()
    info.append(one.started())
    with pytest.raises(AssertionError, match="Proc talker-1 has not exited"):
        assertExitCodes(info)
    info.append(one.exited(0))
    assertExitCodes(info)
    info.append(two.exited(-signal.SIGINT))
    text = re.escape("Proc talker-2 exited with code -2 (SIGINT), and not with one of: 0, 130")
    with pytest.raises(AssertionError, match=text):
        assertExitCodes(info, [0, EXIT_SIGINT])
    assertExitCodes(info, [-2], process="talker-2")
    assert info.process_names() == ["talker-1", "talker-2"]
    assert info["talker-1"] is info[one.action]
    assert [event.returncode for event in info] == [0, -2]
    with pytest.raises(KeyError):
        info["talker-3"]


def test_wait_for_output_of_another_thread(one: Process) -> None:
    output = ActiveIoHandler()
    timer = threading.Timer(0.05, lambda: output.append(one.stdout("late\n")))
    timer.start()
    output.assertWaitFor("late", process="talker", stream="stdout", timeout=30)
    timer.join()
    assert output.waitFor("late", stream="stdout", timeout=0)
    assert not output.waitFor("later", stream="stdout", timeout=0.01)
    with pytest.raises(
        AssertionError, match=r"Waiting for output timed out after 0.01 s: Did not find 'later'"
    ):
        output.assertWaitFor("later", timeout=0.01)


def test_waits_end_with_the_launch(one: Process) -> None:
    output, info = ActiveIoHandler(), ActiveProcInfoHandler()
    info.append(one.started())
    threads = [threading.Timer(0.05, record.close) for record in (output, info)]
    begin = time.monotonic()
    for thread in threads:
        thread.start()
    with pytest.raises(AssertionError, match="Waiting for output the launch ended"):
        output.assertWaitFor("never", timeout=60)
    with pytest.raises(AssertionError, match="The launch ended, waiting for process to exit"):
        info.assertWaitForShutdown(one.action, timeout=60)
    assert time.monotonic() - begin < 50
    for thread in threads:
        thread.join()


def test_wait_for_start_and_end(one: Process) -> None:
    info = ActiveProcInfoHandler()
    with pytest.raises(AssertionError, match="Timed out waiting for process to start"):
        info.assertWaitForStartup("talker", timeout=0.01)
    info.append(one.started())
    info.assertWaitForStartup("talker", timeout=0.01)
    with pytest.raises(AssertionError, match=r"Timed out waiting for process to exit .*: talker-1 runs"):
        info.assertWaitForShutdown("talker", timeout=0.01)
    info.append(one.exited(0))
    info.assertWaitForShutdown("talker", timeout=0.01)
    info.assertWaitForStartup("talker", timeout=0.01)


def test_proxy_shows_one_process(one: Process, two: Process) -> None:
    info, output = ActiveProcInfoHandler(), ActiveIoHandler()
    proxy = ProcessProxy(one.action, info, output, output_filter=basic_output_filter(["rc"]))
    assert not proxy.running
    assert not proxy.terminated
    assert proxy.output == ""
    info.append(one.started())
    output.append(two.stdout("of two\n"))
    output.append(one.stdout("rc 0\nhello\n"))
    output.append(one.stderr("world\n"))
    assert (proxy.running, proxy.terminated) == (True, False)
    assert (proxy.output, proxy.stdout, proxy.stderr) == ("hello\nworld\n", "hello\n", "world\n")
    assert proxy.wait_for_output(timeout=0)
    assert not proxy.wait_for_output(lambda text: "bye" in text, timeout=0.01)
    assert not proxy.wait_for_shutdown(timeout=0.01)
    with pytest.raises(RuntimeError, match="has not exited"):
        _ = proxy.exit_code
    info.append(one.exited(3))
    assert proxy.wait_for_shutdown(timeout=0)
    assert (proxy.running, proxy.terminated, proxy.exit_code) == (False, True, 3)
    assert proxy.target_process_action is one.action
