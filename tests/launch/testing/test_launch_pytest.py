"""launch_pytest as packages of users use it, under plain pytest."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import pytest
from tests.conftest import PYTEST, wait_until
from tests.launch.testing.conftest import Run, run_pytest
from tests.launch.testing.users import LAUNCH

HEAD = '''\
import sys

import launch
import launch_pytest
import pytest
from launch.actions import ExecuteProcess
from launch_pytest import tools
from launch_pytest.actions import ReadyToTest


class Counts:
    launches = 0
    seen = []

PROGRAM = """
import sys, time
try:
    print("world", file=sys.stderr, flush=True)
    print("hello", flush=True)
    time.sleep(300)
except KeyboardInterrupt:
    print("bye", flush=True)
"""


@pytest.fixture
def process():
    return ExecuteProcess(cmd=[sys.executable, "-c", PROGRAM], cached_output=True)


@launch_pytest.fixture
def description(process):
    Counts.launches += 1
    return launch.LaunchDescription([process, ReadyToTest()])


@pytest.mark.launch(fixture=description)
def wait_for_hello(process, launch_context):
    tools.assert_output_sync(launch_context, process, lambda text: "hello\\n" in text, timeout=60)

'''

FUNCTIONS = """
@pytest.mark.launch(fixture=description)
def test_function(process, launch_context, launch_service):
    assert launch_service.context is launch_context
    assert tools.wait_for_start_sync(launch_context, process, timeout=60)

    def check(text):
        assert text == "hello\\n"

    assert tools.wait_for_output_sync(launch_context, process, check, timeout=60)
    tools.assert_stderr_sync(launch_context, process, lambda text: text == "world\\n", timeout=60)
    assert tools.wait_for_stderr_sync(launch_context, process, lambda text: None, timeout=60)
    assert not tools.wait_for_exit_sync(launch_context, process, timeout=0.1)
    assert not tools.wait_for_output_sync(launch_context, process, lambda text: False, timeout=0.1)


@pytest.mark.launch(fixture=description)
async def test_coroutine(process, launch_context, event_loop):
    import asyncio

    assert asyncio.get_running_loop() is event_loop is launch_context.asyncio_loop
    assert await tools.wait_for_start(launch_context, process, timeout=60)
    await tools.assert_output(launch_context, process, lambda text: text == "hello\\n", timeout=60)
    assert await tools.wait_for_output(launch_context, process, lambda text: text == "hello\\n", timeout=60)
    await tools.assert_stderr(launch_context, process, lambda text: text == "world\\n", timeout=60)
    assert await tools.wait_for_stderr(launch_context, process, lambda text: None, timeout=60)
    assert not await tools.wait_for_exit(launch_context, process, timeout=0.1)
    with pytest.raises(RuntimeError, match="await the function of the same name"):
        tools.wait_for_exit_sync(launch_context, process)


@pytest.mark.launch(fixture=description)
def test_generator(process, launch_context):
    wait_for_hello(process, launch_context)
    assert process.return_code is None
    yield
    assert process.return_code == 0
    assert process.get_stdout() == "hello\\nbye\\n"


@pytest.mark.launch(fixture=description)
async def test_asynchronous_generator(process, launch_context):
    await tools.assert_output(launch_context, process, lambda text: "hello\\n" in text, timeout=60)
    yield
    assert process.return_code == 0


@pytest.mark.launch(fixture=description, shutdown=True)
def test_shutdown(process):
    assert process.return_code is not None


@pytest.mark.launch(fixture=description, shutdown=True)
async def test_shutdown_coroutine(process):
    assert process.return_code is not None


@pytest.mark.launch(fixture=description)
@pytest.mark.parametrize("number", [1, 2])
def test_parametrized(number, description):
    Counts.seen.append(number)
    assert isinstance(description, launch.LaunchDescription)


class TestCase:
    @pytest.mark.launch(fixture=description)
    def test_method(self, process, launch_context):
        wait_for_hello(process, launch_context)

    @pytest.mark.launch(fixture=description)
    def test_generating_method(self, process, launch_context):
        wait_for_hello(process, launch_context)
        yield
        assert process.return_code == 0


@pytest.mark.xfail(strict=True)
@pytest.mark.launch(fixture=description)
def test_expected_failure():
    assert False


@pytest.mark.skip(reason="no robot")
@pytest.mark.launch(fixture=description)
def test_skipped():
    assert False


def test_each_test_had_a_launch():
    assert Counts.launches == 11
    assert Counts.seen == [1, 2]
"""

MODULE_SCOPE = """
ORDER = []


@pytest.fixture(scope="module")
def process():
    return ExecuteProcess(cmd=[sys.executable, "-c", PROGRAM], cached_output=True)


