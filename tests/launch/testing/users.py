"""Test files as packages of users have them, by name; `tests/launch/testing/test_plugin.py` runs them under pytest."""

from __future__ import annotations

COUNTER = """\
import sys, time
print("Starting Up", flush=True)
print("args", *sys.argv[1:], flush=True)
try:
    for number in range(100000):
        print("Loop", number, flush=True)
        print("log", number, file=sys.stderr, flush=True)
        time.sleep(0.02)
except KeyboardInterrupt:
    print("Shutting Down", flush=True)
"""

LAUNCH = f"""\
import functools
import sys
import time
import unittest

import launch
import launch.actions
import launch_testing
import launch_testing.actions
import launch_testing.asserts
import launch_testing.markers
import launch_testing.util
import pytest

COUNTER = {COUNTER!r}


def counter(*words, **options):
    return launch.actions.ExecuteProcess(cmd=[sys.executable, "-c", COUNTER, *words], name="counter", **options)


def python(code, **options):
    return launch.actions.ExecuteProcess(cmd=[sys.executable, "-c", code], **options)

"""

PASSING = {
    "test_good.py": """
@pytest.mark.launch_test
def generate_test_description():
    process = counter("one", "two", output="screen")
    return launch.LaunchDescription([process, launch_testing.actions.ReadyToTest()]), {"process": process}


class TestDuringLaunch(unittest.TestCase):
    @classmethod
    def setUpClass(cls, proc_output):
        cls.seen = proc_output

    def setUp(self, process):
        self.process = process

    def test_output(self, proc_output, proc_info, process, launch_service):
        proc_output.assertWaitFor("Loop 3", process=process, timeout=30, stream="stdout")
        proc_output.assertWaitFor(expected_output="log 2", process=process, timeout=30)
        assert proc_output.waitFor("args one two", timeout=30, stream="stdout")
        assert self.seen is proc_output is self.proc_output
        assert self.process is process
        assert any(name.startswith("counter-") for name in proc_output.process_names())
        launch_testing.asserts.assertInStdout(proc_output, "one two", "counter", cmd_args="two")
        with self.assertRaisesRegex(AssertionError, "process to exit"):
            proc_info.assertWaitForShutdown(process, timeout=0.1)

    def test_other_process(self, proc_info, proc_output, launch_service):
        from launch_testing.tools import launch_process

        ls = launch.actions.ExecuteProcess(cmd=[sys.executable, "-c", "print('listed')"], name="ls")
        with launch_process(launch_service, ls, proc_info, proc_output) as proxy:
            expected = functools.partial(launch_testing.tools.expect_output, expected_lines=["listed"], strict=True)
            assert proxy.wait_for_output(expected, timeout=30)
            assert proxy.wait_for_shutdown(timeout=30)
        assert proxy.exit_code == 0 and proxy.stdout == "listed\\n"

    @unittest.skip("of no use")
    def test_skipped(self):
        assert False


@launch_testing.post_shutdown_test()
class TestAfterLaunch(unittest.TestCase):
    def test_exit_code(self, proc_info):
        launch_testing.asserts.assertExitCodes(proc_info)

    def test_order(self, proc_output, process):
        with launch_testing.asserts.assertSequentialStdout(proc_output, process) as checker:
            checker.assertInStdout("Loop 1")
            checker.assertInStdout("Loop 2")
            checker.assertInStdout("Shutting Down")
            with self.assertRaisesRegex(AssertionError, "'Loop 1' not found"):
                checker.assertInStdout("Loop 1")
""",
    "test_parametrized.py": """
@pytest.mark.launch_test
@launch_testing.parametrize("word", ["red", "green"])
def generate_test_description(word):
    return launch.LaunchDescription([counter(word), launch_testing.actions.ReadyToTest()])


class TestWord(unittest.TestCase):
    def test_word(self, word, proc_output):
        proc_output.assertWaitFor("args " + word, timeout=30, stream="stdout")
""",
    "test_arguments.py": """
def generate_test_description():
    return launch.LaunchDescription([
        launch.actions.DeclareLaunchArgument("colour"),
        launch.actions.DeclareLaunchArgument("size", default_value="7"),
        counter(launch.substitutions.LaunchConfiguration("colour")),
        launch_testing.actions.ReadyToTest(),
    ])


class TestArguments(unittest.TestCase):
    def test_values(self, test_args, proc_output):
        assert test_args["colour"] == "blue"
        assert self.test_args["size"] == "7"
        proc_output.assertWaitFor("args blue", timeout=30, stream="stdout")
""",
    "test_kept_alive.py": """
@launch_testing.markers.keep_alive
def generate_test_description():
    return launch.LaunchDescription([
        python("print('short')", name="short"),
        launch_testing.actions.ReadyToTest(),
    ])


class TestShort(unittest.TestCase):
    tries = 0

    def test_end(self, proc_info, proc_output):
        proc_info.assertWaitForStartup("short", timeout=30)
        proc_info.assertWaitForShutdown("short", timeout=30)
        assert [name.split("-")[0] for name in proc_info.process_names()] == ["short"]
        launch_testing.asserts.assertExitCodes(proc_info, process="short")
        launch_testing.asserts.assertInStdout(proc_output, "short", "short")

    @launch_testing.markers.retry_on_failure(times=3)
    def test_third_time(self):
        TestShort.tries += 1
        assert TestShort.tries == 3
""",
    "test_ready_when_printed.py": """
from launch_testing.event_handlers import StdoutReadyListener


@launch_testing.ready_to_test_action_timeout(60)
def generate_test_description():
    process = counter()
    ready = launch_testing.actions.ReadyToTest()
    listener = StdoutReadyListener(target_action=process, ready_txt="Loop 5", actions=[ready])
    return launch.LaunchDescription([process, launch.actions.RegisterEventHandler(listener)])


class TestReady(unittest.TestCase):
    def test_is_ready(self, proc_output):
        launch_testing.asserts.assertInStdout(proc_output, "Loop 5", None)
""",
    "test_ready_fn.py": """
def generate_test_description(ready_fn):
    return launch.LaunchDescription([counter(), launch.actions.OpaqueFunction(function=lambda context: ready_fn())])


class TestOld(unittest.TestCase):
    def test_output(self, proc_output):
        proc_output.assertWaitFor("Loop", timeout=30, stream="stdout")
""",
    "test_skipped_launch.py": """
@unittest.skip("no robot here")
def generate_test_description():
    raise RuntimeError


class TestNever(unittest.TestCase):
    def test_never(self):
        assert False
""",
    "test_plain.py": """
from launch_testing import parametrize  # and no generate_test_description() in it


class TestPlain(unittest.TestCase):
    def test_plain(self):
        assert 1 + 1 == 2
""",
}

