"""The robot in a room as a user runs it: processes over DDS on loopback, a recording, and what fails on the way."""

from __future__ import annotations

import math
import re
import signal
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from tests import conftest
from tests.examples.test_processes import end_well
from tests.spun import SpunNode, spun

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.nav_msgs.msg import OccupancyGrid, Odometry
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.interfaces.sensor_msgs.msg import LaserScan
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener

pytestmark = pytest.mark.wire
FOLDER = Path(__file__).parents[2] / "examples" / "robot_in_a_room"
STATES = ("tfloom", "run", "robot_state_publisher", "robot_state_publisher")
DESCRIPTION = f"robot_description:={(FOLDER / 'robot.urdf').read_text('utf-8')}"
LAUNCH = FOLDER / "room.launch.py"
TIMEOUT_S = 90.0
"""The robot has to drive some way, also on a busy machine."""
INTERFERENCE = ("Another node", "Someone else drives")
"""What a program logs when a second robot has its names."""
Start = Callable[..., Any]


class Observer(SpunNode):
    """A node that keeps the last message of each topic, and a buffer."""

    def __init__(self, domain_id: int) -> None:
        super().__init__("observer", domain_id)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self.node)
        self.last: dict[str, Any] = {}
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.follow(OccupancyGrid, "/map", latched)
        self.follow(Odometry, "/ground_truth", 10)
        self.follow(LaserScan, "/scan", qos_profile_sensor_data)

    def follow(self, message_type: Any, topic: str, qos: object) -> None:
        self.node.create_subscription(
            message_type, topic, lambda message: self.last.__setitem__(topic, message), qos
        )

    def wait_for(self, condition: Callable[[], object], what: str = "") -> None:
        self.spin_until(condition, what, TIMEOUT_S)

    def wait_for_position(self, frame: str, child: str) -> np.ndarray:
        """Return a position, which may not be known for moments in which other frames are."""
        self.wait_for(lambda: self.position(frame, child) is not None, f"{child} in {frame}")
        position = self.position(frame, child)
        assert position is not None
        return position

    def position(self, frame: str, child: str = "base_link") -> np.ndarray | None:
        if not self.buffer.can_transform(frame, child, Time()):
            return None
        found = self.buffer.lookup_transform(frame, child, Time()).transform.translation
        return np.array([found.x, found.y, found.z])

    def error(self, frame: str) -> float:
        """Return how far the robot is from where it is taken to be [m]; nan where nothing is known."""
        truth, position = self.last.get("/ground_truth"), self.position(frame)
        if truth is None or position is None:
            return math.nan
        place = truth.pose.pose.position
        return math.hypot(position[0] - place.x, position[1] - place.y)


@pytest.fixture
def observer(domain_id: int) -> Iterator[Observer]:
    with spun(Observer(domain_id)) as made:
        yield made


def check_walls(room: Any, message: OccupancyGrid) -> None:
    """Check that what the map has for occupied is at something of the room, and that most of its walls are there."""
    cells = np.asarray(message.data, np.int8).reshape(message.info.height, message.info.width)
    rows, columns = np.nonzero(cells > 65)
    origin = message.info.origin.position
    points = (np.stack((columns, rows), axis=1) + 0.5) * message.info.resolution + (origin.x, origin.y)
    off = np.abs([room.Room().clearance(*point) for point in points.tolist()])
    assert np.mean(off < 0.1) > 0.95, np.sort(off)[-20:]
    corners = np.array(room.WALLS)
    parts = np.linspace(0.0, 1.0, 60, endpoint=False)[:, np.newaxis]
    walls = np.concatenate(
        [
            start + parts * (end - start)
            for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True)
        ]
    )
    distance = np.linalg.norm(walls[:, np.newaxis] - points, axis=2).min(axis=1)
    assert np.mean(distance < 0.1) > 0.7  # a cupboard, a shelf and a wall hide the rest
    # The robot itself has driven through free cells alone.
    column, row = int(-origin.x / message.info.resolution), int(-origin.y / message.info.resolution)
    assert 0 <= cells[row, column] < 30


