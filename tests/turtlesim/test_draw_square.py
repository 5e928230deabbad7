"""draw_square: two metres ahead, a quarter turn to the left, repeatedly."""

from __future__ import annotations

import math
import re
from typing import Any

import pytest

from tfloom.node.turtlesim_types import Pose
from tfloom.turtlesim.draw_square import DrawSquare, Goal


def test_goal_is_reached_within_the_tolerance() -> None:
    goal = Goal(1.0, 2.0, 3.5)
    assert goal.theta == pytest.approx(3.5 - 2 * math.pi)
    assert goal.is_reached(Pose(x=1.09, y=1.91, theta=3.5 - 2 * math.pi + 0.009))
    assert not goal.is_reached(Pose(x=1.11, y=2.0, theta=goal.theta))
    assert not goal.is_reached(Pose(x=1.0, y=2.0, theta=goal.theta + 0.011))


def test_turtle_drives_stops_and_turns(stage: Any, capfd: pytest.CaptureFixture[str]) -> None:
    turtle = stage.turtlesim.sim.world.turtles["turtle1"]
    turtle.teleport(1.0, 1.0, 2.0)
    capfd.readouterr()
    square = stage.add(DrawSquare())
    stage.spin_until(lambda: square._is_turning)
    lines = capfd.readouterr().err.splitlines()
    texts = [line.partition("]: ")[2] for line in lines if "[draw_square]" in line]
    assert texts[:2] == ["New goal [7.544445 5.544445, 0.000000]", "Reached goal"]
    match = re.fullmatch(r"New goal \[(\S+) 5\.544445, 1\.570796\]", texts[2])
    assert match is not None
    assert float(match[1]) == pytest.approx(7.5, abs=0.1)


@pytest.mark.parametrize("pose", [Pose(x=math.inf), Pose(y=math.nan), Pose(theta=-math.inf)])
def test_a_pose_that_is_no_number_is_ignored(
    stage: Any, capfd: pytest.CaptureFixture[str], pose: Pose
) -> None:
    square = stage.add(DrawSquare())
    stage.spin_until(lambda: square._goal is not None)
    sim = stage.user.create_publisher(Pose, "/turtle1/pose", 1)
    warnings: list[str] = []

    def warned() -> bool:
        sim.publish(pose)  # repeatedly, because turtlesim's own pose may replace it in a queue of one
        lines = capfd.readouterr().err.splitlines()
        warnings.extend(line for line in lines if "Ignoring a pose" in line)
        return bool(warnings)

    stage.spin_until(warned)
    assert "[WARN]" in warnings[0]
    stage.spin_until(lambda: square._is_stopping)
