"""The action rotate_absolute: goals, feedback, results, and what ends them."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from tfloom.interfaces.action_msgs.msg import GoalStatus
from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.turtlesim.action import RotateAbsolute
from tfloom.interfaces.turtlesim.srv import Kill, Spawn
from tfloom.node.action.client import ActionClient


class Goals:
    """Sends goals and waits for what becomes of them."""

    def __init__(self, stage: Any) -> None:
        self._stage = stage
        self._client = ActionClient(stage.user, RotateAbsolute, "/turtle1/rotate_absolute")
        self.remaining: list[float] = []
        stage.spin_until(self._client.server_is_ready)

    def wait(self, future: Any) -> Any:
        self._stage.spin_until(future.done)
        return future.result()

    def send(self, theta: float) -> Any:
        goal = RotateAbsolute.Goal(theta=theta)
        return self.wait(self._client.send_goal_async(goal, feedback_callback=self._on_feedback))

    def _on_feedback(self, message: Any) -> None:
        self.remaining.append(message.feedback.remaining)

    def result(self, handle: Any) -> tuple[int, float]:
        answer = self.wait(handle.get_result_async())
        return answer.status, answer.result.delta


@pytest.fixture
def goals(stage: Any, capfd: pytest.CaptureFixture[str]) -> Goals:
    goals = Goals(stage)
    capfd.readouterr()
    return goals


def texts(capfd: pytest.CaptureFixture[str]) -> list[str]:
    return [line.split(" ")[0] + line.partition("]:")[2] for line in capfd.readouterr().err.splitlines()]


def test_a_goal_is_reached(stage: Any, goals: Goals, capfd: pytest.CaptureFixture[str]) -> None:
    handle = goals.send(0.3)
    assert handle.accepted
    status, delta = goals.result(handle)
    assert status == GoalStatus.STATUS_SUCCEEDED
    assert delta == pytest.approx(-0.288), "18 steps of 0.016; the sign is the reference's"
    assert goals.remaining == pytest.approx([0.3 - 0.016 * step for step in range(19)], abs=1e-6)
    assert texts(capfd) == ["[INFO] Rotation goal completed successfully"]
    assert stage.turtlesim.sim.world.turtles["turtle1"].theta == pytest.approx(0.288)


def test_a_goal_is_cancelled(goals: Goals, capfd: pytest.CaptureFixture[str]) -> None:
    handle = goals.send(3.0)
    answer = goals.wait(handle.cancel_goal_async())
    assert len(answer.goals_canceling) == 1
    assert goals.result(handle)[0] == GoalStatus.STATUS_CANCELED
    assert texts(capfd) == ["[INFO] Rotation goal canceled"]


def test_a_newer_goal_aborts_the_older(goals: Goals, capfd: pytest.CaptureFixture[str]) -> None:
    older = goals.send(3.0)
    newer = goals.send(0.1)
    assert goals.result(older)[0] == GoalStatus.STATUS_ABORTED
    assert goals.result(newer)[0] == GoalStatus.STATUS_SUCCEEDED
    assert texts(capfd) == [
        "[WARN] Rotation goal received before a previous goal finished. Aborting previous goal",
        "[INFO] Rotation goal completed successfully",
    ]


def test_a_command_aborts_a_goal(stage: Any, goals: Goals, capfd: pytest.CaptureFixture[str]) -> None:
    handle = goals.send(3.0)
    stage.spin_until(lambda: stage.turtlesim.sim.world.turtles["turtle1"].rotation)
    stage.user.create_publisher(Twist, "/turtle1/cmd_vel", 7).publish(Twist())
    assert goals.result(handle)[0] == GoalStatus.STATUS_ABORTED
    assert texts(capfd) == ["[WARN] Velocity command received during rotation goal. Aborting goal"]


def test_a_turtle_killed_while_it_turns_harms_nobody(stage: Any, goals: Goals) -> None:
    handle = goals.send(3.0)
    killer = stage.user.create_client(Kill, "/kill")
    stage.spin_until(killer.service_is_ready)
    handle.get_result_async()
    stage.spin_until(killer.call_async(Kill.Request(name="turtle1")).done)
    assert stage.turtlesim.sim.world.turtles == {}
    spawner = stage.user.create_client(Spawn, "/spawn")
    again = spawner.call_async(Spawn.Request(name="turtle1"))
    stage.spin_until(again.done)
    assert goals.result(goals.send(0.1))[0] == GoalStatus.STATUS_SUCCEEDED


@pytest.mark.parametrize("theta", [math.nan, math.inf])
def test_a_goal_that_is_no_number_is_rejected(goals: Goals, theta: float) -> None:
    assert not goals.send(theta).accepted


def test_each_turtle_has_its_action(start_stage: Callable[..., Any]) -> None:
    stage = start_stage("-r", "__ns:=/turtlesim2")
    client = ActionClient(stage.user, RotateAbsolute, "/turtlesim2/turtle1/rotate_absolute")
    stage.spin_until(client.server_is_ready)
