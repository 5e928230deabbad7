"""The node robot_state_publisher on the wire inside the process."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests import spun
from tests.robot.test_model import arm_by_hand
from tests.robot.test_urdf import joint, robot

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.interfaces.sensor_msgs.msg import JointState
from tfloom.interfaces.std_msgs.msg import Header, String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node import client_library as rclpy
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.robot.model import RobotModel
from tfloom.robot.robot_state_publisher import RobotStatePublisher, StartError, main
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer

ARM = (Path(__file__).parents[1] / "golden" / "arm.urdf").read_text()
KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
MOVED = ["lower", "slide", "spin", "upper"]
"""The child frames of the moving joints in order of the joints' names: elbow, rail, roll, shoulder."""


class Stage(spun.Stage):
    """A robot_state_publisher, a node that publishes states, and what it receives."""

    def __init__(self, path: Path, *arguments: str) -> None:
        super().__init__(arguments)
        self.user = self.add(Node("user"))
        self.moving: list[TFMessage] = []
        self.static: list[TFMessage] = []
        self.descriptions: list[str] = []
        self.user.create_subscription(TFMessage, "/tf", self.moving.append, 100)
        self.user.create_subscription(TFMessage, "/tf_static", self.static.append, KEPT)
        self.user.create_subscription(
            String, "robot_description", lambda message: self.descriptions.append(message.data), KEPT
        )
        self.states = self.user.create_publisher(JointState, "joint_states", 10)
        self.publisher: Any = self.add(RobotStatePublisher([str(path)]))
        self.run()

    def send(self, names: list[str], positions: list[float], sec: int = 1, nanosec: int = 0) -> None:
        stamp = Time(sec=sec, nanosec=nanosec)
        self.states.publish(JointState(header=Header(stamp=stamp), name=names, position=positions))
        self.run()

    def set(self, name: str, value: object) -> Any:
        result = self.publisher.set_parameters_atomically([Parameter(name, value=value)])
        self.run()
        return result

    def children(self) -> list[list[str]]:
        """Return the child frames of each message on /tf so far, and forget the messages."""
        found = [[transform.child_frame_id for transform in message.transforms] for message in self.moving]
        self.moving.clear()
        return found


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Callable[..., Stage]]:
    path = tmp_path / "robot.urdf"

    def start_robot(urdf: str = ARM, *arguments: str) -> Stage:
        path.write_text(urdf)
        return start(path, *arguments)

    with spun.staging(Stage) as start:
        yield start_robot


def test_states_become_transforms(start: Callable[..., Stage]) -> None:
    stage = start()
    stage.send(["shoulder", "rail", "roll"], [0.3, 0.1, 1.0], 7, 8)
    [message] = stage.moving
    assert [transform.child_frame_id for transform in message.transforms] == MOVED
    assert {
        (transform.header.stamp.sec, transform.header.stamp.nanosec) for transform in message.transforms
    } == {(7, 8)}
    buffer = Buffer()
    buffer.insert_cdr(cdr.encode(message))
    buffer.insert_cdr(cdr.encode(stage.static[-1]), static=True)
    names = RobotModel.from_urdf(ARM).links
    for name, expected in zip(names, arm_by_hand(0.3, 0.1, 1.0), strict=True):
        [found] = buffer.lookup_many("base", name, [0]).matrices()
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)


def test_the_description_and_the_fixed_joints_are_published_once(start: Callable[..., Stage]) -> None:
    stage = start()
    assert stage.descriptions == [ARM]
    [message] = stage.static
    [flange] = message.transforms
    assert (flange.header.frame_id, flange.child_frame_id) == ("spin", "tool")
    assert flange.transform.translation.x == 0.1
    stage.send(["roll"], [1.0])
    assert len(stage.static) == len(stage.descriptions) == 1


def test_joints_that_are_not_named_are_not_published(
    start: Callable[..., Stage], deviations: dict[str, dict[str, str]]
) -> None:
    assert "rsp-no-transforms" in deviations
    stage = start()
    stage.send(["roll", "propeller"], [1.0, 2.0])
    assert stage.children() == [["spin"]]
    stage.send(["propeller"], [1.0], 2)
    stage.send([], [], 3)
    assert stage.children() == []


