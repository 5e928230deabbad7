"""The driver by itself, on the wire within this process: what ends each velocity, and what follows."""

from __future__ import annotations

import itertools
import queue
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.geometry_msgs.msg import Twist, TwistStamped
from tfloom.rmw.base import NodeName, Participant, Reader
from tfloom.rmw.errors import WireError
from tfloom.rmw.local import wire as local
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.viewer.driving import driver as driver_module
from tfloom.viewer.driving.driver import SILENCE_S, Driver, Wish, run_driver

S = 1_000_000_000
DOMAINS = itertools.count(200)


class Robot:
    """What arrives on /cmd_vel."""

    def __init__(self, participant: Participant, message_class: type[Any] = Twist) -> None:
        self._class = message_class
        self._reader: Reader = participant.create_reader(
            NodeName("/", "robot"), topic_of(message_class, "/cmd_vel"), QoS(depth=100)
        )

    def take(self) -> list[Any]:
        messages = []
        while (sample := self._reader.take()) is not None:
            messages.append(cdr.decode(self._class, sample.data))
        return messages

    def velocities(self) -> list[float]:
        return [message.linear.x for message in self.take()]


class Bench:
    """A driver, a robot, and the reasons of refusals."""

    def __init__(self, participant: Participant) -> None:
        self.participant = participant
        self.node = NodeName("/", "view")
        participant.add_node(self.node)
        self.refused: list[tuple[str, str]] = []
        self.driver = Driver(participant, self.node, lambda *said: self.refused.append(said))

    def go(self, page: str = "a", speed: float = 1.0, age_s: float = 0.0, stamp_ns: int = 5 * S) -> None:
        self.driver.do(wish(page, speed, age_s, stamp_ns))


def wish(page: str, speed: float, age_s: float = 0.0, stamp_ns: int = 5 * S, kind: str = "Twist") -> Wish:
    name = f"geometry_msgs/msg/{kind}"
    return Wish(page, "/cmd_vel", name, speed, 0.0, time.monotonic() - age_s, stamp_ns)


@pytest.fixture
def bench() -> Iterator[Bench]:
    participant = local.open_participant(next(DOMAINS))
    try:
        yield Bench(participant)
    finally:
        participant.close()


def test_robot_is_stopped_once_at_silence_and_driven_again_by_the_next_wish(bench: Bench) -> None:
    robot = Robot(bench.participant)
    for _ in range(2):
        bench.go()
        assert bench.driver.step() <= SILENCE_S
        assert robot.velocities()[0] == 1.0
        wait_until(lambda: bench.driver.step() > SILENCE_S, what="the stop")
        assert robot.velocities() == [0.0]
    assert bench.refused == []


def test_wish_that_has_waited_too_long_moves_nothing(bench: Bench) -> None:
    robot = Robot(bench.participant)
    bench.go(age_s=SILENCE_S + 0.01)
    bench.driver.step()
    assert robot.velocities() == []
    bench.go(speed=0.0, age_s=100.0)  # a stop is never too old
    assert robot.velocities() == [0.0]


def test_end_of_a_page_stops_what_it_drives_and_nothing_else(bench: Bench) -> None:
    robot = Robot(bench.participant)
    bench.go("a")
    bench.go("b", speed=2.0)
    assert robot.velocities() == [1.0, 2.0]
    bench.driver.forget("a")
    assert robot.velocities() == [0.0]
    bench.driver.forget("a")
    bench.driver.forget("somebody")
    assert robot.velocities() == []
    bench.driver.forget("b")
    assert robot.velocities() == [0.0]
    # A page that has let go leaves a robot to others, as to a navigation that publishes there, too.
    bench.go("c")
    bench.go("c", speed=0.0)
    bench.driver.forget("c")
    assert robot.velocities() == [1.0, 0.0]


