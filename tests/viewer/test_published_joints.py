"""`tfloom view FILE --publish` and joint_state_publisher_gui: joints that pages move, published for other nodes."""

from __future__ import annotations

import math
import sys
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import TIMEOUT_S, Program, wait_until
from tests.spun import SpunNode, spun
from tests.viewer.conftest import Page
from websockets.sync.client import connect

from tfloom.interfaces.sensor_msgs.msg import JointState
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.node.values.time import Time
from tfloom.robot.joint_state_publisher import JointStatePublisher
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener
from tfloom.viewer.joints import joint_command, joint_rows
from tfloom.viewer.published_joints import PublishedJoints, published_joints

ROBOT = """<robot name="bot"><link name="base"/><link name="tip"/><link name="hand"/>
<joint name="lift" type="prismatic"><parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>
<limit lower="1" upper="3" effort="1" velocity="1"/></joint>
<joint name="turn" type="revolute"><parent link="tip"/><child link="hand"/><axis xyz="0 0 1"/>
<limit lower="-10" upper="10" effort="1" velocity="1"/><mimic joint="lift" multiplier="2" offset="0.5"/></joint>
</robot>"""
KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
on_posix = pytest.mark.skipif(sys.platform == "win32", reason="signals end programs otherwise there")


def never(reason: str) -> None:
    pytest.fail(f"it has ended: {reason}")


@pytest.fixture
def observer(domain_id: int) -> Iterator[SpunNode]:
    with spun(SpunNode("observer", domain_id)) as node:
        yield node


def rows(joints: PublishedJoints) -> dict[str, dict[str, Any]]:
    return {row["key"]: row for row in joint_rows(joints)}


def test_joints_and_frames_are_published_where_pages_move_them(observer: SpunNode) -> None:
    buffer = Buffer()
    TransformListener(buffer, observer.node)
    states = observer.received(JointState, "/joint_states")
    with published_joints(ROBOT, never) as joints:
        assert [(row["position"], row["least"], row["follows"]) for row in rows(joints).values()] == [
            (2.0, 1.0, ""),
            (4.5, -10.0, "lift"),
        ]
        for position in (2.0, 1.25, 3.0):
            joint_command(joints, {"op": "joint", "name": "lift", "position": position})
            turn = 2 * position + 0.5

            def is_there(height_m: float = position, turn_rad: float = turn) -> bool:
                if not buffer.can_transform("base", "hand", Time()):
                    return False
                found = buffer.lookup_transform("base", "hand", Time()).transform
                yaw_rad = 2 * math.atan2(found.rotation.z, found.rotation.w)
                is_turned = math.isclose(math.cos(yaw_rad - turn_rad), 1.0, abs_tol=1e-9)
                return bool(found.translation.z == pytest.approx(height_m)) and is_turned

            observer.spin_until(is_there, f"the frames of {position}")
            observer.spin_until(lambda at=position, to=turn: list(states[-1].position) == [at, to], "it")
        assert list(states[-1].name) == ["lift", "turn"]
        assert joints.about("hand") == "hand is on tip by the revolute joint turn"
    # After the end nothing is published, and it can begin again, at rest.
    observer.spin_until(lambda: observer.node.count_publishers("/joint_states") == 0, "the end")
    states.clear()
    with published_joints(ROBOT, never) as joints:
        observer.spin_until(lambda: states and list(states[-1].position) == [2.0, 4.5], "the second life")


def test_joints_of_a_description_that_comes_later(observer: SpunNode) -> None:
    with published_joints(None, never) as joints:
        assert joints.rows() == []
        joints.move({"lift": 1.0})
        assert joints.about("hand") == ""
        publisher = observer.node.create_publisher(String, "/robot_description", KEPT)
        publisher.publish(String(data=ROBOT))
        observer.spin_until(lambda: list(rows(joints)) == ["lift", "turn"], "the joints")
        joints.move({"lift": 1.5, "turn": 7.0, "absent": 1.0})
        assert [row["position"] for row in rows(joints).values()] == [1.5, 3.5]
        publisher.publish(String(data=ROBOT.replace("lift", "raise")))
        observer.spin_until(lambda: list(rows(joints)) == ["raise", "turn"], "the joints of the next robot")
        assert [row["position"] for row in rows(joints).values()] == [2.0, 4.5]


def test_parameters_of_the_node_count(domain_id: int, tmp_path: Path) -> None:
    path = tmp_path / "bot.urdf"
    path.write_text(ROBOT)
    words = ["--ros-args", "-p", "use_mimic_tags:=false", "-p", "zeros.lift:=1.5"]
    with published_joints(None, never, args=words, urdf_file=str(path)) as joints:
        assert [(row["position"], row["follows"]) for row in rows(joints).values()] == [(1.5, ""), (0.0, "")]
        joint_command(joints, {"op": "joint", "name": "lift", "position": 3})
        joint_command(joints, {"op": "pose", "to": "rest"})
        assert rows(joints)["lift"]["position"] == 1.5