def test_mimic_joints_follow_unless_they_have_a_state(start: Callable[..., Stage]) -> None:
    def tilt(stage: Stage) -> float:
        rotation = stage.moving[-1].transforms[0].transform.rotation
        return 2 * math.atan2(rotation.y, rotation.w)

    stage = start()
    stage.send(["shoulder"], [0.6])
    assert tilt(stage) == pytest.approx(-0.5 * 0.6 + 0.2)
    stage.send(["shoulder", "elbow"], [0.6, 0.7], 2)
    assert tilt(stage) == pytest.approx(0.7)
    stage.send(["elbow", "shoulder", "elbow"], [0.8, 0.6, 0.9], 3)
    assert tilt(stage) == pytest.approx(0.8), "the first position of a joint counts"


def test_chains_of_mimic_joints(start: Callable[..., Stage], deviations: dict[str, dict[str, str]]) -> None:
    assert "rsp-mimic-chains" in deviations
    stage = start(
        robot(
            joint("1", "a", "b", "continuous", '<mimic joint="2" multiplier="2"/>'),
            joint("2", "b", "c", "continuous", '<mimic joint="3" offset="0.1"/>'),
            joint("3", "c", "d", "continuous"),
            links="abcd",
        )
    )
    stage.send(["3"], [0.5])
    angles = [2 * math.asin(transform.transform.rotation.x) for transform in stage.moving[0].transforms]
    assert angles == pytest.approx([1.2, 0.6, 0.5])
    stage.send(["2"], [0.3], 2)
    angles = [2 * math.asin(transform.transform.rotation.x) for transform in stage.moving[1].transforms]
    assert angles == pytest.approx([0.6, 0.3])