def test_writer_is_closed_some_time_after_its_last_page_and_opened_for_the_next(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(driver_module, "KEPT_S", 0.05)
    robot = Robot(bench.participant)

    def writers() -> int:
        return sum(
            end.is_writer and end.topic.name == "/cmd_vel" for end in bench.participant.graph.endpoints()
        )

    for _ in range(2):
        bench.go("a")
        bench.go("b")
        bench.driver.forget("a")
        assert bench.driver.step() <= SILENCE_S
        assert writers() == 1
        bench.driver.forget("b")
        assert bench.driver.step() < 0.06
        wait_until(lambda: bench.driver.step() > 1e9, what="nothing to do")
        assert writers() == 0
        assert robot.velocities() == [1.0, 1.0, 0.0, 0.0]


def test_stop_waits_for_the_subscription_that_its_writer_does_not_know_yet(bench: Bench) -> None:
    bench.go()
    bench.driver.forget("a")
    robot = Robot(bench.participant)
    assert robot.velocities() == []
    bench.driver.step()
    assert robot.velocities() == [0.0]
    bench.driver.step()
    assert robot.velocities() == []


def test_stop_of_a_driver_that_took_long_to_start_waits_for_the_robot(bench: Bench) -> None:
    bench.go(speed=0.0, age_s=10.0)
    bench.driver.step()
    robot = Robot(bench.participant)
    bench.driver.step()
    assert robot.velocities() == [0.0]


def test_stop_reaches_a_robot_that_is_found_after_other_subscriptions(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(driver_module, "SETTLE_S", 0.2)
    other = Robot(bench.participant)
    bench.go(speed=0.0)
    robot = Robot(bench.participant)
    bench.driver.step()
    assert (other.velocities(), robot.velocities()) == ([0.0, 0.0], [0.0])
    bench.driver.step()
    bench.go()
    bench.driver.step()
    assert (other.velocities(), robot.velocities()) == ([1.0], [1.0])  # the page drives again: no stop waits
    bench.driver.forget("a")
    wait_until(lambda: bench.driver.step() > 1e9, what="nothing to do")
    late = Robot(bench.participant)
    bench.driver.step()
    assert (robot.velocities(), late.velocities()) == ([0.0], [])


def test_stop_of_what_this_driver_has_moved_is_written_once(bench: Bench) -> None:
    robot = Robot(bench.participant)
    bench.go()
    bench.driver.forget("a")
    late = Robot(bench.participant)
    bench.driver.step()
    assert (robot.velocities(), late.velocities()) == ([1.0, 0.0], [])


def test_stop_that_nobody_subscribes_to_is_given_up(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(driver_module, "MATCH_S", 0.05)
    monkeypatch.setattr(driver_module, "KEPT_S", 0.05)
    bench.go()
    bench.driver.forget("a")
    wait_until(lambda: bench.driver.step() > 1e9, what="nothing to do")
    robot = Robot(bench.participant)
    bench.driver.step()
    assert robot.velocities() == []


def test_refused_writer_is_told_to_its_page_alone_and_a_refused_stop_is_tried_again(bench: Bench) -> None:
    robot = Robot(bench.participant)
    bench.go("a")
    (topic,) = bench.driver._topics.values()
    write, failures = topic.writer.write, iter([WireError("full"), WireError("full")])

    def fail_twice(data: bytes) -> None:
        if (error := next(failures, None)) is not None:
            raise error
        write(data)

    topic.writer.write = fail_twice  # type: ignore[method-assign]
    bench.driver.forget("a")
    assert bench.refused == [("a", "full")]
    assert robot.velocities() == [1.0]
    bench.driver.step()
    assert robot.velocities() == []
    bench.driver.step()
    assert robot.velocities() == [0.0]

    bench.driver.do(wish("b", 1.0)._replace(type_name="no/type"))
    assert bench.refused[1][0] == "b"
    bench.go("c")
    assert robot.velocities() == [1.0]


def test_stamp_of_a_stop_is_as_much_later_as_it_comes(bench: Bench) -> None:
    robot = Robot(bench.participant, TwistStamped)
    bench.driver.do(wish("a", 1.0, age_s=0.25, kind="TwistStamped"))
    bench.driver.forget("a")
    first, last = robot.take()
    assert (first.twist.linear.x, first.header.stamp.sec, first.header.stamp.nanosec) == (1.0, 5, 0)
    assert (last.twist.linear.x, last.header.stamp.sec) == (0.0, 5)
    assert 250_000_000 <= last.header.stamp.nanosec < S


@pytest.mark.parametrize(
    "ends", [lambda commands: commands.put(None), lambda commands: commands.put(("no", "wish"))]
)
def test_end_of_the_driver_by_its_end_or_by_a_mistake_stops_everything(
    bench: Bench, ends: Callable[[Any], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(threading, "excepthook", lambda _: None)
    robot = Robot(bench.participant)
    commands: queue.SimpleQueue[Any] = queue.SimpleQueue()
    thread = threading.Thread(target=run_driver, args=(bench.driver, commands))
    thread.start()
    commands.put(wish("a", 1.0))
    wait_until(lambda: robot.velocities() == [1.0], what="the drive")
    ends(commands)
    thread.join(10.0)
    assert not thread.is_alive()
    assert robot.velocities() == [0.0]
