"""turtle2 as a follower: turtlesim, broadcasters and a follower as processes, over DDS, as in the tutorials."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import python_with
from tests.spun import SpunNode, spun

from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.interfaces.turtlesim.srv import TeleportAbsolute

CENTRE = 5.544
START = ("tfloom", "run", "turtle_tf2_py")
FOLLOWING = "tfloom.demos.turtle_tf2_py.turtle_tf2_listener"
QUICK = {f"{FOLLOWING}.PERIOD_S": 0.1, f"{FOLLOWING}.TURN_GAIN": 4.0, f"{FOLLOWING}.SPEED_GAIN": 1.5}
"""How a follower is there in two seconds."""


def quick(name: str, *words: str) -> list[str]:
    """Return the Python command line that runs a follower with a short period."""
    main = f"from tfloom.demos.turtle_tf2_py.{name} import main; sys.exit(main(sys.argv[1:]))"
    return ["python", *python_with(QUICK, main, *words)]


class Observer(SpunNode):
    """Subscribes to the pose of turtle2, and moves turtle1."""

    def __init__(self, domain_id: int) -> None:
        super().__init__("observer", domain_id)
        self._poses = self.received(Pose, "/turtle2/pose")
        self._teleport = self.node.create_client(TeleportAbsolute, "/turtle1/teleport_absolute")

    def distance_to(self, x: float, y: float) -> float:
        return math.dist((self._poses[-1].x, self._poses[-1].y), (x, y)) if self._poses else math.nan

    def teleport(self, x: float, y: float) -> None:
        self.spin_until(self._teleport.service_is_ready)
        self.spin_until(self._teleport.call_async(TeleportAbsolute.Request(x=x, y=y)).done)


@pytest.fixture
def observer(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> Iterator[Observer]:
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    with spun(Observer(domain_id)) as observer:
        yield observer


@pytest.fixture
def start_turtles(observer: Observer, start_program: Callable[..., Any]) -> Callable[[], None]:
    def start() -> None:
        start_program("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")
        for turtle in ("turtle1", "turtle2"):
            start_program(*START, "turtle_tf2_broadcaster", "--ros-args", "-p", f"turtlename:={turtle}")

    return start


def test_follower_reaches_the_fixed_frame(
    observer: Observer, start_turtles: Callable[[], None], start_program: Callable[..., Any]
) -> None:
    start_turtles()
    start_program(*START, "fixed_frame_tf2_broadcaster")
    listener = start_program(*quick("turtle_tf2_listener", "--ros-args", "-p", "target_frame:=carrot1"))
    listener.wait_for("Successfully spawned turtle2")
    observer.spin_until(lambda: observer.distance_to(CENTRE, CENTRE + 2.0) < 0.3)


def test_follower_uses_the_past_pose(
    observer: Observer, start_turtles: Callable[[], None], start_program: Callable[..., Any]
) -> None:
    start_turtles()
    traveller = start_program(*quick("turtle_tf2_time_travel", "--ros-args", "-p", "delay:=1.5"))
    traveller.wait_for("Successfully spawned turtle2")
    traveller.wait_for("Could not transform turtle2 to turtle1: ")
    observer.spin_until(lambda: observer.distance_to(4.0, 2.0) > 0.2)
    observer.teleport(10.0, 10.0)
    observer.spin_until(lambda: observer.distance_to(CENTRE, CENTRE) < 2.0)
    observer.spin_until(lambda: observer.distance_to(10.0, 10.0) < 1.0)
