"""tfloom's own launch files, by `ros2 launch`, over DDS."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import Program

from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.node.client_library import init
from tfloom.node.context.utilities import try_shutdown
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.time import Time
from tfloom.tf2.errors import TransformException
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener

NAMESPACES = ("turtlesim1", "turtlesim2")
DEMO = "turtle_tf2_py"


class User:
    """A node that looks at what a launch has started."""

    def __init__(self) -> None:
        init(args=[])
        self.node = Node("user")
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self.node)
        self._executor = SingleThreadedExecutor()
        self._executor.add_node(self.node)

    def sees(self, condition: Callable[[], object]) -> Callable[[], object]:
        """Return a condition that is evaluated after waiting messages were received."""

        def look() -> object:
            self._executor.spin_once(timeout_sec=0.01)
            return condition()

        return look

    def nodes(self) -> set[str]:
        named = self.node.get_node_names_and_namespaces()
        return {f"{namespace.rstrip('/')}/{name}" for name, namespace in named} - {"/user"}

    def distance(self, target: str, source: str) -> float | None:
        """Return the distance between two frames [m]; None while it isn't known."""
        try:
            there = self.buffer.lookup_transform(target, source, Time()).transform.translation
        except TransformException:
            return None
        return float((there.x**2 + there.y**2) ** 0.5)

    def end(self) -> None:
        self._executor.shutdown()
        self.node.destroy_node()
        try_shutdown()


@pytest.fixture
def user(domain_id: int) -> Iterator[User]:
    user = User()
    yield user
    user.end()


def expect_clean_end(program: Program, number: int = signal.SIGINT) -> None:
    """End a launch, and check that all of its processes end without an error."""
    program.signal(number)
    program.wait(60.0)
    assert "Traceback" not in program.output
    assert "escalating" not in program.output
    started = [line for line in program.lines if "process started with pid" in line]
    ended = [line for line in program.lines if "process has finished cleanly" in line]
    assert len(started) == len(ended), program.output


def test_multisim_starts_two_turtlesims(
    user: User, start_program: Callable[..., Any], wait_until: Callable[..., None]
) -> None:
    poses: dict[str, list[Pose]] = {name: [] for name in NAMESPACES}
    for name, received in poses.items():
        user.node.create_subscription(Pose, f"/{name}/turtle1/pose", received.append, 10)
    program = start_program("tfloom", "launch", "turtlesim", "multisim.launch.py")
    wait_until(user.sees(lambda: all(poses.values())))
    assert user.nodes() == {f"/{name}/turtlesim" for name in NAMESPACES}
    expect_clean_end(program)
    wait_until(user.sees(lambda: not user.nodes()))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_demo_ends_without_orphans(
    user: User, start_program: Callable[..., Any], wait_until: Callable[..., None], number: int
) -> None:
    program = start_program("tfloom", "launch", DEMO, "turtle_tf2_demo.launch.py")
    names = {"/sim", "/broadcaster1", "/broadcaster2", "/listener"}
    wait_until(user.sees(lambda: user.nodes() == names), what=str(names))
    pids = [int(line.split("[")[-1].rstrip("]")) for line in program.lines if "started with pid" in line]
    assert len(pids) == len(names)
    if number == signal.SIGKILL:
        program.signal(number)
        program.wait()
    else:
        expect_clean_end(program, number)
    wait_until(lambda: not any(map(is_running, pids)))


def is_running(pid: int) -> bool:
    """Return whether a process runs; one that has ended and that its parent has not asked about does not."""
    done = subprocess.run(["ps", "-o", "stat=", "-p", str(pid)], capture_output=True, text=True, check=False)
    return bool(done.stdout.strip()) and not done.stdout.startswith("Z")


def test_demo_follows_the_given_frame(
    user: User, start_program: Callable[..., Any], wait_until: Callable[..., None]
) -> None:
    words = (DEMO, "turtle_tf2_fixed_frame_demo.launch.py", "target_frame:=carrot1")
    program = start_program("tfloom", "launch", *words)

    def is_near() -> bool:
        distance = user.distance("turtle2", "carrot1")
        return distance is not None and distance < 1.0

    wait_until(user.sees(is_near), 60.0, what="turtle2 to come near carrot1")
    assert "[turtle_tf2_listener-4] " in program.output
    expect_clean_end(program)


@pytest.mark.parametrize(
    ("file", "names"),
    [
        (
            "turtle_tf2_dynamic_frame_demo.launch.py",
            {"/sim", "/broadcaster1", "/broadcaster2", "/listener", "/dynamic_broadcaster"},
        ),
        (
            "turtle_tf2_sensor_message.launch.py",
            {"/sim", "/broadcaster1", "/broadcaster2", "/message_broadcaster"},
        ),
    ],
)
def test_demo_starts_its_nodes(
    user: User, start_program: Callable[..., Any], wait_until: Callable[..., None], file: str, names: set[str]
) -> None:
    program = start_program("tfloom", "launch", DEMO, file)
    wait_until(user.sees(lambda: user.nodes() == names), what=str(names))
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
    from pathlib import Path

    recorded = Path(__file__).parents[2] / "golden" / "cli" / "launch_show_args.txt"
    done = subprocess.run(
        [sys.executable, "-m", "tfloom.cli", "launch", DEMO, file, "--show-args"],
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    assert done.stdout.strip() == recorded.read_text("utf-8").strip()
