"""mimic: one turtle's velocities are published as another's commands."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.turtlesim.mimic import Mimic


def test_mimic_publishes_the_velocities_of_the_pose(start_stage: Callable[..., Any]) -> None:
    stage = start_stage("-r", "input/pose:=/a/pose", "-r", "output/cmd_vel:=/b/cmd_vel")
    stage.add(Mimic())
    commands = stage.heard(Twist, "/b/cmd_vel")
    seen = stage.user.create_publisher(Pose, "/a/pose", 10)
    seen.publish(Pose(x=1.0, linear_velocity=1.5, angular_velocity=-0.5))
    stage.spin_until(lambda: commands)
    assert (commands[0].linear.x, commands[0].linear.y, commands[0].angular.z) == (1.5, 0.0, -0.5)
