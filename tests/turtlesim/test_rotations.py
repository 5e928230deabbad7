"""The action rotate_absolute: goals, feedback, results, and their ends."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Any

import pytest

from tfloom.interfaces.action_msgs.msg import GoalStatus
from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.std_srvs.srv import Empty
from tfloom.interfaces.turtlesim.action import RotateAbsolute
from tfloom.interfaces.turtlesim.srv import Kill, Spawn
from tfloom.node.action.client import ActionClient
from tfloom.turtlesim.rotations import FAREWELL_S


class Goals:
    """Sends goals and waits for their results."""

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


def test_goal_is_reached(stage: Any, goals: Goals, capfd: pytest.CaptureFixture[str]) -> None:
    handle = goals.send(0.3)
    assert handle.accepted
    status, delta = goals.result(handle)
    assert status == GoalStatus.STATUS_SUCCEEDED
    assert delta == pytest.approx(-0.288), "18 steps of 0.016; the sign is the reference's"
    assert goals.remaining == pytest.approx([0.3 - 0.016 * step for step in range(19)], abs=1e-6)
    assert texts(capfd) == ["[INFO] Rotation goal completed successfully"]
    assert stage.turtlesim.sim.world.turtles["turtle1"].theta == pytest.approx(0.288)


def test_goal_is_cancelled(goals: Goals, capfd: pytest.CaptureFixture[str]) -> None:
    handle = goals.send(3.0)
    answer = goals.wait(handle.cancel_goal_async())
    assert len(answer.goals_canceling) == 1
    assert goals.result(handle)[0] == GoalStatus.STATUS_CANCELED
    assert texts(capfd) == ["[INFO] Rotation goal canceled"]


def test_newer_goal_aborts_the_older(goals: Goals, capfd: pytest.CaptureFixture[str]) -> None:
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


def actions_of(stage: Any) -> list[str]:
    topics = dict(stage.user.get_service_names_and_types_by_node("turtlesim", "/"))
    return [name for name in topics if "rotate_absolute" in name]


@pytest.mark.parametrize("asked_before", [True, False])
def test_killing_a_turning_turtle_aborts_its_goal(stage: Any, goals: Goals, asked_before: bool) -> None:
    handle = goals.send(3.0)
    stage.spin_until(lambda: stage.turtlesim.sim.world.turtles["turtle1"].rotation)
    asked = handle.get_result_async() if asked_before else None
    stage.call(Kill, "/kill", name="turtle1")
    assert stage.turtlesim.sim.world.turtles == {}
    answer = goals.wait(asked or handle.get_result_async())
    assert answer.status == GoalStatus.STATUS_ABORTED
    assert not goals.send(0.1).accepted, "there is no turtle to turn"
    stage.spin_until(lambda: not actions_of(stage))
    assert stage.turtlesim._rotations["turtle1"].is_destroyed
    assert stage.call(Spawn, "/spawn", name="turtle1").name == "turtle1"
    assert goals.result(goals.send(0.1))[0] == GoalStatus.STATUS_SUCCEEDED


def test_reset_aborts_goals_and_the_new_turtle_accepts_others(stage: Any, goals: Goals) -> None:
    handle = goals.send(3.0)
    asked = handle.get_result_async()
    stage.call(Empty, "/reset")
    assert goals.wait(asked).status == GoalStatus.STATUS_ABORTED
    assert goals.result(goals.send(0.3))[0] == GoalStatus.STATUS_SUCCEEDED
    end = time.monotonic() + FAREWELL_S
    stage.spin_until(lambda: time.monotonic() > end)
    assert len(actions_of(stage)) == 3, "it outlives the farewell of the one before it"


def test_killed_turtle_without_goals_removes_its_action(stage: Any, goals: Goals) -> None:
    assert len(actions_of(stage)) == 3
    stage.call(Kill, "/kill", name="turtle1")
    assert actions_of(stage) == []


@pytest.mark.parametrize("theta", [math.nan, math.inf])
def test_goal_with_nan_is_rejected(goals: Goals, theta: float) -> None:
    assert not goals.send(theta).accepted


def test_each_turtle_has_its_action(start_stage: Callable[..., Any]) -> None:
    stage = start_stage("-r", "__ns:=/turtlesim2")
    client = ActionClient(stage.user, RotateAbsolute, "/turtlesim2/turtle1/rotate_absolute")
    stage.spin_until(client.server_is_ready)