def test_robot_maps_its_room_and_the_correction_is_better_than_the_odometry(
    observer: Observer,
    start_program: Start,
    load_room: Callable[[str], ModuleType],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    recorder = start_program(
        "tfloom", "bag", "record", "-o", tmp_path / "drive", "/tf", "/tf_static", "/ground_truth"
    )
    recorder.wait_for("Recording...")
    launch = start_program("tfloom", "launch", LAUNCH, "speed:=0.8")
    observer.wait_for(lambda: observer.position("map", "laser") is not None, "the chain of frames")
    for parent, child in (("map", "odom"), ("odom", "base_link"), ("base_link", "laser")):
        assert observer.position(parent, child) is not None
    np.testing.assert_allclose(observer.position("base_link", "laser"), [0.12, 0.0, 0.26], atol=1e-9)
    tool = observer.wait_for_position("base_link", "tool")

    def has_arm_moved() -> bool:
        return np.linalg.norm(observer.wait_for_position("base_link", "tool") - tool) > 0.1

    observer.wait_for(has_arm_moved, "the arm")
    check_second_robot(observer, start_program)
    # At one time, not at the first: on a busy machine, the mapper may have scans to catch up with.
    observer.wait_for(
        lambda: observer.error("odom") > 0.25 and observer.error("map") < 0.1, "a drift that is corrected"
    )
    observer.wait_for(lambda: "/map" in observer.last)
    check_walls(load_room("room"), observer.last["/map"])
    recorder.signal(signal.SIGINT)
    assert recorder.wait() == 0, recorder.output
    launch.signal(signal.SIGINT)
    assert launch.wait() == 0, launch.output
    for text in ("Traceback", *INTERFERENCE):
        assert text not in launch.output
    compared = start_program("python", FOLDER / "compare.py", tmp_path / "drive")
    assert compared.wait() == 0, compared.output
    errors = {
        name: float(re.search(rf"^{name} +[\d.]+ m +([\d.]+) m", compared.output, re.MULTILINE)[1])
        for name in ("odometry alone", "corrected")
    }
    assert errors["corrected"] < 0.1
    assert errors["odometry alone"] > 2.0 * errors["corrected"]
    assert load_room("compare").main(tmp_path / "drive", "second") == 1
    assert capsys.readouterr().err == f"{tmp_path / 'drive'} has no /second/ground_truth: record it, too\n"


def test_what_cannot_be_compared_is_one_line(
    start_program: Start, load_room: Callable[[str], ModuleType], capsys: pytest.CaptureFixture[str]
) -> None:
    assert load_room("compare").main("nowhere") == 1
    assert re.fullmatch(".*nowhere.*\n", capsys.readouterr().err)
    program = start_program("python", FOLDER / "compare.py")
    assert program.wait() == 1
    assert program.lines == ["usage: compare.py RECORDING [NAME]"]


def check_second_robot(observer: Observer, start_program: Start) -> None:
    """Check that a second robot drives beside the first, each by its own names, and end it."""
    launch = start_program("tfloom", "launch", LAUNCH, "name:=second")
    observer.wait_for(
        lambda: observer.position("second/map", "second/tool") is not None, "the frames of the second"
    )
    observer.wait_for(
        lambda: np.linalg.norm(observer.position("second/odom", "second/base_link")) > 0.3, "its drive"
    )
    assert not observer.buffer.can_transform("map", "second/map", Time())
    launch.signal(signal.SIGINT)
    observer.wait_for(lambda: launch.process.poll() is not None, "its end")
    assert launch.wait() == 0, launch.output
    for text in INTERFERENCE:
        assert text not in launch.output


def test_mapper_that_is_killed_and_a_laser_that_stops(observer: Observer, start_program: Start) -> None:
    robot = start_program("python", FOLDER / "robot.py")
    mapper = start_program("python", FOLDER / "mapper.py")
    start_program(*STATES, "--ros-args", "-p", DESCRIPTION)
    observer.wait_for(lambda: "/map" in observer.last, "the first map")
    mapper.signal(signal.SIGKILL)
    mapper.wait()
    observer.last.clear()
    again = start_program("python", FOLDER / "mapper.py")
    observer.wait_for(lambda: "/map" in observer.last, "the map of the second mapper")
    assert observer.set_parameter("/robot", "laser", False).successful
    again.wait_for("No scan for 2 s: map → odom stays as it is")
    stamp = observer.buffer.lookup_transform("map", "odom", Time()).header.stamp.sec
    observer.wait_for(
        lambda: observer.buffer.lookup_transform("map", "odom", Time()).header.stamp.sec > stamp,
        "map → odom without scans",
    )
    assert observer.set_parameter("/robot", "laser", True).successful
    again.wait_for("Scans are received again")
    second = start_program("python", FOLDER / "robot.py")
    for program in (robot, second):
        program.wait_for("Another node publishes /odom, too: start a second robot under another name")
    assert sum("Another node" in line for line in robot.lines) == 1
    end_well(signal.SIGINT, again, second, robot)


def test_robot_at_a_wall_and_a_clock_that_jumps_back(observer: Observer, start_program: Start) -> None:
    """Under simulated time: the test is the clock, and drives."""
    words = ["--ros-args", "-p", "use_sim_time:=true"]
    robot = start_program("python", FOLDER / "robot.py", *words)
    mapper = start_program("python", FOLDER / "mapper.py", *words)
    start_program(*STATES, *words, "-p", DESCRIPTION)
    clock = observer.node.create_publisher(Clock, "/clock", 10)
    driver = observer.node.create_publisher(Twist, "/cmd_vel", 10)
    now_ns = 1000 * 10**9

    def let_time_pass(condition: Callable[[], object], speed: float, what: str) -> None:
        """Tick at about the pace of the wall, so that programs follow, until a condition holds."""

        def tick() -> object:
            nonlocal now_ns
            now_ns += 20_000_000
            clock.publish(Clock(clock=Time(nanoseconds=now_ns).to_msg()))
            message = Twist()
            message.linear.x = speed
            driver.publish(message)
            observer.executor.spin_once(timeout_sec=0.02)
            return condition()

        conftest.wait_until(tick, TIMEOUT_S, what)

    let_time_pass(lambda: observer.position("map") is not None, 0.0, "the chain of frames")
    let_time_pass(lambda: "stands against something" in robot.output, -0.6, "the wall")
    let_time_pass(lambda: observer.error("odom") > 1.0, -0.6, "wheels that slip")
    let_time_pass(lambda: observer.error("map") < 0.15, -0.6, "a correction")
    now_ns -= 500 * 10**9
    let_time_pass(lambda: "jumped back by" in mapper.output, 0.6, "the jump")
    observer.last.clear()
    let_time_pass(lambda: observer.last.get("/ground_truth") is not None, 0.6, "the robot after the jump")
    observer.buffer.clear()
    let_time_pass(lambda: observer.position("map") is not None, 0.6, "the chain after the jump")
    let_time_pass(lambda: observer.error("map") < 0.2, 0.6, "a pose after the jump")
    assert observer.error("odom") > 0.8
    end_well(signal.SIGINT, mapper, robot)
    assert "The time jumped back by" in robot.output
