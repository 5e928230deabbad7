"""The driver and a simulated turtle: the turtle stays on the figure."""

from __future__ import annotations

import math

import pytest

from tfloom.demos.turtle_tf2_py.curve_driver import CENTRE_M, LEAD_S, PERIOD_S, figure, steer
from tfloom.turtlesim.world import STEP_S, WallHit, World


def test_figure_is_closed_and_inside_the_world() -> None:
    assert figure(0.0) == (CENTRE_M, CENTRE_M)
    assert figure(PERIOD_S) == pytest.approx(figure(0.0))
    for i in range(1000):
        assert all(0.9 < number < 10.2 for number in figure(i * PERIOD_S / 1000))


def test_turtle_stays_on_the_figure() -> None:
    world = World()
    turtle = world.turtles["turtle1"]
    worst = 0.0
    for i in range(int(PERIOD_S / STEP_S)):
        time_s = i * STEP_S
        speed, turn = steer(turtle.x, turtle.y, turtle.theta, figure(time_s + LEAD_S))
        world.command(turtle, speed, None, turn)
        assert not [event for event in world.step() if isinstance(event, WallHit)]
        if time_s > 2.0:
            nearest = min(math.dist((turtle.x, turtle.y), figure(time_s + k / 50)) for k in range(-25, 26))
            worst = max(worst, nearest)
    assert worst < 0.25
