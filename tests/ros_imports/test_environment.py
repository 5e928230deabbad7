"""Programs find the variables that a sourced ROS sets."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end

from tfloom.ros_imports.ros_distro import ROS_ENVIRONMENT

SHOW = """
import os
print("got", *map(os.environ.get, ("ROS_DISTRO", "ROS_VERSION", "ROS_PYTHON_VERSION")))
"""
LAUNCH = f"""
import sys
from launch import LaunchDescription
from launch.actions import ExecuteProcess, LogInfo
from launch.substitutions import EnvironmentVariable

def generate_launch_description():
    show = ExecuteProcess(cmd=[sys.executable, "-c", {SHOW!r}], output="screen")
    return LaunchDescription([LogInfo(msg=["distro ", EnvironmentVariable("ROS_DISTRO")]), show])
"""


def run(*command: object, **variables: str) -> str:
    environment = {name: value for name, value in os.environ.items() if name not in ROS_ENVIRONMENT}
    done = run_to_end(list(map(str, command)), env=environment | variables)
    assert done.returncode == 0, done.stderr
    return done.stdout


def commands(folder: Path) -> dict[str, tuple[object, ...]]:
    """Return the commands that show the variables, by who sets them."""
    program = folder / "lib" / "my_pkg" / "show"
    marker = folder / "share" / "ament_index" / "resource_index" / "packages" / "my_pkg"
    for path, text in (
        (program, f"#!{sys.executable}\n{SHOW}\n"),
        (marker, ""),
        (folder / "show.launch.py", LAUNCH),
    ):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    program.chmod(0o755)
    verb = (sys.executable, "-m", "tfloom")
    return {
        "rclpy": (sys.executable, "-c", f"import rclpy; {SHOW}"),
        "ros2 run": (*verb, "run", "my_pkg", "show"),
        "ros2 launch": (*verb, "launch", folder / "show.launch.py"),
    }


@pytest.mark.skipif(os.name != "posix", reason="the program that is run is a script")
@pytest.mark.parametrize("setter", ["rclpy", "ros2 run", "ros2 launch"])
def test_variables_are_set(setter: str, tmp_path: Path) -> None:
    command = commands(tmp_path)[setter]
    output = run(*command, AMENT_PREFIX_PATH=str(tmp_path))
    assert "got jazzy 2 3" in output
    assert setter != "ros2 launch" or "distro jazzy" in output


def test_variables_that_have_a_value_keep_it(tmp_path: Path) -> None:
    command = commands(tmp_path)["rclpy"]
    kept = run(*command, AMENT_PREFIX_PATH=str(tmp_path), ROS_DISTRO="rolling", ROS_PYTHON_VERSION="")
    assert "got rolling 2 \n" in kept


def test_messages_alone_set_nothing() -> None:
    assert run(sys.executable, "-c", f"import std_msgs.msg; {SHOW}") == "got None None None\n"
