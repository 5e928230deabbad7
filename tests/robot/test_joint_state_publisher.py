"""The node joint_state_publisher on the wire inside the process."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests import spun
from tests.robot.test_urdf import joint, robot

from tfloom.interfaces.sensor_msgs.msg import JointState
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node import client_library as rclpy
from tfloom.node.node import Node
from tfloom.node.parameters.exceptions import InvalidParameterValueException
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.robot.joint_state_publisher import JointStatePublisher, main

ARM = Path(__file__).parents[1] / "golden" / "arm.urdf"
NAMES = ["shoulder", "elbow", "rail", "roll"]


class Stage(spun.Stage):
    """A joint_state_publisher, a node beside it, and the states that it receives."""

    def __init__(self, file: Path | None = ARM, *parameters: str) -> None:
        super().__init__([word for parameter in parameters for word in ("-p", parameter)])
        self.user = self.add(Node("user"))
        self.states: list[JointState] = []
        self.user.create_subscription(JointState, "joint_states", self.states.append, 10)
        self.publisher = self.add(JointStatePublisher(None if file is None else str(file)))
        self.publisher.timer.cancel()

    def publish(self) -> JointState:
        """Return the next state."""
        self.publisher.timer_callback()
        self.run()
        return self.states[-1]

    def positions(self) -> list[float]:
        return list(self.publish().position)


@pytest.fixture
def start() -> Iterator[Callable[..., Stage]]:
    with spun.staging(Stage) as start:
        yield start


def test_joints_rest_at_zero(start: Callable[..., Stage]) -> None:
    state = start().publish()
    assert state.name == NAMES
    assert list(state.position) == [0.0, 0.2, 0.0, 0.0], "the elbow mimics the shoulder"
    assert len(state.velocity) == len(state.effort) == 0
    assert state.header.stamp.sec > 0


def test_what_is_published_by_default(start: Callable[..., Stage]) -> None:
    stage = start(
        ARM,
        *(f"publish_default_{kind}:=true" for kind in ("velocities", "efforts")),
        "publish_default_positions:=false",
        "use_mimic_tags:=false",
    )
    state = stage.publish()
    assert list(state.position) == []
    assert list(state.velocity) == list(state.effort) == [0.0] * 4


def test_zeros_and_dependent_joints(start: Callable[..., Stage]) -> None:
    stage = start(
        ARM,
        "zeros.shoulder:=0.5",
        "zeros.rail:=1",
        *("dependent_joints.roll.parent:=rail", "dependent_joints.roll.factor:=2.0"),
        "dependent_joints.roll.offset:=-1.0",
    )
    assert stage.positions() == [0.5, -0.5 * 0.5 + 0.2, 1.0, 2.0 * 1.0 - 1.0]
    assert set(stage.publisher.free_joints) == {"shoulder", "rail"}
    assert stage.publisher.dependent_joints["elbow"] == {"parent": "shoulder", "factor": -0.5, "offset": 0.2}


def test_mimic_tags_may_be_ignored(start: Callable[..., Stage]) -> None:
    assert start(ARM, "use_mimic_tags:=false").positions() == [0.0] * 4


def test_states_of_sources_are_merged(start: Callable[..., Stage], capfd: pytest.CaptureFixture[str]) -> None:
    stage = start(ARM, 'source_list:=["left", "/right"]')
    updates: list[str] = []
    stage.publisher.set_source_update_cb(lambda: updates.append("source"))
    left, right = (stage.user.create_publisher(JointState, topic, 10) for topic in ("left", "right"))
    left.publish(
        JointState(name=["shoulder", "wing"], position=[0.6, 9.0], velocity=[4.0, 9.0], effort=[3.0, 9.0])
    )
    right.publish(JointState(name=["roll", "elbow"], position=[0.1, 9.0], velocity=[2.0, 9.0]))
    right.publish(JointState(name=["roll", "rail"], position=[0.7]))
    stage.run()
    state = stage.publish()
    assert list(state.position) == [0.6, -0.5 * 0.6 + 0.2, 0.0, 0.1]
    assert list(state.velocity) == [4.0, -0.5 * 4.0, 0.0, 2.0]
    assert list(state.effort) == [3.0, 3.0, 0.0, 0.0]
    assert updates == ["source"] * 3
    assert "Ignored the position of joints, because there are 1 for 2 names" in capfd.readouterr().err


def test_delta_moves_joints_between_their_limits(start: Callable[..., Stage]) -> None:
    stage = start(ARM, "delta:=0.15", "zeros.roll:=3.1")
    rows = [stage.positions() for _ in range(4)]
    rail = [row[2] for row in rows]
    assert rail == pytest.approx([0.15, 0.2, 0.05, 0.0]), "from 0 to 0.2 m and back"
    roll = [row[3] for row in rows]
    assert roll == pytest.approx([-3.14159265, -2.99159265, -2.84159265, -2.69159265]), "goes on at -pi"


def test_the_description_arrives_on_the_topic(
    start: Callable[..., Stage], capfd: pytest.CaptureFixture[str], deviations: dict[str, dict[str, str]]
) -> None:
    assert "jsp-invalid-description" in deviations
    stage = start(None)
    waiting = "Waiting for robot_description to be published on the robot_description topic..."
    assert waiting in capfd.readouterr().err
    stage.publisher.timer_callback()
    stage.run()
    assert stage.states == [], "there are no joints yet"
    kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = stage.user.create_publisher(String, "robot_description", kept)
    updates: list[str] = []
    stage.publisher.set_robot_description_update_cb(lambda: updates.append("robot"))
    nested = f"<sdf><world>{robot(joint('only', 'a', 'b', 'continuous'))}</world><robot name='2'/></sdf>"
    for text in (ARM.read_text(), "<robot", "<sdf><model/></sdf>", nested):
        publisher.publish(String(data=text))
        stage.run()
    assert updates == ["robot", "robot"]
    assert stage.publish().name == ["only"]
    printed = capfd.readouterr().err
    assert "Invalid robot_description given, ignoring: line 1: not well-formed" in printed
    assert "Invalid robot_description given, ignoring: line 1: there is no <robot> within <sdf>" in printed


def test_the_description_as_a_parameter(
    start: Callable[..., Stage], deviations: dict[str, dict[str, str]], tmp_path: Path
) -> None:
    assert "jsp-description-parameter" in deviations
    text = robot(joint("only", "a", "b", "continuous")).replace("\n", "")
    parameters = tmp_path / "robot.yaml"
    parameters.write_text(f"/**: {{ros__parameters: {{robot_description: '{text}'}}}}")
    rclpy.init(args=["--ros-args", "--params-file", str(parameters)])
    publisher = JointStatePublisher()
    assert publisher.joint_list == ["only"]
    publisher.destroy_node()


@pytest.mark.parametrize(
    ("parameter", "text"),
    [
        ("rate:=0", "must be a positive number of messages a second"),
        ("zeros.roll:=half", "must be a finite number"),
        ("dependent_joints.roll.factor:=2.0", "All dependent_joints must at least have a parent"),
        (
            "dependent_joints.roll.pivot:=2.0",
            r"must be named dependent_joints.<joint>.parent, .factor or .offset",
        ),
    ],
)
def test_wrong_parameters(start: Callable[..., Stage], parameter: str, text: str) -> None:
    with pytest.raises(InvalidParameterValueException, match=re.escape(text)):
        start(ARM, parameter)


def test_dependences_that_lead_nowhere(
    start: Callable[..., Stage], capfd: pytest.CaptureFixture[str]
) -> None:
    stage = start(ARM, "dependent_joints.roll.parent:=wing")
    assert stage.positions() == [0.0, 0.2, 0.0, 0.0]
    assert (
        "The joint 'roll' stays at 0: it depends on 'wing', which is not a free joint"
        in capfd.readouterr().err
    )


def test_dependences_in_a_loop_end_it(start: Callable[..., Stage], capfd: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        start(ARM, "dependent_joints.roll.parent:=rail", "dependent_joints.rail.parent:=roll")
    assert "Found an infinite recursive mimic chain: ['roll', 'rail', 'roll']" in capfd.readouterr().err


def test_files_that_can_not_be_used(
    start: Callable[..., Stage], tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    broken = tmp_path / "broken.urdf"
    broken.write_text("<robot")
    wanted: list[tuple[Any, str]] = [
        (tmp_path / "nothere.urdf", "No such file or directory"),
        (broken, "line 1: not well-formed XML"),
    ]
    for path, reason in wanted:
        assert main([str(path)]) == 1
        assert reason in capfd.readouterr().err
