"""The plug-in in its own pytests: what is left after failures, bad use, other ROSs, and the example package."""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import PYTEST, run_to_end

from tfloom.testing import plugin

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "testing"
BIN = Path(sys.executable).parent
Run = Callable[..., str]


@pytest.fixture
def run(tmp_path: Path) -> Run:
    """Return a function that runs pytest on the text of a file, and returns what it printed."""

    def run_pytest(text: str, *words: str, **environment: str) -> str:
        (tmp_path / "test_it.py").write_text(text, "utf-8")
        return pytest_in(tmp_path, *words, **environment)

    return run_pytest


def pytest_in(folder: Path, *words: str, **environment: str) -> str:
    (folder / "pytest.ini").write_text("[pytest]\naddopts = --strict-markers -p no:cacheprovider\n", "utf-8")
    options = ["-W", "ignore::pytest.PytestAssertRewriteWarning"]  # of an editable install
    result = run_to_end(
        [sys.executable, *PYTEST, *options, *words], cwd=folder, env=os.environ | environment, timeout_s=120
    )
    return result.stdout + result.stderr


FAILURES = """import gc, os, signal, threading
import pytest, rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from tfloom.node.context.context import live_contexts

contexts = []

def test_fails(ros_node, ros_context):
    contexts.append(ros_context)
    assert ros_node is None

def test_raises(ros_domain):
    rclpy.init()
    contexts.append(rclpy.get_default_context())
    Node("never_destroyed")
    raise OSError("of the test")

def test_spins_a_thread(ros_graph, ros_context):
    created = threading.Event()
    def spin():
        node = Node("in_thread")
        created.set()
        try:
            rclpy.spin(node)
        except ExternalShutdownException:
            pass
    thread = threading.Thread(target=spin)
    thread.start()
    assert created.wait(10)
    contexts.append((ros_context, thread))
    assert False

def test_is_clean(ros_node):
    context, thread = contexts.pop()
    thread.join(10)
    assert not thread.is_alive()
    assert not any(other.ok() for other in [*contexts, context])
    assert live_contexts() == [ros_node.context]
    assert ros_node.get_node_names() == ["test_node"]

def test_is_clean_without_fixtures():
    assert "RMW_IMPLEMENTATION" not in os.environ and "ROS_DOMAIN_ID" not in os.environ
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert live_contexts() == []

class TestOfTheUser:
    @pytest.fixture
    def ros_node(self):
        return "own"

    def test_own_fixture(self, ros_node):
        assert ros_node == "own"
"""

LAUNCH_TEST = """
import sys, unittest
import launch, launch.actions, launch_testing.actions, launch_testing.markers, pytest

@pytest.mark.launch_test
def generate_test_description():
    wait = launch.actions.ExecuteProcess(cmd=[sys.executable, "-c", "import time; time.sleep(60)"])
    return launch.LaunchDescription([wait, launch_testing.actions.ReadyToTest()])

class TestLaunch(unittest.TestCase):
    def test_it(self):
        pass
"""


START = """
import sys

LOADED = set(sys.modules)

def test_start_imports_nothing_else():
    loaded = {name for name in LOADED if name.startswith("tfloom.")}
    assert {name.split(".")[1] for name in loaded} <= {"launch", "testing", "ros_imports"}
    assert {name for name in loaded if name.startswith("tfloom.testing.")} == {"tfloom.testing.plugin"}
    assert "numpy" not in LOADED
"""

MISUSE = """
import pytest

@pytest.mark.ros_wire("carrier pigeon")
def test_wire(ros_node): pass

@pytest.mark.ros_wire
def test_no_wire(ros_node): pass

def test_late_time(request, ros_node):
    request.getfixturevalue("ros_time")

def test_wait(ros_node, wait_for_message):
    from std_msgs.msg import String
    wait_for_message(String, "chatter", 0.01)

def test_table(tf_buffer_from):
    tf_buffer_from("frame_id child_frame_id x\\nmap base one")
"""


