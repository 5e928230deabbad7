"""The command `launch_test`, the actions GTest and PyTest, and the older service."""

from __future__ import annotations

import sys
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from launch_testing.legacy import LaunchTestService
from launch_testing.legacy.output import create_output_lines_test
from tests.conftest import PYTEST, run_to_end
from tests.launch.testing.users import FAILING, LAUNCH, PASSING

from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.launch_service import LaunchService
from tfloom.launch.testing.launch_test import main


class Result(NamedTuple):
    """What a run of the command came to."""

    code: int
    stdout: str
    stderr: str


LaunchTest = Callable[..., Result]


@pytest.fixture
def launch_test(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Iterator[LaunchTest]:
    """Return a function that runs the command on the text of a file, in this process."""
    monkeypatch.chdir(tmp_path)

    def launch_test(text: str, *words: str) -> Result:
        Path("some.launch.test.py").write_text(LAUNCH + text)
        try:
            code = main(["some.launch.test.py", *words])
        except SystemExit as end:
            code = int(end.code or 0)
        return Result(code, *capsys.readouterr())

    yield launch_test
    sys.modules.pop("some_launch_test", None)


def test_tests_run_with_arguments_and_results_are_written(tmp_path: Path) -> None:
    """As a command."""
    (tmp_path / "some.launch.test.py").write_text(LAUNCH + PASSING["test_arguments.py"])
    command = [sys.executable, "-m", "tfloom.launch.testing.launch_test", "some.launch.test.py"]
    result = run_to_end([*command, "--junit-xml", "out.xml", "colour:=blue"], cwd=tmp_path)
    assert result.returncode == 0, result.stdout + result.stderr
    root = ET.parse(tmp_path / "out.xml").getroot()
    (suite,) = root
    (case,) = suite
    assert (root.get("failures"), case.get("name")) == ("0", "test_values")
    assert root.get("name") == "some.some.launch.test"
    assert suite.get("name") == "some.some.launch.test.launch_tests"


def test_failed_test_is_the_exit_code(launch_test: LaunchTest) -> None:
    text = FAILING["test_assertion.py"][0]
    result = launch_test(text, "--junit-xml", "out.xml", "--package-name", "mine")
    assert result.code == 1
    assert "AssertionError: cannot add" in result.stderr
    suite = ET.parse("out.xml").getroot()[0]
    assert (suite.get("tests"), suite.get("failures")) == ("3", "3")
    assert suite.get("name") == "mine.some.launch.test.launch_tests"
    assert {str(case.get("classname")).partition(".")[0] for case in suite} == {"mine"}


def test_dead_process_is_the_exit_code(launch_test: LaunchTest) -> None:
    result = launch_test(FAILING["test_dead.py"][0])
    assert result.code == 1
    assert result.stderr.endswith("launch_test: Processes under test stopped before tests completed\n")


def test_arguments_are_shown(launch_test: LaunchTest) -> None:
    result = launch_test(PASSING["test_arguments.py"], "--show-args")
    assert result.code == 0, result.stderr
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
    launch_test: LaunchTest, words: list[str], text: str, error: str
) -> None:
    result = launch_test(text, *words)
    assert result.code == 2
    assert error in result.stderr
    assert "Traceback" not in result.stderr


def test_missing_file_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="2"):
        main([str(tmp_path / "none.py")])
    assert f"launch test file '{tmp_path}/none.py' does not exist" in capsys.readouterr().err


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


def test_tests_as_processes(launch_test: LaunchTest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTEST_ADDOPTS", " ".join(PYTEST[2:]))
    (tmp_path / "test_inner.py").write_text("def test_one():\n    pass\n")
    (tmp_path / "slow").write_text("#!/bin/sh\nexec sleep 300\n")
    (tmp_path / "slow").chmod(0o755)
    result = launch_test(TESTS_AS_PROCESSES)
    assert result.code == 0, result.stdout + result.stderr
    assert "ran for more than 0.2 s, and is shut down" in result.stdout + result.stderr


def python(code: str) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", code])


@pytest.mark.parametrize(
    ("line", "exit_code", "code", "text"),
    [
        ("world", 0, 0, ""),
        ("moon", 0, 1, "lines are missing in the output: ['moon']"),
        ("world", 4, 1, "exited with 4"),
    ],
)
def test_older_service(
    line: str, exit_code: int, code: int, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    description, tests = LaunchDescription(), LaunchTestService()
    wait = "import time\ntry:\n    time.sleep(300)\nexcept KeyboardInterrupt: pass"
    tests.add_fixture_action(description, python(wait))
    speak = python("print('hello'); print('world')")
    tests.add_test_action(description, speak)
    tests.add_output_test(description, speak, create_output_lines_test([line]))
    tests.add_test_action(description, python(f"raise SystemExit({exit_code})"))
    service = LaunchService()
    service.include_launch_description(description)
    assert tests.run(service) == code
    assert text in capsys.readouterr().out
