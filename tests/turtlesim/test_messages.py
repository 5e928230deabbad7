"""turtlesim's interfaces have the package name of the distribution."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

CODE = """
import tfloom.turtlesim.messages as ours
import tfloom.demos.turtle_tf2_py.messages as theirs
print(ours.Pose._TYPE_NAME, theirs.Pose._TYPE_NAME)
"""


@pytest.mark.parametrize(
    ("distro", "package"),
    [
        (None, "turtlesim"),
        ("humble", "turtlesim"),
        ("jazzy", "turtlesim"),
        ("kilted", "turtlesim_msgs"),
        ("rolling", "turtlesim_msgs"),
    ],
)
def test_package_name_depends_on_the_distribution(distro: str | None, package: str) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "ROS_DISTRO"}
    if distro:
        environment["ROS_DISTRO"] = distro
    command = [sys.executable, "-c", CODE]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout.split() == [f"{package}/msg/Pose"] * 2
