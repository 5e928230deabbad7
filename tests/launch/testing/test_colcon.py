"""`colcon test` of packages with launch tests, in Python and with a CMakeLists.txt."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from tests.launch.testing import test_launch_pytest
from tests.launch.testing.users import FAILING, LAUNCH, PASSING
from tests.workspace.conftest import SETUP_PY, colcon, write_cmake_package, write_files, write_python_package

pytestmark = [pytest.mark.slow, pytest.mark.skipif(os.name != "posix", reason="needs bash")]

CMAKE = """\
project(robot_bringup)
find_package(ament_cmake REQUIRED)
if(BUILD_TESTING)
  find_package(launch_testing_ament_cmake REQUIRED)
  add_launch_test(test/arguments.test.py ARGS "colour:=blue")
endif()
ament_package()
"""
SAY = """\
def main():
    print("said", flush=True)
"""
INSTALLED = (
    LAUNCH
    + """
from launch_ros.actions import Node


@pytest.mark.rostest
@launch_testing.markers.keep_alive
def generate_test_description():
    say = Node(package="robot_nodes", executable="say")
    return launch.LaunchDescription([say, launch_testing.actions.ReadyToTest()]), {"say": say}


class TestSay(unittest.TestCase):
    def test_said(self, proc_output, proc_info, say):
        proc_output.assertWaitFor("said", process=say, timeout=60, stream="stdout")
        proc_info.assertWaitForShutdown(say, timeout=60)
"""
)


def test_launch_tests_of_a_workspace(tmp_path: Path) -> None:
    setup = SETUP_PY.replace("zip_safe=True,", 'zip_safe=True, extras_require={{"test": ["pytest"]}},')
    write_python_package(tmp_path / "src" / "robot_nodes", SAY, setup=setup)
    tests = {
        "test/test_installed.py": INSTALLED,
        "test/test_good.py": LAUNCH + PASSING["test_good.py"],
        "test/test_wrong.py": LAUNCH + FAILING["test_assertion.py"][0],
        "test/test_pytest.py": test_launch_pytest.HEAD + test_launch_pytest.CLASS_SCOPE,
    }
    write_files(tmp_path / "src" / "robot_nodes", tests)
    arguments = {"test__arguments_DOT_test_DOT_py": LAUNCH + PASSING["test_arguments.py"]}
    write_cmake_package(tmp_path / "src" / "robot_bringup", CMAKE, **arguments)
    built = colcon(tmp_path, "build")
    assert built.code == 0, built.output
    tested = colcon(tmp_path, "test", ROS_LOG_DIR=str(tmp_path / "ros_log"))
    assert tested.code == 0, tested.output
    assert "1 package had test failures: robot_nodes" in tested.output
    result = colcon(tmp_path, "test-result", "--all", "--verbose").output
    assert "robot_bringup/arguments" not in result
    assert "test_arguments.test.py.xunit.xml: 1 test, 0 errors, 0 failures, 0 skipped" in result, result
    assert "pytest.xml: 6 tests, 0 errors, 1 failure, 0 skipped" in result, result
    assert "launch tests failed: test_wrong" in result