@launch_pytest.fixture(scope="module")
def shared(process):
    Counts.launches += 1
    yield launch.LaunchDescription([process]), "more"
    ORDER.append("fixture")


@pytest.mark.launch(fixture=shared, shutdown=True)
def test_end(process):
    ORDER.append("end")
    assert process.return_code == 0


@pytest.mark.launch(fixture=shared)
def test_generator(process, launch_context):
    ORDER.append("generator")
    wait_for_hello(process, launch_context)
    yield
    ORDER.append("second half")
    assert process.return_code == 0


@pytest.mark.launch(fixture=shared)
async def test_asynchronous_generator(process):
    ORDER.append("asynchronous generator")
    yield
    ORDER.append("its second half")


@pytest.mark.launch(fixture=shared)
def test_function(process, shared):
    ORDER.append("function")
    assert shared[1] == "more"
    assert process.return_code is None


@pytest.mark.launch(fixture=shared)
def test_fails():
    assert False, "before the end"
    yield


def test_order():
    assert ORDER[:4] == ["generator", "asynchronous generator", "function", "end"]
    assert ORDER[4:] == ["second half", "its second half"]
    assert Counts.launches == 1
"""

CLASS_SCOPE = """
class Base:
    number = 0


@launch_pytest.fixture(scope="class")
def shared():
    Counts.launches += 1
    return launch.LaunchDescription([ReadyToTest()])


@pytest.mark.launch(fixture=shared)
class TestOne:
    def test_first(self):
        assert Counts.launches == 1

    def test_second(self):
        assert Counts.launches == 1


@pytest.mark.launch(fixture=shared)
class TestTwo:
    def test_third(self):
        assert Counts.launches == 2
"""

BY_ITSELF = """
@pytest.fixture
def short():
    return ExecuteProcess(cmd=[sys.executable, "-c", "print('over')"], cached_output=True)


@launch_pytest.fixture(auto_shutdown=False)
def ends_by_itself(short):
    return launch.LaunchDescription([short])


@pytest.mark.launch(fixture=ends_by_itself, shutdown=True)
def test_end(short):
    assert short.return_code == 0
    assert short.get_stdout() == "over\\n"
"""

IMPORTED = """
from descriptions import empty


@pytest.mark.launch(fixture=empty)
def test_imported(launch_service):
    pass
"""

DESCRIPTIONS = """
import launch
import launch_pytest


@launch_pytest.fixture
def empty():
    return launch.LaunchDescription([])
"""

PASSING = {
    "test_functions.py": FUNCTIONS,
    "test_class_scope.py": CLASS_SCOPE,
    "test_by_itself.py": BY_ITSELF,
    "test_imported.py": IMPORTED,
}

FAULTY = """
@launch_pytest.fixture
def no_description():
    return object()


@pytest.mark.launch(fixture=no_description)
def test_no_description():
    pass


@launch_pytest.fixture
def wrong_sequence():
    return [object, "more"]


@pytest.mark.launch(fixture=wrong_sequence)
def test_wrong_sequence():
    pass


@launch_pytest.fixture
def two_ready():
    return launch.LaunchDescription([ReadyToTest(), ReadyToTest()])


@pytest.mark.launch(fixture=two_ready)
def test_two_ready():
    pass


@launch_pytest.fixture
def failing():
    def fail(context):
        raise ValueError("of an action")

    return launch.LaunchDescription([launch.actions.OpaqueFunction(function=fail), ReadyToTest()])


@pytest.mark.launch(fixture=failing)
def test_failing_launch():
    pass


@pytest.mark.launch(fixture=description)
def test_assertion(process, launch_context):
    words = ["one"]
    assert words == ["two"]


@pytest.mark.launch(fixture=description)
def test_output(process, launch_context):
    tools.assert_output_sync(launch_context, process, lambda text: "never" in text, timeout=0.2)


@pytest.mark.launch(fixture=description)
def test_yields_twice():
    yield
    yield


@pytest.mark.launch(fixture=description)
async def test_asynchronously_yields_twice():
    yield
    yield


@pytest.mark.launch(fixture=description, shutdown=True)
def test_generator_after_shutdown():
    yield


@pytest.mark.launch(fixture=description)
def test_second_half():
    yield
    assert "second" == "half"


@pytest.mark.launch
def test_no_fixture():
    assert False