@pytest.fixture(scope="module")
def output(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Return what one run of pytest on all kinds of tests printed; the first file finds what its start has imported."""
    folder = tmp_path_factory.mktemp("users")
    # In its own folder, because a launch test is imported when its folder is listed.
    (folder / "with_launch").mkdir()
    files = {"test_a_start": START + MISUSE, "test_it": FAILURES, "with_launch/test_launch": LAUNCH_TEST}
    for name, text in files.items():
        (folder / f"{name}.py").write_text(text, "utf-8")
    return pytest_in(folder, "-q")


def test_nothing_is_left_after_failures(output: str) -> None:
    assert "6 failed, 5 passed, 2 errors" in output, output
    for name in ("test_fails", "test_raises", "test_spins_a_thread"):
        assert f"FAILED test_it.py::{name}" in output


def test_misuse_is_named_without_a_traceback(output: str) -> None:
    assert output.count('write @pytest.mark.ros_wire("local") or @pytest.mark.ros_wire("dds")') >= 2, output
    assert "name ros_time among the test's arguments" in output
    assert "no message on /chatter within 0.01 s: nobody publishes there; topics of the graph: " in output
    assert "line 2 of the table: x is one, which is not a finite number" in output
    assert not re.search(r"tfloom/testing/(graph|transform_table)\.py", output), (
        "shown where the test is wrong"
    )
    assert output.count("FAILED test_a_start.py::") == 3


def test_a_real_rclpy_is_left_alone(run: Run, tmp_path: Path) -> None:
    other = tmp_path / "other_ros" / "rclpy"
    other.mkdir(parents=True)
    (other / "__init__.py").write_text("ok = True\n")
    output = run(
        "import rclpy\ndef test_other(): assert rclpy.ok is True\ndef test_ours(ros_node): pass\n",
        "-q",
        PYTHONPATH=str(other.parent),
    )
    assert "1 passed, 1 error" in output, output
    assert f"are for tfloom's rclpy, and this one is {other / '__init__.py'}: take that ROS out of" in output


def test_each_fixture_has_a_row_in_the_docs() -> None:
    page = (ROOT / "docs" / "testing.md").read_text("utf-8")
    names = {name for name in plugin.__all__ if not name.startswith("pytest_")}
    assert names == set(re.findall(r"^\| `(\w+)` \|", page, re.MULTILINE))
    assert all(getattr(plugin, name).__doc__ for name in names)


@pytest.mark.wire
@pytest.mark.slow
def test_workers_have_domains_of_their_own(run: Run) -> None:
    """Four tests at a time on DDS, each of which publishes under the same names, and sees itself alone."""
    text = """
import pytest, rclpy
from std_msgs.msg import Int32

@pytest.mark.parametrize("number", range(8))
def test_it(ros_graph, ros_node, number):
    assert rclpy.get_rmw_implementation_identifier() == "rmw_cyclonedds_cpp"
    publisher = ros_node.create_publisher(Int32, "number", 10)
    received = ros_graph.collect(Int32, "number")
    ros_node.create_timer(0.01, lambda: publisher.publish(Int32(data=number)))
    ros_graph.spin_until(lambda: len(received) > 20)
    assert {message.data for message in received} == {number}
    assert set(ros_node.get_node_names()) == {"test_node", "test_observer"}
"""
    output = run(text, "-q", "-n", "4", "--ros-wire", "dds")
    assert "8 passed" in output, output


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Return a copy of the example, in a folder with a space and an umlaut."""
    copied = tmp_path / "my wörk" / "src"
    shutil.copytree(EXAMPLE, copied, ignore=shutil.ignore_patterns("__pycache__", ".pytest_cache"))
    return copied.parent


@pytest.mark.wire
def test_the_example_under_plain_pytest(workspace: Path) -> None:
    package = workspace / "src" / "command_gate"
    assert "10 passed" in pytest_in(package, "-q"), "launch_testing's plug-in is there, too"


@pytest.mark.slow
@pytest.mark.wire
def test_the_example_under_colcon(workspace: Path) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "AMENT_PREFIX_PATH"}
    environment["PATH"] = f"{BIN}{os.pathsep}{environment['PATH']}"
    for words in (["build"], ["test", "--event-handlers", "console_direct+"], ["test-result", "--verbose"]):
        result = run_to_end([BIN / "colcon", *words], cwd=workspace, env=environment, timeout_s=240)
        assert result.returncode == 0, result.stdout + result.stderr
    assert "10 tests, 0 errors, 0 failures, 0 skipped" in result.stdout