def test_end_of_the_thread_is_told(observer: SpunNode) -> None:
    reasons: list[str] = []
    loop = ["--ros-args", "-p", "dependent_joints.lift.parent:=turn"]  # which mimics the lift
    with published_joints(None, reasons.append, args=loop):
        publisher = observer.node.create_publisher(String, "/robot_description", KEPT)
        publisher.publish(String(data=ROBOT))
        observer.spin_until(lambda: reasons, "the reason")
    assert reasons == ["joint_state_publisher has ended"]


def test_callback_that_raises_ends_neither_joints_nor_frames(
    observer: SpunNode, monkeypatch: pytest.MonkeyPatch
) -> None:
    states = observer.received(JointState, "/joint_states")
    said: list[Any] = []
    monkeypatch.setattr("threading.excepthook", said.append)
    publish = JointStatePublisher.timer_callback

    def fail_once(node: JointStatePublisher) -> None:
        if not said:
            raise ValueError("planted")
        publish(node)

    monkeypatch.setattr(JointStatePublisher, "timer_callback", fail_once)
    with published_joints(ROBOT, never):
        observer.spin_until(lambda: states, "a state after the failure")
    assert [str(told.exc_value) for told in said] == ["planted"]


@contextmanager
def page_of(program: Program) -> Iterator[Page]:
    address = program.wait_for("Open http://127.0.0.1:").partition("Open ")[2]
    with urllib.request.urlopen(address) as response:
        assert b"<title>tfloom view</title>" in response.read()
    with connect(f"{address.replace('http', 'ws')}api", proxy=None, max_size=None) as socket:
        page = Page(socket)
        page.wait_for(lambda: page.state)
        yield page


@on_posix
def test_view_publishes_a_robot_for_other_programs(
    observer: SpunNode, tmp_path: Path, start_program: Callable[..., Program]
) -> None:
    path = tmp_path / "bot.urdf"
    path.write_text(ROBOT)
    states = observer.received(JointState, "/joint_states")
    program = start_program("tfloom", "view", str(path), "--publish", "--no-open", "--port", "0")
    with page_of(program) as page:
        page.wait_for(lambda: page.row("hand"))
        assert (page.state["is_live"], page.state["fixed_frame"]) == (True, "base")
        page.send(op="joint", name="lift", position=1.5)
        observer.spin_until(lambda: states and list(states[-1].position) == [1.5, 3.5], "the state")
        page.send(op="select", frame="tip")
        page.wait_for(lambda: "[0.000, 0.000, 1.500]" in (page.state["selection"] or {}).get("text", ""))
        wait_until(lambda: observer.node.count_publishers("/robot_description") == 1, what="the description")
    program.signal(2)
    assert program.wait() == 0, program.output
    assert "Traceback" not in program.output
    wait_until(lambda: observer.node.count_publishers("/joint_states") == 0, TIMEOUT_S, "the end")


LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    robot = {{"robot_description": {text!r}}}
    return LaunchDescription([
        Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[robot]),
        Node(package="joint_state_publisher_gui", executable="joint_state_publisher_gui",
             name="joint_state_publisher_gui", output="screen"),
    ])
"""


@on_posix
def test_launch_file_of_a_robot_with_sliders(
    observer: SpunNode, tmp_path: Path, start_program: Callable[..., Program]
) -> None:
    path = tmp_path / "bot.launch.py"
    path.write_text(LAUNCH.format(text=ROBOT))
    states = observer.received(JointState, "/joint_states")
    program = start_program("ros2", "launch", str(path))
    with page_of(program) as page:
        page.wait_for(lambda: len(page.state["joints"] or ()) == 2)
        page.send(op="joint", name="lift", position=2.5)
        observer.spin_until(lambda: states and list(states[-1].position) == [2.5, 5.5], "the state")
        names = [name for name, _ in observer.node.get_node_names_and_namespaces()]
        assert {"joint_state_publisher_gui", "robot_state_publisher"} <= {*names}
    program.signal(2)
    assert program.wait() == 0, program.output


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["absent.urdf"], "joint_state_publisher_gui: can't read absent.urdf: No such file or directory"),
        (["bad.urdf"], "joint_state_publisher_gui: bad.urdf: line 1: "),
        (["--ros-args", "-p", "rate:=0"], "joint_state_publisher_gui: "),
    ],
)
def test_what_cant_be_published_is_a_sentence(
    words: list[str], said: str, domain_id: int, tmp_path: Path, start_program: Callable[..., Program]
) -> None:
    (tmp_path / "bad.urdf").write_text("<robot")
    program = start_program(
        "ros2", "run", "joint_state_publisher_gui", "joint_state_publisher_gui", *words, cwd=tmp_path
    )
    assert program.wait() == 1, program.output
    assert any(line.startswith(said) for line in program.lines), program.output
    assert "Traceback" not in program.output


def test_publish_without_a_description_is_a_sentence(start_program: Callable[..., Program]) -> None:
    program = start_program("tfloom", "view", "--publish", "--no-open")
    assert program.wait() == 1
    assert (
        "--publish is for a robot's description: name a file that ends in .urdf or .xacro" in program.output
    )
