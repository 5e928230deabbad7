"""turtlesim's services: effects, log and responses."""

from __future__ import annotations

import math
from typing import Any

import pytest

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.rcl_interfaces.msg import Parameter as ParameterMessage
from tfloom.interfaces.rcl_interfaces.msg import ParameterValue
from tfloom.interfaces.rcl_interfaces.srv import SetParameters
from tfloom.interfaces.std_srvs.srv import Empty
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.interfaces.turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative


def logged(capfd: pytest.CaptureFixture[str]) -> list[str]:
    """Return level and text of each log record."""
    lines = capfd.readouterr().err.splitlines()
    return [line.split(" ")[0] + line.partition("]:")[2] for line in lines]


def turtles(stage: Any) -> dict:
    return stage.turtlesim.sim.world.turtles


def test_spawn_adds_a_turtle(stage: Any, capfd: pytest.CaptureFixture[str]) -> None:
    capfd.readouterr()
    poses = stage.heard(Pose, "/bob/pose")
    assert stage.call(Spawn, "/spawn", x=2.0, y=3.0, theta=0.5, name="bob").name == "bob"
    assert logged(capfd) == ["[INFO] Spawning turtle [bob] at x=[2.000000], y=[3.000000], theta=[0.500000]"]
    stage.spin_until(lambda: poses)
    assert (poses[0].x, poses[0].y, poses[0].theta) == (2.0, 3.0, 0.5)
    assert stage.call(Spawn, "/spawn", x=2.0, y=3.0, theta=0.5, name="bob").name == ""
    assert logged(capfd) == ["[ERROR] A turtle named [bob] already exists"]
    assert stage.call(Spawn, "/spawn").name == "turtle2"


@pytest.mark.parametrize(
    "fields", [{"x": math.nan}, {"theta": math.inf}, {"name": "no good"}, {"name": "1st"}]
)
def test_invalid_turtle_is_not_spawned(
    stage: Any, capfd: pytest.CaptureFixture[str], fields: dict[str, Any]
) -> None:
    capfd.readouterr()
    assert stage.call(Spawn, "/spawn", **fields).name == ""
    assert logged(capfd)[0].startswith("[ERROR] ")
    assert list(turtles(stage)) == ["turtle1"]


INVALID_NAMES = ["a" * 300, "a" * 212, "{foo}", "{ns}", "a//b", "a/", "~x", "a b", "1st", "é"]


@pytest.mark.parametrize("name", INVALID_NAMES)
def test_a_name_that_makes_no_valid_names_is_refused(
    stage: Any, capfd: pytest.CaptureFixture[str], name: str
) -> None:
    endpoints = len(list(stage.turtlesim.publishers))
    capfd.readouterr()
    assert stage.call(Spawn, "/spawn", name=name).name == ""
    (line,) = logged(capfd)
    assert line.startswith(f"[ERROR] A turtle can't be named [{name}]: ")
    assert list(turtles(stage)) == ["turtle1"]
    assert len(list(stage.turtlesim.publishers)) == endpoints
    assert stage.call(Spawn, "/spawn").name == "turtle2"


MAX_LENGTH_NAME = "a" * (247 - len("//rotate_absolute/_action/cancel_goal"))


@pytest.mark.parametrize("name", [MAX_LENGTH_NAME, "{node}", "~", "~/a", "/turtle1", "/a/b"])
def test_a_name_that_makes_valid_names_is_a_turtle(stage: Any, name: str) -> None:
    assert stage.call(Spawn, "/spawn", name=name).name == name
    stage.call(Kill, "/kill", name=name)
    assert list(turtles(stage)) == ["turtle1"]


def test_the_next_free_name_may_be_too_long(start_stage: Any, capfd: pytest.CaptureFixture[str]) -> None:
    longest = "/" + "n" * (len(MAX_LENGTH_NAME) - len("/turtle1"))
    stage = start_stage("-r", f"turtlesim:__ns:={longest}")
    for number in range(2, 10):
        assert stage.call(Spawn, f"{longest}/spawn").name == f"turtle{number}"
    capfd.readouterr()
    assert stage.call(Spawn, f"{longest}/spawn").name == ""
    assert logged(capfd) == [
        "[ERROR] A turtle can't be named [turtle10]: topic length should not exceed '247'"
    ]


