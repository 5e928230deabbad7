"""`launch --skip-missing`: what isn't here is named, and the rest runs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import transcript

MAIN = """
import os
import sys

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument, ExecuteProcess, IncludeLaunchDescription, RegisterEventHandler, TimerAction
)
from launch.event_handlers import OnProcessExit
from launch.substitutions import FindExecutable, LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    laser = get_package_share_directory("laser_driver")
    here = os.path.dirname(__file__)
    say = ExecuteProcess(cmd=[sys.executable, "-c", "print('the rest runs')"], name="say", output="screen")
    return LaunchDescription([
        DeclareLaunchArgument("params", default_value=[FindPackageShare("nav_to_mars"), "/params.yaml"]),
        IncludeLaunchDescription(laser + "/launch/laser.launch.py"),
        IncludeLaunchDescription(here + "/mars.launch.py"),
        IncludeLaunchDescription(here + "/nothere.launch.py"),
        Node(package="rqt_publisher", executable="rqt_publisher"),
        Node(package="turtlesim", executable="no_such_program"),
        ExecuteProcess(cmd=[FindExecutable(name="no_such_gui")]),
        ComposableNodeContainer(name="c", namespace="", package="rclcpp_components", executable="component_container"),
        say,
        RegisterEventHandler(OnProcessExit(target_action=say, on_exit=[
            Node(package="plotjuggler", executable="plotjuggler"),
            ExecuteProcess(cmd=[sys.executable, "-c", "print(sys.argv)"], name="late", output="screen"),
        ])),
    ])
"""
MARS = "from nav_to_mars.launch import Rocket\n"
SKIPPED = [
    "package 'laser_driver' not found: what needs its files is skipped",
    "package 'nav_to_mars' not found: what needs its files is skipped",
    "skipped: {main}:22: package 'laser_driver' not found: it has launch",
    "skipped: {folder}/mars.launch.py:1: ModuleNotFoundError: No module named 'nav_to_mars'",
    "skipped: {main}:24: [Errno 2] No such file or directory: '{folder}/nothere.launch.py'",
    "skipped: {main}:25: package 'rqt_publisher' not found",
    "skipped: {main}:26: executable 'no_such_program' not found on the libexec directory ",
    "skipped: {main}:27: executable 'no_such_gui' not found on the PATH",
    "skipped: {main}:28: ComposableNodeContainer: composable nodes are C++ libraries",
    "skipped: {main}:31: package 'plotjuggler' not found",
]


WITH_CONFIGURATION = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, LogInfo
from launch.substitutions import LaunchConfiguration
from launch_ros.substitutions import FindPackageShare
def generate_launch_description():
    return LaunchDescription([
        IncludeLaunchDescription([FindPackageShare("mars_rover"), "/launch/common.launch.py"]),
        LogInfo(msg=LaunchConfiguration("mode")),
    ])
"""


@pytest.fixture
def launch_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Write launch files of which little can run."""
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path))
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.delenv("AMENT_PREFIX_PATH", raising=False)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mars.launch.py").write_text(MARS)
    path = tmp_path / "main.launch.py"
    path.write_text(MAIN)
    return path


def launch(path: Path, *words: str) -> transcript.Transcript:
    return transcript.launch_here(*words, str(path))


def test_what_is_missing_is_named_and_the_rest_runs(launch_file: Path) -> None:
    ran = launch(launch_file, "--skip-missing")
    assert ran.exit_code == 0, ran.text
    assert "[say-1] the rest runs" in ran.text
    assert "[late-2]" in ran.text
    lines = re.findall(r"^\[WARNING\] \[launch\]: (.*)", ran.text, re.MULTILINE)
    names = {"main": launch_file, "folder": launch_file.parent}
    assert len(lines) == len(SKIPPED), ran.text
    assert "UserWarning" not in ran.text
    assert "in the panel Send of `tfloom view` stands in for it here" in ran.text
    for line, expected in zip(lines, SKIPPED, strict=True):
        assert line.startswith(expected.format(**names))


def test_a_configuration_that_a_skipped_file_would_set_names_it(launch_file: Path) -> None:
    launch_file.write_text(WITH_CONFIGURATION)
    ran = launch(launch_file, "--skip-missing")
    assert ran.exit_code == 1
    include = f"{launch_file}:7: package 'mars_rover' not found: it has launch/common.launch.py"
    assert (
        f"{launch_file}:8: launch configuration 'mode' does not exist; an included file that may set it was skipped: "
        f"{include}"
    ) in ran.text


def test_without_the_flag_what_is_missing_ends_the_launch(launch_file: Path) -> None:
    ran = launch(launch_file)
    assert ran.exit_code == 1
    assert "package 'laser_driver' not found" in ran.text
    assert "the rest runs" not in ran.text


def test_other_errors_end_the_launch(launch_file: Path) -> None:
    launch_file.write_text(MAIN.replace('name="say", output="screen"', 'name="say", output="nowhere"'))
    ran = launch(launch_file, "--skip-missing")
    assert ran.exit_code == 1
    assert f"{launch_file}:19: " in ran.text


@pytest.mark.parametrize("text", [MARS, "import os\nopen('nothere')\n"])
def test_a_file_that_needs_what_is_missing_itself_is_an_error(text: str, launch_file: Path) -> None:
    launch_file.write_text(text)
    ran = launch(launch_file, "--skip-missing")
    assert ran.exit_code == 1
    assert f"{launch_file}:{len(text.splitlines())}: " in ran.text


def test_arguments_are_shown_of_a_file_that_needs_what_is_missing(launch_file: Path) -> None:
    assert launch(launch_file, "--show-args").exit_code == 1
    shown = launch(launch_file, "--show-args", "--skip-missing")
    assert shown.exit_code == 0
    assert "'params':" in shown.text
