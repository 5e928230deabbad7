"""tfloom's own launch files, by `ros2 launch`, over DDS."""

from __future__ import annotations

import math
import os
import signal
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.cli.transcript import run_here
from tests.launch.ros.user import User, expect_clean_end, is_running, pids_of
from tests.recorded_outputs import recorded_output

from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.turtlesim.msg import Pose

NAMESPACES = ("turtlesim1", "turtlesim2")
DEMO = "turtle_tf2_py"
TURTLES = {"/sim", "/broadcaster1", "/broadcaster2"}


@pytest.fixture
def user(domain_id: int) -> Iterator[User]:
    user = User()
    yield user
    user.end()


def test_multisim_starts_two_turtlesims(
    user: User, start_program: Callable[..., Any], wait_until: Callable[..., None]
) -> None:
    poses: dict[str, list[Pose]] = {name: [] for name in NAMESPACES}
    for name, received in poses.items():
        user.node.create_subscription(Pose, f"/{name}/turtle1/pose", received.append, 10)
    program = start_program("tfloom", "launch", "turtlesim", "multisim.launch.py")
    wait_until(user.sees(lambda: all(poses.values())))
    # A node may be known after its topics, so it is waited for, too.
    wait_until(user.sees(lambda: user.nodes() == {f"/{name}/turtlesim" for name in NAMESPACES}))
    expect_clean_end(program)
    wait_until(user.sees(lambda: not user.nodes()))


@pytest.mark.parametrize(
    ("file", "names", "number"),
    [
        # which includes turtle_tf2_demo.launch.py
        ("turtle_tf2_dynamic_frame_demo", TURTLES | {"/listener", "/dynamic_broadcaster"}, signal.SIGTERM),
        ("turtle_tf2_sensor_message", TURTLES | {"/message_broadcaster"}, signal.SIGKILL),
    ],
)
def test_demo_starts_its_nodes_and_ends_without_orphans(
    user: User,
    start_program: Callable[..., Any],
    wait_until: Callable[..., None],
    file: str,
    names: set[str],
    number: int,
    tmp_path: Path,
) -> None:
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    program = start_program("tfloom", "launch", DEMO, f"{file}.launch.py", env=environment)
    wait_until(user.sees(lambda: user.nodes() == names), what=str(names))
    assert list(tmp_path.glob("launch_*"))
    pids = pids_of(program)
    assert len(pids) == len(names)
    if number == signal.SIGKILL:
        program.signal(number)
        program.wait()
    else:
        expect_clean_end(program, number)
    wait_until(lambda: not any(map(is_running, pids)))
    wait_until(lambda: not list(tmp_path.glob("launch_*")), what="the end of the temporary files")


@pytest.mark.parametrize("distro", ["kilted", "lyrical"])
def test_demo_has_the_types_of_the_distribution(
    user: User, start_program: Callable[..., Any], wait_until: Callable[..., None], distro: str
) -> None:
    """A turtle that is spawned by the service's newer name has a pose of the newer name, which becomes a point."""
    points: list[PointStamped] = []
    user.node.create_subscription(PointStamped, "/turtle3/turtle_point_stamped", points.append, 10)
    environment = {**os.environ, "ROS_DISTRO": distro}
    program = start_program("tfloom", "launch", DEMO, "turtle_tf2_sensor_message.launch.py", env=environment)
    spawn = ("/spawn", "turtlesim_msgs/srv/Spawn", "{x: 4.0, y: 2.0, name: turtle3}")
    assert start_program("ros2", "service", "call", *spawn, env=environment).wait() == 0
    wait_until(user.sees(lambda: points), what="a point of turtle3")
    assert (points[0].point.x, points[0].point.y) == (4.0, 2.0)
    assert points[0].header.frame_id == "world"
    types = dict(user.node.get_topic_names_and_types() + user.node.get_service_names_and_types())
    expected = {
        "/turtle3/pose": "msg/Pose",
        "/turtle1/color_sensor": "msg/Color",
        "/spawn": "srv/Spawn",
        "/kill": "srv/Kill",
        "/turtle1/set_pen": "srv/SetPen",
        "/turtle1/teleport_absolute": "srv/TeleportAbsolute",
    }
    assert {name: types[name] for name in expected} == {
        name: [f"turtlesim_msgs/{kind}"] for name, kind in expected.items()
    }
    expect_clean_end(program)


@pytest.mark.slow
def test_demo_follows_the_given_frame(
    user: User, start_program: Callable[..., Any], wait_until: Callable[..., None]
) -> None:
    words = (DEMO, "turtle_tf2_fixed_frame_demo.launch.py", "target_frame:=carrot1")
    program = start_program("tfloom", "launch", *words)

    def is_near() -> bool:
        at = user.position("turtle2", "carrot1")
        return at is not None and math.hypot(*at) < 1.0

    wait_until(user.sees(is_near), 60.0, what="turtle2 to come near carrot1")
    assert "[turtle_tf2_listener-4] " in program.output
    expect_clean_end(program)


@pytest.mark.parametrize(
    "file",
    [
        "turtle_tf2_demo.launch.py",
        "turtle_tf2_dynamic_frame_demo.launch.py",
        "turtle_tf2_fixed_frame_demo.launch.py",
        "turtle_tf2_sensor_message.launch.py",
    ],
)
def test_arguments_match_the_recording(file: str) -> None:
    shown = run_here("launch", DEMO, file, "--show-args")
    assert (shown.exit_code, shown.text.strip()) == (0, recorded_output("launch_show_args").strip())
