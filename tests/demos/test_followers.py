"""turtle2 as a follower: the programs turtlesim, broadcasters and a follower, on threads of this process."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from tests.spun import SpunNode, spun

from tfloom.demos.threads import thread_starter
from tfloom.demos.turtle_tf2_py import turtle_tf2_listener
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.interfaces.turtlesim.srv import TeleportAbsolute

CENTRE = 5.544
DEMOS = "tfloom.demos.turtle_tf2_py"


class Observer(SpunNode):
    """Subscribes to the pose of turtle2, and moves turtle1."""

    def __init__(self) -> None:
        super().__init__("observer", 0)
        self._poses = self.received(Pose, "/turtle2/pose")
        self._teleport = self.node.create_client(TeleportAbsolute, "/turtle1/teleport_absolute")

    def distance_to(self, x: float, y: float) -> float:
        return math.dist((self._poses[-1].x, self._poses[-1].y), (x, y)) if self._poses else math.nan

    def teleport(self, x: float, y: float) -> None:
        self.spin_until(self._teleport.service_is_ready)
        self.spin_until(self._teleport.call_async(TeleportAbsolute.Request(x=x, y=y)).done)

    def wait_for(self, lines: list[str], text: str) -> None:
        self.spin_until(lambda: any(text in line for line in list(lines)), text)


@contextmanager
def following(*commands: list[str]) -> Iterator[tuple[Observer, list[str]]]:
    """Start turtles, their frames and programs; yield an observer, and the lines that the last program prints.

    No fixture, because pytest has other streams during a test than before it.
    """
    broadcaster = f"{DEMOS}.turtle_tf2_broadcaster:main"
    turtles = [["tfloom.turtlesim.node:main", "--headless"]] + [
        [broadcaster, "--ros-args", "-r", f"__node:={turtle}_frame", "-p", f"turtlename:={turtle}"]
        for turtle in ("turtle1", "turtle2")
    ]
    lines: list[str] = []
    with thread_starter() as start, spun(Observer()) as observer:
        programs = [start(command, None) for command in (*turtles, *commands[:-1])]
        programs.append(start(commands[-1], lines.append))
        try:
            yield observer, lines
        finally:
            for program in programs:
                program.end(10.0)
        assert [program.exit_code() for program in programs] == [0] * len(programs)


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a follower be there in two seconds."""
    for name, value in (("PERIOD_S", 0.1), ("TURN_GAIN", 4.0), ("SPEED_GAIN", 1.5)):
        monkeypatch.setattr(turtle_tf2_listener, name, value)


def test_follower_reaches_the_fixed_frame() -> None:
    listener = [f"{DEMOS}.turtle_tf2_listener:main", "--ros-args", "-p", "target_frame:=carrot1"]
    with following([f"{DEMOS}.fixed_frame_tf2_broadcaster:main"], listener) as (observer, lines):
        observer.wait_for(lines, "Successfully spawned turtle2")
        observer.spin_until(lambda: observer.distance_to(CENTRE, CENTRE + 2.0) < 0.3)


def test_follower_uses_the_past_pose() -> None:
    traveller = [f"{DEMOS}.turtle_tf2_time_travel:main", "--ros-args", "-p", "delay:=1.5"]
    with following(traveller) as (observer, lines):
        observer.wait_for(lines, "Successfully spawned turtle2")
        observer.wait_for(lines, "Could not transform turtle2 to turtle1: ")
        observer.spin_until(lambda: observer.distance_to(4.0, 2.0) > 0.2)
        observer.teleport(10.0, 10.0)
        observer.spin_until(lambda: observer.distance_to(CENTRE, CENTRE) < 2.0)
        observer.spin_until(lambda: observer.distance_to(10.0, 10.0) < 1.0)
