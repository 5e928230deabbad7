"""`colcon test` of packages whose CMakeLists.txt names tests for pytest."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from tests.workspace.conftest import colcon, write_cmake_package, write_files

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs bash")

CMAKE = """\
project(ball_tools)
ament_python_install_package(ball_tools)
if(BUILD_TESTING)
  ament_add_pytest_test(sizes test/test_sizes.py
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/test ENV COLOUR=red APPEND_ENV PATHS=${CMAKE_BINARY_DIR})
endif()
"""
TESTS = """\
import os
from pathlib import Path

from ball_tools.size import RADIUS


def test_installed_package_is_imported():
    assert RADIUS == 3
    assert Path.cwd().name == "test"
    assert os.environ["COLOUR"] == "red"
    assert os.environ["PATHS"].endswith("/build/ball_tools")


def test_mistake():
    assert RADIUS == 4, "too small"
"""


def test_tests_run_and_their_results_are_found(tmp_path: Path) -> None:
    files = {
        "ball_tools__size_DOT_py": "RADIUS = 3\n",
        "test__test_sizes_DOT_py": TESTS,
    }
    folder = tmp_path / "src" / "ball_tools"
    write_cmake_package(folder, CMAKE, **files)
    write_files(folder, {"ball_tools/__init__.py": ""})
    built = colcon(tmp_path, "build")
    assert built.code == 0, built.output
    tested = colcon(tmp_path, "test")
    assert tested.code == 0, tested.output
    assert "1 package had test failures: ball_tools" in tested.output
    result = colcon(tmp_path, "test-result", "--verbose")
    assert (
        "build/ball_tools/test_results/ball_tools/sizes.xunit.xml: 2 tests, 0 errors, 1 failure"
        in result.output
    )
    assert "AssertionError: too small" in result.output
