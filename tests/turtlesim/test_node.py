"""The node turtlesim: its topics, parameters and log."""

from __future__ import annotations

import math
import re
import time
from collections.abc import Callable
from typing import Any

import pytest
from tests.recorded_outputs import recorded_output

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.turtlesim.msg import Color, Pose
from tfloom.node.parameters.parameter import Parameter


def twist(ahead: float = 0.0, left: float = 0.0, turn: float = 0.0) -> Twist:
    message = Twist()
    message.linear.x, message.linear.y, message.angular.z = ahead, left, turn
    return message


def poses_of(stage: Any, turtle: str = "turtle1") -> list[Pose]:
    return stage.heard(Pose, f"/{turtle}/pose")


def commander(stage: Any, turtle: str = "turtle1") -> Any:
    return stage.user.create_publisher(Twist, f"/{turtle}/cmd_vel", 7)


def masked(line: str) -> str:
    return re.sub(r"\[\d+\.\d+\]", "[stamp]", line)


def test_startup_log_matches_the_reference(
    start_stage: Callable[..., Any], capfd: pytest.CaptureFixture[str]
) -> None:
    start_stage()
    lines = [masked(line) for line in capfd.readouterr().err.splitlines()]
    assert lines == [masked(line) for line in recorded_output("turtlesim_log").splitlines()[2:4]]


@pytest.mark.timing
def test_poses_are_published(stage: Any) -> None:
    poses = poses_of(stage)
    durations_s: list[float] = []
    while not durations_s or (
        min(durations_s) > 1.1 and len(durations_s) < 10
    ):  # a busy machine makes it longer
        started, first = time.monotonic(), len(poses)
        stage.spin_until(lambda first=first: len(poses) >= first + 63)
        durations_s.append(time.monotonic() - started)
    assert min(durations_s) == pytest.approx(1.0, abs=0.2), "62.5 poses a second"
    # The output of the reference's `ros2 topic echo --once /turtle1/pose`.
    expected = Pose(x=5.544444561004639, y=5.544444561004639)
    assert poses[0] == expected


def test_a_command_moves_the_turtle(stage: Any) -> None:
    poses = poses_of(stage)
    commander(stage).publish(twist(1.0, 5.0, 0.5))
    stage.spin_until(lambda: poses and poses[-1].theta > 0.1)
    assert poses[-1].linear_velocity == 1.0
    assert poses[-1].angular_velocity == 0.5
    assert poses[-1].x > poses[0].x


def test_holonomic_turtles_move_sideways(start_stage: Callable[..., Any]) -> None:
    stage = start_stage("-p", "holonomic:=true")
    poses = poses_of(stage)
    commander(stage).publish(twist(0.0, 2.0))
    stage.spin_until(lambda: poses and poses[-1].y > 5.6)
    assert poses[-1].x == poses[0].x
    stage.turtlesim.set_parameters([Parameter("holonomic", value=False)])
    commander(stage).publish(twist(1.0, -2.0))
    stage.spin_until(lambda: poses[-1].x > poses[0].x)
    assert poses[-1].linear_velocity == pytest.approx(math.sqrt(5)), "what went sideways stays"


def test_commands_with_nan_are_ignored(stage: Any, capfd: pytest.CaptureFixture[str]) -> None:
    poses = poses_of(stage)
    commands = commander(stage)
    for number in (math.nan, math.inf, -1e300):
        commands.publish(twist(number))
        commands.publish(twist(turn=number))
    stage.spin_until(lambda: len(poses) > 3)
    assert poses[-1] == poses[0]
    warning = "Ignoring a velocity command for [turtle1]: not numbers, or too large: nan, 0.0, 0.0"
    assert capfd.readouterr().err.count(warning) == 1


def test_hitting_the_wall_logs_a_warning(stage: Any, capfd: pytest.CaptureFixture[str]) -> None:
    poses = poses_of(stage)
    commander(stage).publish(twist(500.0))
    stage.spin_until(lambda: poses and poses[-1].x > 11.0)
    assert "[WARN]" in (text := capfd.readouterr().err)
    assert "Oh no! I hit the wall! (Clamping from [x=13.544445, y=5.544445])" in text
    assert poses[-1].x == pytest.approx(11.088889)


def test_sensor_reads_the_stroke_under_the_turtle(stage: Any) -> None:
    colors = stage.heard(Color, "/turtle1/color_sensor")
    stage.spin_until(lambda: colors)
    assert colors[0] == Color(r=255, g=255, b=255)
    commander(stage).publish(twist(0.5))
    stage.spin_until(lambda: colors[-1] == Color(r=179, g=184, b=255))


def test_the_background_follows_its_parameters(stage: Any) -> None:
    assert stage.turtlesim.render(500).getpixel((1, 1)) == (69, 86, 255)
    (result,) = stage.turtlesim.set_parameters([Parameter("background_r", value=150)])
    assert result.successful
    assert stage.turtlesim.render(500).getpixel((1, 1)) == (150, 86, 255)


def test_names_are_relative(start_stage: Callable[..., Any]) -> None:
    stage = start_stage("-r", "__ns:=/turtlesim1")
    poses = poses_of(stage, "turtlesim1/turtle1")
    stage.spin_until(lambda: poses)


def test_topics_have_depth_seven(stage: Any) -> None:
    depths = {one.topic_name: one.qos_profile.depth for one in stage.turtlesim.publishers}
    assert depths["/turtle1/pose"] == depths["/turtle1/color_sensor"] == 7
    of_turtles = [one for one in stage.turtlesim.subscriptions if one.topic_name.startswith("/turtle")]
    assert {one.qos_profile.depth for one in of_turtles} == {7}