def test_kill_removes_a_turtle(stage: Any, capfd: pytest.CaptureFixture[str]) -> None:
    stage.call(Kill, "/kill", name="turtle1")
    assert turtles(stage) == {}
    assert "/turtle1/pose" not in [one.topic_name for one in stage.turtlesim.publishers]
    capfd.readouterr()
    stage.call(Kill, "/kill", name="turtle1")
    assert logged(capfd) == ["[ERROR] Tried to kill turtle [turtle1], which does not exist"]
    assert stage.call(Spawn, "/spawn", x=1.0, name="turtle1").name == "turtle1"


def test_clear_removes_the_strokes(stage: Any, capfd: pytest.CaptureFixture[str]) -> None:
    stage.user.create_publisher(Twist, "/turtle1/cmd_vel", 7).publish(Twist())
    stage.call(TeleportRelative, "/turtle1/teleport_relative", linear=2.0)
    canvas = stage.turtlesim.sim.canvas
    stage.spin_until(lambda: canvas.color_at(6.0, 5.544) == (179, 184, 255))
    capfd.readouterr()
    stage.call(Empty, "/clear")
    assert logged(capfd) == ["[INFO] Clearing turtlesim."]
    assert canvas.color_at(6.0, 5.544) == (255, 255, 255)


def test_reset_restores_the_initial_world(stage: Any, capfd: pytest.CaptureFixture[str]) -> None:
    stage.call(Spawn, "/spawn", name="bob")
    stage.call(TeleportAbsolute, "/turtle1/teleport_absolute", x=1.0, y=2.0, theta=3.0)
    capfd.readouterr()
    stage.call(Empty, "/reset")
    assert logged(capfd) == [
        "[INFO] Resetting turtlesim.",
        "[INFO] Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]",
    ]
    assert list(turtles(stage)) == ["turtle1"]
    poses = stage.heard(Pose, "/turtle1/pose")
    stage.spin_until(lambda: poses)
    assert poses[0].x == 5.544444561004639


def test_teleports_move_the_turtle(stage: Any) -> None:
    poses = stage.heard(Pose, "/turtle1/pose")
    stage.call(TeleportAbsolute, "/turtle1/teleport_absolute", x=1.0, y=2.0, theta=math.pi / 2)
    stage.spin_until(lambda: poses and poses[-1].x == 1.0)
    assert poses[-1].y == pytest.approx(2.0)
    stage.call(TeleportRelative, "/turtle1/teleport_relative", linear=3.0, angular=-math.pi / 2)
    stage.spin_until(lambda: poses[-1].x == pytest.approx(4.0))
    assert poses[-1].theta == pytest.approx(0.0, abs=1e-6)
    stage.call(TeleportAbsolute, "/turtle1/teleport_absolute", x=math.nan)
    stage.call(TeleportRelative, "/turtle1/teleport_relative", linear=math.inf)
    count = len(poses)
    stage.spin_until(lambda: len(poses) > count + 2)
    assert poses[-1].x == pytest.approx(4.0)


def test_set_pen_changes_colour_width_and_state(stage: Any) -> None:
    stage.call(SetPen, "/turtle1/set_pen", r=1, g=2, b=3, width=5)
    pen = turtles(stage)["turtle1"].pen
    assert (pen.color, pen.width_px, pen.is_on) == ((1, 2, 3), 5, True)
    stage.call(SetPen, "/turtle1/set_pen", r=9, off=1)
    pen = turtles(stage)["turtle1"].pen
    assert (pen.color, pen.is_on) == ((1, 2, 3), False)


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("background_r", {"type": 2, "integer_value": 150}, ""),
        (
            "background_r",
            {"type": 2, "integer_value": 300},
            "Parameter {background_r} doesn't comply with integer range.",
        ),
        (
            "background_r",
            {"type": 4, "string_value": "abc"},
            (
                "Wrong parameter type, parameter {background_r} is of type {integer}, setting it to {string} is "
                "not allowed."
            ),
        ),
        ("holonomic", {"type": 1, "bool_value": True}, ""),
    ],
)
def test_parameters_are_set_with_the_reasons_of_the_reference(
    stage: Any, name: str, value: dict[str, Any], reason: str
) -> None:
    parameter = ParameterMessage(name=name, value=ParameterValue(**value))
    answer = stage.call(SetParameters, "/turtlesim/set_parameters", parameters=[parameter])
    assert [(result.successful, result.reason) for result in answer.results] == [(not reason, reason)]
    if not reason:
        assert stage.turtlesim.get_parameter(name).value in {150, True}