def test_states_are_published_as_often_as_the_frequency_allows(start: Callable[..., Stage]) -> None:
    stage = start(ARM, "-p", "publish_frequency:=10.0")
    ms = 1_000_000
    for nanosec in (0, 50 * ms, 99 * ms, 100 * ms, 150 * ms, 199 * ms, 201 * ms):
        stage.send(["roll"], [1.0], 5, nanosec)
    stamps = [message.transforms[0].header.stamp.nanosec // ms for message in stage.moving]
    assert stamps == [0, 100, 201]
    stage.children()
    stage.send(["roll", "rail"], [1.0, 0.1], 5, 202 * ms)
    assert stage.children() == [["slide", "spin"]], "one of them has never been published"
    assert stage.set("publish_frequency", 0.0).successful
    for nanosec in (203 * ms, 204 * ms):
        stage.send(["roll"], [1.0], 5, nanosec)
    assert stage.children() == [["spin"], ["spin"]]


@pytest.mark.parametrize("frequency", [1e-10, 1e-13, 1e-300])
def test_periods_longer_than_all_time_publish_nothing(start: Callable[..., Stage], frequency: float) -> None:
    stage = start(ARM, "-p", f"publish_frequency:={frequency!r}")
    assert stage.set("publish_frequency", 2 * frequency).successful
    for sec in (5, 2**31 - 1):
        stage.send(["roll"], [1.0], sec)
    assert stage.children() == []


def test_older_stamps_and_none_are_ignored_unless_stamps_are(start: Callable[..., Stage]) -> None:
    stage = start()
    stage.send(["roll"], [1.0], 0)
    assert stage.children() == []
    stage.send(["roll"], [1.0], 10)
    stage.send(["roll"], [1.0], 9)
    assert stage.children() == [["spin"]]
    assert stage.set("ignore_timestamp", True).successful
    stage.send(["roll"], [1.0], 9)
    stage.send(["roll"], [1.0], 0)
    assert stage.children() == [["spin"], ["spin"]]


def test_a_jump_back_in_time_publishes_again(
    start: Callable[..., Stage], capfd: pytest.CaptureFixture[str]
) -> None:
    stage = start()
    stage.send(["roll"], [1.0], 10)
    stage.publisher._sink.set_simulated_time(1)
    stage.send(["roll"], [1.0], 9)
    assert stage.children() == [["spin"], ["spin"]]
    assert "Moved backwards in time, re-publishing joint transforms!" in capfd.readouterr().err


def test_simulated_time(start: Callable[..., Stage], capfd: pytest.CaptureFixture[str]) -> None:
    stage = start(ARM, "-p", "use_sim_time:=true")
    clock = stage.user.create_publisher(Clock, "/clock", 10)
    for sec in (100, 50):
        clock.publish(Clock(clock=Time(sec=sec)))
        stage.run()
        stage.send(["roll"], [1.0], sec)
        stage.send(["roll"], [1.0], sec)
    assert [message.transforms[0].header.stamp.sec for message in stage.moving] == [100, 50]
    assert capfd.readouterr().err.count("Moved backwards in time") == 1


def test_the_prefix_changes_at_run_time(
    start: Callable[..., Stage], deviations: dict[str, dict[str, str]]
) -> None:
    assert "rsp-prefix" in deviations
    stage = start(ARM, "-p", "frame_prefix:=one/")
    stage.send(["roll"], [1.0])
    assert stage.set("frame_prefix", "two/").successful
    stage.send(["roll"], [1.0], 2)
    pairs = [
        (message.transforms[0].header.frame_id, message.transforms[0].child_frame_id)
        for message in stage.moving
    ]
    assert pairs == [("one/slide", "one/spin"), ("two/slide", "two/spin")]
    assert [[transform.child_frame_id for transform in message.transforms] for message in stage.static] == [
        ["one/tool"],
        ["two/tool"],
    ]
    assert stage.descriptions == [ARM]


def test_the_description_changes_at_run_time(
    start: Callable[..., Stage], capfd: pytest.CaptureFixture[str]
) -> None:
    stage = start()
    other = robot(joint("j", "a", "b", "continuous"))
    assert stage.set("robot_description", other).successful
    assert stage.descriptions == [ARM, other]
    assert stage.static[-1].transforms == []
    stage.send(["roll", "j"], [1.0, 2.0])
    assert stage.children() == [["b"]]
    assert capfd.readouterr().err.count("Robot initialized") == 2


def test_values_that_are_refused_change_nothing(
    start: Callable[..., Stage], capfd: pytest.CaptureFixture[str]
) -> None:
    stage = start()
    wrong_type = (
        "Wrong parameter type, parameter {robot_description} is of type {string}, setting it to {integer} is not "
        "allowed."
    )
    wanted = {
        "robot_description": [
            ("<robot", "Unable to initialize urdf::model from robot description"),
            ("", "Empty URDF is not allowed"),
            (1, wrong_type),
        ],
        "publish_frequency": [
            (value, "publish_frequency must be between 0.0 and 1000.0") for value in (-1.0, 1000.5, math.nan)
        ],
    }
    for name, cases in wanted.items():
        for value, reason in cases:
            result = stage.set(name, value)
            assert (result.successful, result.reason) == (False, reason)
    assert (
        "Unable to initialize urdf::model from robot description: line 1: not well-" in capfd.readouterr().err
    )
    several = [Parameter("frame_prefix", value="x/"), Parameter("publish_frequency", value=-1.0)]
    assert not stage.publisher.set_parameters_atomically(several).successful
    stage.send(["roll"], [1.0])
    assert stage.children() == [["spin"]]
    assert stage.descriptions == [ARM]


def test_states_that_are_ignored(
    start: Callable[..., Stage], capfd: pytest.CaptureFixture[str], deviations: dict[str, dict[str, str]]
) -> None:
    assert "rsp-log-throttle" in deviations
    stage = start()
    stage.send(["roll", "rail"], [])
    stage.send(["roll", "rail"], [])
    stage.send(["roll", "rail"], [1.0])
    stage.send([], [1.0])
    stage.states.publish(b"\0\1\0\0nonsense")
    stage.run()
    assert stage.children() == []
    lines = [line.partition("]: ")[2] for line in capfd.readouterr().err.splitlines()]
    assert lines[-3:] == [
        (
            'Robot state publisher ignored a JointState message about joint(s) "roll"(,...) whose position member was '
            "empty."
        ),
        "Robot state publisher ignored an invalid JointState message",
        "Ignored an unreadable message: JointState.header.frame_id: byte 12: 4 bytes are needed, 0 are left",
    ]


def test_positions_that_are_not_finite(
    start: Callable[..., Stage], capfd: pytest.CaptureFixture[str], deviations: dict[str, dict[str, str]]
) -> None:
    assert "rsp-not-finite" in deviations
    stage = start()
    stage.send(["roll", "shoulder"], [1.0, math.nan])
    assert stage.children() == [["spin"]], "nor does the joint that mimics it"
    stage.send(["roll"], [math.inf], 2)
    assert stage.children() == []
    assert "The joint 'shoulder' is not published, because its position is" in capfd.readouterr().err


def test_planar_joints_are_fixed_and_floating_ones_left_out(
    start: Callable[..., Stage], capfd: pytest.CaptureFixture[str]
) -> None:
    stage = start(robot(joint("f", "a", "b", "floating"), joint("p", "b", "c", "planar"), links="abc"))
    assert [transform.child_frame_id for transform in stage.static[0].transforms] == ["c"]
    stage.send(["f", "p"], [1.0, 2.0])
    assert stage.children() == []
    assert "Floating joint. Not adding segment from a to b." in capfd.readouterr().err


def test_what_it_needs_to_start(
    start: Callable[..., Stage], capfd: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    with pytest.raises(StartError, match="publish_frequency must be between 0 and 1000"):
        start(ARM, "-p", "publish_frequency:=-1.0")
    rclpy.try_shutdown()
    (tmp_path / "latin.urdf").write_bytes(b"<robot name='\xfc'/>")
    for words, reason in [
        ([], "robot_description parameter must not be empty"),
        (["nothere.urdf"], "Failed to open URDF file: nothere.urdf: No such file or directory"),
        ([str(tmp_path / "latin.urdf")], "latin.urdf, line 1: the octet 0xfc is not text in utf-8"),
        (
            ["--ros-args", "-p", "robot_description:=<robot"],
            "Unable to initialize urdf::model from robot description",
        ),
    ]:
        assert main(words) == 1
        assert reason in capfd.readouterr().err


class TopicStage(spun.Stage):
    """A robot_state_publisher that takes its robot from a topic, and a node that publishes robots and states."""

    def __init__(self, *arguments: str) -> None:
        super().__init__(("--ros-args", "-p", "use_robot_description_topic:=true", *arguments))
        self.user = self.add(Node("user"))
        self.static: list[TFMessage] = []
        self.moving: list[TFMessage] = []
        self.user.create_subscription(TFMessage, "/tf_static", self.static.append, KEPT)
        self.user.create_subscription(TFMessage, "/tf", self.moving.append, 100)
        self.descriptions = self.user.create_publisher(String, "robot_description", KEPT)
        self.states = self.user.create_publisher(JointState, "joint_states", 10)
        self.publisher: Any = self.add(RobotStatePublisher())
        self.run()


def test_the_robot_comes_from_a_topic(capfd: pytest.CaptureFixture[str]) -> None:
    with spun.staging(TopicStage) as start:
        stage = start()
        state = JointState(header=Header(stamp=Time(sec=1)), name=["j"], position=[0.5])
        stage.states.publish(state)  # before there is a robot
        assert stage.publisher.set_parameters_atomically([Parameter("frame_prefix", value="x/")]).successful
        stage.run()
        assert stage.static == stage.moving == []
        stage.descriptions.publish(String(data=robot(joint("j", "a", "b", "continuous"))))
        stage.run()
        stage.states.publish(state)
        stage.run()
        assert [transform.child_frame_id for transform in stage.moving[-1].transforms] == ["x/b"]
        stage.descriptions.publish(String(data="<robot"))
        stage.run()
        assert "Ignored a description on robot_description" in capfd.readouterr().err
        stage.descriptions.publish(String(data=robot(joint("j", "a", "c", "fixed"), links="ac")))
        stage.run()
        assert [transform.child_frame_id for transform in stage.static[-1].transforms] == ["x/c"]
        assert stage.user.count_publishers("robot_description") == 1
