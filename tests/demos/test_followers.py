"""turtle2 as a follower: turtlesim, broadcasters and a follower as processes, over DDS, as in the tutorials."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import python_with

from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.interfaces.turtlesim.srv import TeleportAbsolute
from tfloom.node.client_library import init
from tfloom.node.context.utilities import try_shutdown
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node

CENTRE = 5.544
START = ("tfloom", "run", "turtle_tf2_py")
FOLLOWING = "tfloom.demos.turtle_tf2_py.turtle_tf2_listener"
QUICK = {f"{FOLLOWING}.PERIOD_S": 0.1, f"{FOLLOWING}.TURN_GAIN": 4.0, f"{FOLLOWING}.SPEED_GAIN": 1.5}
"""How a follower is there in two seconds."""


def quick(name: str, *words: str) -> list[str]:
    """Return the Python command line that runs a follower with a short period."""
    main = f"from tfloom.demos.turtle_tf2_py.{name} import main; sys.exit(main(sys.argv[1:]))"
    return ["python", *python_with(QUICK, main, *words)]


class Observer:
    """Subscribes to the pose of turtle2, and moves turtle1."""

    def __init__(self) -> None:
        init(args=[])
        self.place = (math.nan, math.nan)
        self._node = Node("observer")
        self._node.create_subscription(Pose, "/turtle2/pose", self._on_pose, 10)
        self._teleport = self._node.create_client(TeleportAbsolute, "/turtle1/teleport_absolute")
        self._executor = SingleThreadedExecutor()
        self._executor.add_node(self._node)

    def _on_pose(self, pose: Pose) -> None:
        self.place = pose.x, pose.y

    def spin_until(self, condition: Callable[[], object], wait_until: Callable[..., None]) -> None:
        def spin_and_look() -> object:
            self._executor.spin_once(timeout_sec=0.01)
            return condition()

        wait_until(spin_and_look)

    def distance_to(self, x: float, y: float) -> float:
        return math.dist(self.place, (x, y))

    def teleport(self, x: float, y: float, wait_until: Callable[..., None]) -> None:
        self.spin_until(self._teleport.service_is_ready, wait_until)
        self.spin_until(self._teleport.call_async(TeleportAbsolute.Request(x=x, y=y)).done, wait_until)

    def end(self) -> None:
        self._executor.shutdown()
        self._node.destroy_node()
        try_shutdown()


@pytest.fixture
def observer(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> Iterator[Observer]:
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    observer = Observer()
    yield observer
    observer.end()


@pytest.fixture
def start_turtles(observer: Observer, start_program: Callable[..., Any]) -> Callable[[], None]:
    def start() -> None:
        start_program("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")
        for turtle in ("turtle1", "turtle2"):
            start_program(*START, "turtle_tf2_broadcaster", "--ros-args", "-p", f"turtlename:={turtle}")

    return start


def test_follower_reaches_the_fixed_frame(
    observer: Observer,
    start_turtles: Callable[[], None],
    start_program: Callable[..., Any],
    wait_until: Callable[..., None],
) -> None:
    start_turtles()
    start_program(*START, "fixed_frame_tf2_broadcaster")
    listener = start_program(*quick("turtle_tf2_listener", "--ros-args", "-p", "target_frame:=carrot1"))
    listener.wait_for("Successfully spawned turtle2")
    observer.spin_until(lambda: observer.distance_to(CENTRE, CENTRE + 2.0) < 0.3, wait_until)


def test_follower_uses_the_past_pose(
    observer: Observer,
    start_turtles: Callable[[], None],
    start_program: Callable[..., Any],
    wait_until: Callable[..., None],
) -> None:
    start_turtles()
    traveller = start_program(*quick("turtle_tf2_time_travel", "--ros-args", "-p", "delay:=1.5"))
    traveller.wait_for("Successfully spawned turtle2")
    traveller.wait_for("Could not transform turtle2 to turtle1: ")
    observer.spin_until(lambda: observer.distance_to(4.0, 2.0) > 0.2, wait_until)
    observer.teleport(10.0, 10.0, wait_until)
    observer.spin_until(lambda: observer.distance_to(CENTRE, CENTRE) < 2.0, wait_until)
    observer.spin_until(lambda: observer.distance_to(10.0, 10.0) < 1.0, wait_until)