"""

FAULTS = {
    "test_no_description": ("error", "must be either a launch description or"),
    "test_wrong_sequence": ("error", "must be either a launch description or"),
    "test_two_ready": ("error", "only one ReadyToTest action"),
    "test_failing_launch": (
        "error",
        "the launch ended before the ReadyToTest action of its description: ",
    ),
    "test_assertion": ("failure", "At index 0 diff: 'one' != 'two'"),
    "test_output": ("failure", "the output will not do: "),
    "test_yields_twice": ("failure", "must stop iteration after yielding once"),
    "test_asynchronously_yields_twice": ("failure", "must stop iteration after yielding once"),
    "test_generator_after_shutdown": (
        "failure",
        "async generator based launch tests can't have shutdown=True",
    ),
    "test_second_half": ("failure", "assert 'second' == 'half'"),
    "test_no_fixture": ("skipped", '"fixture" keyword argument is required'),
}


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    files = {**PASSING, "test_module_scope.py": MODULE_SCOPE, "test_faulty.py": FAULTY}
    texts = {name: HEAD + text for name, text in files.items()}
    return run_pytest(tmp_path_factory.mktemp("users"), {**texts, "descriptions.py": DESCRIPTIONS})


@pytest.mark.parametrize("name", sorted(PASSING))
def test_each_test_passes(run: Run, name: str) -> None:
    cases = {key: case for key, case in run.cases.items() if key.startswith(name.removesuffix(".py"))}
    assert len(cases) >= HEAD.count("def test_") + PASSING[name].count("def test_")
    skipped = {"test_functions::test_skipped", "test_functions::test_expected_failure"}
    for key, case in cases.items():
        assert case.outcome == ("skipped" if key in skipped else "passed"), case.text


def test_tests_after_a_shared_launch_are_last(run: Run) -> None:
    outcomes = {key.partition("::")[2]: case for key, case in run.cases.items() if "test_module_scope" in key}
    assert list(outcomes) == [
        "test_generator",
        "test_asynchronous_generator",
        "test_function",
        "test_fails",
        "test_end",
        "test_generator[shutdown_test]",
        "test_asynchronous_generator[shutdown_test]",
        "test_fails[shutdown_test]",
        "test_order",
    ]
    failed = {"test_fails": "failure", "test_fails[shutdown_test]": "skipped"}
    for name, case in outcomes.items():
        assert case.outcome == failed.get(name, "passed"), case.text
    assert "before the end" in outcomes["test_fails"].text


@pytest.mark.parametrize("name", sorted(FAULTS))
def test_fault_is_reported(run: Run, name: str) -> None:
    case = run.cases[f"test_faulty::{name}"]
    assert case.outcome == FAULTS[name][0], case.text
    assert FAULTS[name][1] in case.text


def test_missing_fixture_is_warned_of(run: Run) -> None:
    assert (
        'test_no_fixture: "fixture" keyword argument is required in a pytest.mark.launch() decorator'
        in run.output
    )


INTERRUPTED = """
@pytest.mark.launch(fixture=description)
def test_interrupted(process, launch_context):
    wait_for_hello(process, launch_context)
    open("pid", "w").write(str(process.process_details["pid"]))
    tools.wait_for_exit_sync(launch_context, process, timeout=60)


def test_never():
    open("never", "w")
"""


INTERRUPTED_LAUNCH_TEST = """

def generate_test_description():
    return launch.LaunchDescription([counter(), launch_testing.actions.ReadyToTest()])


class TestIt(unittest.TestCase):
    def test_it(self, proc_info, proc_output):
        proc_output.assertWaitFor("Loop", timeout=60, stream="stdout")
        open("pid", "w").write(str(next(iter(proc_info)).pid))
        proc_info.assertWaitForShutdown("counter", timeout=60)
        proc_output.assertWaitFor("never", timeout=60)
"""
NEVER = "def test_never():\n    open('never', 'w')\n"


@pytest.mark.parametrize(
    "text", [HEAD + INTERRUPTED, LAUNCH + INTERRUPTED_LAUNCH_TEST], ids=["launch_pytest", "launch_testing"]
)
def test_interrupt_ends_pytest_and_the_processes(text: str, tmp_path: Path) -> None:
    (tmp_path / "test_interrupted.py").write_text(text)
    (tmp_path / "test_never.py").write_text(NEVER)
    program = subprocess.Popen(
        [sys.executable, *PYTEST, "-p", "no:cacheprovider"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        wait_until(lambda: (tmp_path / "pid").is_file() and (tmp_path / "pid").read_text())
        program.send_signal(signal.SIGINT)
        output, _ = program.communicate(timeout=60)
    finally:
        program.kill()
        program.wait()
    assert program.returncode == pytest.ExitCode.INTERRUPTED, output
    assert "KeyboardInterrupt" in output
    assert not (tmp_path / "never").exists()
    assert not Path("/proc", (tmp_path / "pid").read_text()).exists()
