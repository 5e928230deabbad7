"""Packages with C++ in them: what is built and tested of them, and what their users are told."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.workspace.conftest import Built, colcon, in_shell, write_cmake_package, write_files

# In the manner of public packages of drivers and controllers.
ARM = """
project(arm)
find_package(ros2_control_cmake REQUIRED)
set_compiler_options()
find_package(controller_manager 4.0.0)
if(NOT controller_manager_FOUND)
  message(FATAL_ERROR "version 4.0.0 or higher is required")
endif()
add_library(arm SHARED hardware/arm.cpp)
add_executable(arm_driver src/driver.cpp)
pluginlib_export_plugin_description_file(hardware_interface arm.xml)
install(DIRECTORY hardware/include/ DESTINATION include/arm)
install(DIRECTORY launch urdf config DESTINATION share/${PROJECT_NAME})
install(TARGETS arm arm_driver DESTINATION lib/${PROJECT_NAME})
if(BUILD_TESTING)
  find_package(ament_cmake_pytest REQUIRED)
  ament_add_pytest_test(urdf test/test_urdf.py)
  add_launch_test(test/test_driver.py)
endif()
nav2_package()
ament_package()
"""
ARM_FILES = {
    "launch/arm.launch.xml": '<launch><node pkg="arm" exec="arm_driver"/></launch>',
    "launch/log.launch.xml": '<launch><log_info message="$(find-pkg-share arm)/urdf"/></launch>',
    "urdf/arm.urdf": "<robot/>",
    "config/arm.yaml": "",
    "test/test_urdf.py": "def test_it():\n    print('urdf tested')\n",
    "test/test_driver.py": "raise RuntimeError('it needs C++')\n",
}
TOOLS = """
project(arm_tools)
set(ARM_PORT 7000)
configure_file(config/arm.yaml.in ${CMAKE_CURRENT_BINARY_DIR}/config/arm.yaml @ONLY)
install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/config DESTINATION share/arm_tools)
ament_python_install_package(arm_tools SCRIPTS_DESTINATION lib/arm_tools)
"""
TOOLS_FILES = {
    "config/arm.yaml.in": "port: @ARM_PORT@\n",
    "setup.cfg": "[options.entry_points]\nconsole_scripts =\n  wave = arm_tools.wave:main\n",
    "arm_tools/__init__.py": "",
    "arm_tools/wave.py": "def main():\n    print('waving')\n",
}

BALLS = """\
project(ball_tools)
ament_python_install_package(ball_tools)
if(BUILD_TESTING)
  ament_add_pytest_test(sizes test/test_sizes.py
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/test ENV COLOUR=red APPEND_ENV PATHS=${CMAKE_BINARY_DIR})
endif()
"""
BALLS_TEST = """\
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
BALLS_FILES = {
    "ball_tools/__init__.py": "",
    "ball_tools/size.py": "RADIUS = 3\n",
    "test/test_sizes.py": BALLS_TEST,
}


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Built:
    """Build a workspace of packages, two with C++ in them; one has the name of a package of tfloom's."""
    folder = tmp_path_factory.mktemp("workspace")
    source = folder / "src"
    write_cmake_package(source / "arm", ARM, "rclcpp", "controller_manager")
    write_files(source / "arm", ARM_FILES)
    manifest = source / "arm" / "package.xml"
    manifest.write_text(manifest.read_text().replace("Of a test.", "<p>An <b>arm</b>.</p>"))
    write_cmake_package(source / "arm_tools", TOOLS)
    write_files(source / "arm_tools", TOOLS_FILES)
    write_cmake_package(source / "ball_tools", BALLS)
    write_files(source / "ball_tools", BALLS_FILES)
    write_cmake_package(source / "xacro", "project(xacro)\nadd_executable(xacro xacro.cpp)\n")
    return colcon(folder, "build")


def test_package_with_cpp_is_built_without_it(built: Built) -> None:
    assert built.code == 0
    path = built.folder / "src" / "arm" / "CMakeLists.txt"
    assert f"arm is built without its C++: {path}:5 has find_package(controller_manager …), " in built.output
    assert "isn't understood" not in built.output
    share = built.folder / "install" / "arm" / "share" / "arm"
    files = {path.relative_to(share).as_posix() for path in share.rglob("*") if path.is_file()}
    assert files >= {"urdf/arm.urdf", "config/arm.yaml", "launch/arm.launch.xml", "package.xml"}


def test_who_runs_a_program_in_cpp_is_told_that_it_was_left_out(built: Built) -> None:
    where = f"{built.folder}/src/arm/CMakeLists.txt:5"
    command = "find_package(controller_manager …)"
    reason = f"which is left out of the build: {where} has {command}, which needs a ROS install"
    run = in_shell(built.folder, "tfloom run arm arm_driver")
    assert run == f"No executable found: arm_driver is a program in C++, {reason}"
    launch = in_shell(built.folder, "tfloom launch arm arm.launch.xml", ROS_LOG_DIR=str(built.folder / "log"))
    assert f"arm.launch.xml:1: arm_driver is a program in C++, {reason}" in launch
    assert "colcon build" not in run + launch


def test_launch_files_of_a_package_in_cpp_find_their_folders(built: Built) -> None:
    launch = in_shell(built.folder, "tfloom launch arm log.launch.xml", ROS_LOG_DIR=str(built.folder / "log"))
    assert f"{built.folder}/install/arm/share/arm/urdf" in launch


def test_tfloom_has_the_program_of_a_package_in_cpp(built: Built, tmp_path: Path) -> None:
    (tmp_path / "a.xacro").write_text('<robot name="one"/>')
    run = in_shell(built.folder, f"tfloom run xacro xacro {tmp_path}/a.xacro")
    assert '<robot name="one"/>' in run
    assert "[ros2run]: starting tfloom's own xacro, because that of the sourced workspace is in C++" in run
    text = '<launch><node pkg="xacro" exec="xacro" args="--help" output="screen"/></launch>'
    (tmp_path / "x.launch.xml").write_text(text)
    launch = in_shell(built.folder, f"tfloom launch {tmp_path}/x.launch.xml", ROS_LOG_DIR=str(tmp_path))
    assert "usage: xacro" in launch.lower()


def test_configured_files_and_programs_of_setup_cfg_are_installed(built: Built) -> None:
    share = built.folder / "install" / "arm_tools" / "share" / "arm_tools"
    assert (share / "config" / "arm.yaml").read_text() == "port: 7000\n"
    assert in_shell(built.folder, "tfloom run arm_tools wave") == "waving"


def test_tests_that_start_no_program_in_cpp_run_and_their_results_are_found(built: Built) -> None:
    tested = colcon(built.folder, "test", "--packages-select", "arm", "ball_tools")
    assert tested.code == 0, tested.output
    assert "arm: 1 launch test of its C++ left out" in tested.output
    assert "1 package had test failures: ball_tools" in tested.output
    result = colcon(built.folder, "test-result", "--all", "--verbose").output
    assert "build/arm/test_results/arm/urdf.xunit.xml: 1 test, 0 errors, 0 failures" in result, result
    assert "ball_tools/test_results/ball_tools/sizes.xunit.xml: 2 tests, 0 errors, 1 failure" in result, (
        result
    )
    assert "AssertionError: too small" in result