FAILING = {
    "test_assertion.py": (
        """
def generate_test_description():
    return launch.LaunchDescription([counter(), launch_testing.actions.ReadyToTest()])


class TestWrong(unittest.TestCase):
    def test_sum(self):
        numbers = [1, 2]
        assert sum(numbers) == 4, "cannot add"

    def test_output(self, proc_output):
        proc_output.assertWaitFor("Goodbye", process="counter", timeout=0.5, stream="stdout")


@launch_testing.post_shutdown_test()
class TestCodes(unittest.TestCase):
    def test_codes(self, proc_info):
        launch_testing.asserts.assertExitCodes(proc_info, [7])
""",
        [
            "AssertionError: cannot add",
            "Waiting for output timed out after 0.5 s: Did not find 'Goodbye' in stdout",
            " exited with code 0, and not with one of: 7",
        ],
    ),
    "test_dead.py": (
        """
def generate_test_description():
    dies = python("import sys; print('Adieu'); sys.exit(3)", name="mortal")
    return launch.LaunchDescription([dies, launch_testing.actions.ReadyToTest()])


class TestDead(unittest.TestCase):
    def test_output(self, proc_output):
        proc_output.assertWaitFor("Hello", process="mortal", timeout=60, stream="stdout")
""",
        [
            "Processes under test stopped before tests completed",
            " exited with 3",
            " #####\nAdieu",
            "Waiting for output the launch ended: Did not find 'Hello'",
        ],
    ),
    "test_never_ready.py": (
        """
@launch_testing.ready_to_test_action_timeout(0.5)
def generate_test_description():
    never = launch.actions.TimerAction(period=300.0, actions=[launch_testing.actions.ReadyToTest()])
    return launch.LaunchDescription([counter(), never])


class TestNever(unittest.TestCase):
    def test_never(self):
        assert False
""",
        ["Timed out waiting for processes to start up: no ReadyToTest in 0.5 s"],
    ),
    "test_without_ready.py": (
        """
def generate_test_description():
    return launch.LaunchDescription([counter()])
""",
        ["must return a LaunchDescription containing a ReadyToTest action"],
    ),
    "test_extra_argument.py": (
        """
def generate_test_description(extra):
    return launch.LaunchDescription([launch_testing.actions.ReadyToTest()])
""",
        ["unexpected extra argument 'extra' in generate_test_description"],
    ),
    "test_no_description.py": (
        """
def generate_test_description():
    return 7
""",
        [
            "generate_test_description must return a LaunchDescription, or one and a dictionary, and returned 7"
        ],
    ),
    "test_error_in_launch.py": (
        """
def generate_test_description():
    def fail(context):
        raise RuntimeError("of an action")
    return launch.LaunchDescription([
        counter(), launch.actions.OpaqueFunction(function=fail), launch_testing.actions.ReadyToTest(),
    ])


class TestNever(unittest.TestCase):
    def test_never(self, proc_output):
        proc_output.assertWaitFor("Goodbye", timeout=60)
""",
        ["The launch failed with return code 1: ", "of an action"],
    ),
}
