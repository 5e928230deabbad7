"""The command `launch_test`, and the actions GTest and PyTest, by real processes."""

from __future__ import annotations

import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.launch.testing.users import FAILING, LAUNCH, PASSING

COMMAND = [sys.executable, "-m", "tfloom.launch.testing.launch_test"]


def launch_test(folder: Path, text: str, *words: str) -> subprocess.CompletedProcess[str]:
    (folder / "some.launch.test.py").write_text(LAUNCH + text)
    return run_to_end(
        [*COMMAND, "some.launch.test.py", *words],
        cwd=folder,
        env={**os.environ, "ROS_LOG_DIR": str(folder / "log")},
    )


def test_tests_run_with_arguments_and_results_are_written(tmp_path: Path) -> None:
    result = launch_test(tmp_path, PASSING["test_arguments.py"], "--junit-xml", "out.xml", "colour:=blue")
    assert result.returncode == 0, result.stdout + result.stderr
    root = ET.parse(tmp_path / "out.xml").getroot()
    (suite,) = root
    (case,) = suite
    assert (root.get("failures"), case.get("name")) == ("0", "test_values")
    assert root.get("name") == "some.some.launch.test"
    assert suite.get("name") == "some.some.launch.test.launch_tests"


def test_failed_test_is_the_exit_code(tmp_path: Path) -> None:
    result = launch_test(
        tmp_path, FAILING["test_assertion.py"][0], "--junit-xml", "out.xml", "--package-name", "mine"
    )
    assert result.returncode == 1
    assert "AssertionError: cannot add" in result.stderr
    suite = ET.parse(tmp_path / "out.xml").getroot()[0]
    assert (suite.get("tests"), suite.get("failures")) == ("3", "3")
    assert suite.get("name") == "mine.some.launch.test.launch_tests"
    assert {str(case.get("classname")).partition(".")[0] for case in suite} == {"mine"}


def test_dead_process_is_the_exit_code(tmp_path: Path) -> None:
    result = launch_test(tmp_path, FAILING["test_dead.py"][0])
    assert result.returncode == 1
    assert result.stderr.endswith("launch_test: Processes under test stopped before tests completed\n")


def test_arguments_are_shown(tmp_path: Path) -> None:
    result = launch_test(tmp_path, PASSING["test_arguments.py"], "--show-args")
    assert result.returncode == 0, result.stderr
    assert result.stdout == (
        "Arguments (pass arguments as '<name>:=<value>'):\n"
        "\n    'colour':\n        no description given\n"
        "\n    'size':\n        no description given\n        (default: '7')\n"
    )


@pytest.mark.parametrize(
    ("words", "text", "error"),
    [
        (["colour=blue"], PASSING["test_arguments.py"], "malformed launch argument 'colour=blue'"),
        ([], "", "there is no function generate_test_description in"),
        ([], FAILING["test_no_description.py"][0], "must return a LaunchDescription"),
    ],
)
def test_mistake_is_named_without_a_traceback(
    tmp_path: Path, words: list[str], text: str, error: str
) -> None:
    result = launch_test(tmp_path, text, *words)
    assert result.returncode == 2
    assert error in result.stderr
    assert "Traceback" not in result.stderr


def test_missing_file_is_named(tmp_path: Path) -> None:
    result = run_to_end([*COMMAND, tmp_path / "none.py"])
    assert result.returncode == 2
    assert f"launch test file '{tmp_path}/none.py' does not exist" in result.stderr


TESTS_AS_PROCESSES = """
from pathlib import Path

HERE = Path(__file__).parent


@launch_testing.markers.keep_alive
def generate_test_description():
    good = launch_testing.actions.PyTest(path=str(HERE / "test_inner.py"), timeout=60)
    slow = launch_testing.actions.GTest(path=str(HERE / "slow"), timeout=0.2)
    assert slow.timeout == 0.2 and good.path.endswith("test_inner.py")
    return launch.LaunchDescription([good, slow, launch_testing.actions.ReadyToTest()]), locals()


class TestThem(unittest.TestCase):
    def test_end(self, proc_info, proc_output, good, slow):
        proc_info.assertWaitForShutdown(good, timeout=60)
        proc_info.assertWaitForShutdown(slow, timeout=60)
        launch_testing.asserts.assertExitCodes(proc_info, process=good)
        launch_testing.asserts.assertInStdout(proc_output, "1 passed", good)
        assert proc_info[slow].returncode != 0
"""


def test_tests_as_processes(tmp_path: Path) -> None:
    (tmp_path / "test_inner.py").write_text("def test_one():\n    pass\n")
    (tmp_path / "slow").write_text("#!/bin/sh\nexec sleep 300\n")
    (tmp_path / "slow").chmod(0o755)
    result = launch_test(tmp_path, TESTS_AS_PROCESSES)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "ran for more than 0.2 s, and is shut down" in result.stdout + result.stderr


LEGACY = """
import launch
import sys
from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess, OpaqueFunction
from launch_testing.legacy import LaunchTestService
from launch_testing.legacy.output import create_output_lines_test

description, tests = LaunchDescription(), LaunchTestService()
wait = "import time\\ntry:\\n    time.sleep(300)\\nexcept KeyboardInterrupt: pass"
tests.add_fixture_action(description, ExecuteProcess(cmd=[sys.executable, "-c", wait]))
speak = ExecuteProcess(cmd=[sys.executable, "-c", "print('hello'); print('world')"])
tests.add_test_action(description, speak)
tests.add_output_test(description, speak, create_output_lines_test([sys.argv[1]]))
tests.add_test_action(description, ExecuteProcess(cmd=[sys.executable, "-c", f"raise SystemExit({sys.argv[2]})"]))
service = LaunchService()
service.include_launch_description(description)
raise SystemExit(tests.run(service))
"""


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (("world", "0"), 0, ""),
        (("moon", "0"), 1, "lines are missing in the output: ['moon']"),
        (("world", "4"), 1, "exited with 4"),
    ],
)
def test_older_service(tmp_path: Path, words: tuple[str, str], code: int, text: str) -> None:
    result = run_to_end(
        [sys.executable, "-c", LEGACY, *words],
        cwd=tmp_path,
        env={**os.environ, "ROS_LOG_DIR": str(tmp_path)},
    )
    assert result.returncode == code, result.stdout + result.stderr
    assert text in result.stdout
