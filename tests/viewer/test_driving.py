"""Robots that are driven from pages: whatever happens to the page, the viewer or the driver, each is stopped."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Any

import pytest
from tests.conftest import Program, python_with, wait_until
from tests.viewer.conftest import Page, running
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from tfloom.interfaces.geometry_msgs.msg import Twist, TwistStamped
from tfloom.node.node import Node
from tfloom.rmw.base import NodeName
from tfloom.rmw.local import wire as local
from tfloom.viewer.driving import link
from tfloom.viewer.driving.driver import SILENCE_S
from tfloom.viewer.driving.link import Driving
from tfloom.viewer.live import live_viewer
from tfloom.viewer.page_command import PageError
from tfloom.viewer.program import Viewer

OpenPage = Callable[[Viewer], Page]
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="sends signals to processes")
MOVING = {"op": "drive", "topic": "/cmd_vel", "ahead": 1.0, "left": -0.5}
STANDING = {**MOVING, "ahead": 0, "left": 0}


class Robot:
    """What a robot is told, with the time of each."""

    def __init__(self, node: Node) -> None:
        self.velocities: list[tuple[float, float]] = []
        self.times_s: list[float] = []
        node.create_subscription(Twist, "/cmd_vel", self._take, 100)

    def _take(self, twist: Twist) -> None:
        self.times_s.append(time.monotonic())
        self.velocities.append((twist.linear.x, twist.angular.z))

    @property
    def is_moved(self) -> bool:
        return self.velocities[-1:] == [(2.0, -1.0)]

    @property
    def is_stopped(self) -> bool:
        return self.velocities[-1:] == [(0.0, 0.0)]


@pytest.fixture
def robot(spun: Node) -> Robot:
    return Robot(spun)


def can_drive(page: Page) -> bool:
    return "/cmd_vel" in page.state.get("drive_topics", [])


def drive(page: Page, robot: Robot) -> None:
    """Drive until the robot has heard of it; what it heard before is forgotten."""
    page.wait_for(lambda: can_drive(page))
    robot.velocities.clear()

    def is_moved() -> bool:
        page.send(**MOVING)
        time.sleep(0.02)
        return robot.is_moved

    wait_until(is_moved, what="a velocity")


def test_robot_is_stopped_each_time_its_page_falls_silent_and_when_it_is_closed(
    robot: Robot, viewer: Viewer, open_page: OpenPage
) -> None:
    page = open_page(viewer)
    for _ in range(2):
        drive(page, robot)
        wait_until(lambda: robot.is_stopped, what="the stop after silence")
    drive(page, robot)
    page.socket.close()
    wait_until(lambda: robot.is_stopped, what="the stop after the page's end")
    later = open_page(
        viewer
    )  # the last page was closed: its driver, and its writer, go on or are opened again
    drive(later, robot)
    later.send(**STANDING)
    wait_until(lambda: robot.is_stopped, what="the stop that the page has asked for")


def test_page_that_is_closed_right_after_its_wish_leaves_a_robot_that_stands(
    robot: Robot, viewer: Viewer, open_page: OpenPage
) -> None:
    moved = 0
    for _ in range(100):
        page = open_page(viewer)
        page.wait_for(lambda page=page: can_drive(page))
        robot.velocities.clear()
        page.send(**MOVING)
        page.socket.close()
        closed_s = time.monotonic()
        # On a busy machine the wish may be too late to move anything.
        wait_until(lambda closed_s=closed_s: robot.is_stopped or time.monotonic() > closed_s + 2 * SILENCE_S)
        assert not robot.is_moved
        assert robot.velocities in ([(2.0, -1.0), (0.0, 0.0)], [(0.0, 0.0)], [])
        moved += len(robot.velocities) == 2
        if moved == 5:
            return
    pytest.fail(f"the robot was moved {moved} times alone")


@pytest.mark.timing
def test_robot_is_driven_and_stopped_while_a_picture_takes_its_time(
    robot: Robot, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    page.wait_for(lambda: can_drive(page))
    drawing, goes_on = threading.Event(), threading.Event()

    def draw() -> None:
        drawing.set()
        goes_on.wait(30.0)

    monkeypatch.setattr(viewer.view, "draw", draw)
    try:
        wait_until(drawing.is_set, what="a picture")
        drive(page, robot)
        told_s = time.monotonic()
        wait_until(lambda: robot.is_stopped, what="the stop")
        assert robot.times_s[-1] - told_s < 0.6
        page.answers.clear()
        assert (
            page.ask("error", **{**MOVING, "topic": "/nobody"})
            == "nobody subscribes to velocities on '/nobody'"
        )
    finally:
        goes_on.set()


def test_what_waited_while_the_server_was_held_up_moves_nothing(
    robot: Robot, viewer: Viewer, page: Page
) -> None:
    drive(page, robot)
    held_up, goes_on = threading.Event(), threading.Event()

    def hold_up() -> None:
        held_up.set()
        goes_on.wait(30.0)

    viewer.pages._loop.call_soon_threadsafe(hold_up)
    wait_until(held_up.is_set)
    for _ in range(60):
        page.send(**MOVING, padding="x" * 10_000)  # more than the server reads at once
    wait_until(lambda: robot.is_stopped, what="the stop, though the server does nothing")
    before = len(robot.velocities)
    page.answers.clear()
    page.send(op="no such command")
    goes_on.set()
    page.answer("error")
    page.send(**STANDING)
    wait_until(lambda: len(robot.velocities) > before, what="what is published next")
    assert robot.velocities[before:] == [(0.0, 0.0)]
    wait_until(lambda: not viewer.pages.is_late(), what="a server that is in time")
    drive(page, robot)  # what is said from now on counts again


def test_what_has_waited_on_its_way_moves_nothing_by_the_clock_of_its_page(
    robot: Robot, viewer: Viewer, page: Page
) -> None:
    page.wait_for(lambda: can_drive(page))
    start_s = time.monotonic()

    def say(late_s: float = 0.0, clock: int = 0, **command: Any) -> None:
        at_s = time.monotonic() - start_s - late_s  # of a page whose clock starts with it
        page.send(**{**MOVING, "at": at_s, "clock": clock, **command})

    def is_moved() -> bool:
        say()
        time.sleep(0.02)
        return robot.is_moved

    for _ in range(2):
        wait_until(is_moved, what="a velocity")
        wait_until(lambda: robot.is_stopped, what="the stop")
        robot.velocities.clear()
        for late_s in (10.0, 9.0, 2.0, 0.6):
            say(late_s)
        say(10.0, ahead=0, left=0)  # a stop is never too late
        wait_until(lambda: robot.velocities, what="the stop")
        assert robot.velocities == [(0.0, 0.0)]
    # Its machine has slept, and its clock with it.
    say(3600.0, clock=1)
    wait_until(lambda: robot.is_moved, what="a velocity")
    assert "at has to be" in page.ask("error", **MOVING, at="x", clock=1)
    assert "clock has to be" in page.ask("error", **MOVING, at=1.0)


def test_nobody_drives_while_and_after_the_viewer_ends(
    robot: Robot, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    drive(page, robot)
    monkeypatch.setattr(viewer, "_is_over", lambda: True)  # as of a signal, before the loop has seen it
    assert page.ask("error", **MOVING) == "the viewer ends"
    wait_until(lambda: robot.is_stopped, what="the stop")
    monkeypatch.undo()
    drive(page, robot)
    viewer._live.driving.close()
    wait_until(lambda: robot.is_stopped, what="the stop")
    assert page.ask("error", **MOVING) == "the viewer has ended"
    viewer._live.driving.close()


def test_end_of_the_loop_ends_the_driver_before_the_pages_are_closed() -> None:
    participant = local.open_participant(198)
    try:
        with live_viewer(participant, topics=("/tf", "/tf_static"), history_s=30.0) as viewer:
            viewer._live.driving.open()
            viewer.run(lambda: True)
            with pytest.raises(PageError, match="the viewer has ended"):
                viewer._live.driving.drive("a", "/cmd_vel", 1.0, 0.0)
            assert not viewer._live.driving._thread.is_alive()
    finally:
        participant.close()


def test_robot_with_stamped_velocities_is_driven(spun: Node, page: Page) -> None:
    stamps: list[tuple[float, int]] = []
    spun.create_subscription(
        TwistStamped, "/cmd_vel", lambda m: stamps.append((m.twist.linear.x, m.header.stamp.sec)), 10
    )
    page.wait_for(lambda: can_drive(page))

    def is_moved() -> bool:
        page.send(**MOVING)
        return bool(stamps) and stamps[-1][0] == 2.0

    wait_until(is_moved, what="a velocity")
    wait_until(lambda: stamps[-1][0] == 0.0, what="the stop")
    assert all(abs(sec - time.time()) < 60.0 for _, sec in stamps)


def test_driver_that_is_killed_is_replaced_and_the_next_one_stops_the_robot(
    robot: Robot, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(link, "RESTART_S", 0.1)
    driving: Any = viewer._live.driving
    for _ in range(2):
        drive(page, robot)
        process = driving._process._process
        process.kill()
        wait_until(lambda: robot.is_stopped, what="the stop by the next driver")
        wait_until(lambda process=process: driving._process._process is not process)
    driving._process.kill()
    drive(page, robot)


def test_driver_whose_libraries_print_is_replaced_when_it_is_killed(
    robot: Robot, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(link, "RESTART_S", 0.1)
    driving: Any = viewer._live.driving
    monkeypatch.setattr(link, "PROGRAM", "print('a trace\\n7\\n[1]', flush=True); " + link.PROGRAM)
    driving._process.kill()
    driving._process._command[2] = link.PROGRAM
    drive(page, robot)
    for _ in range(2):
        driving._process._process.kill()
        wait_until(lambda: robot.is_stopped, what="the stop by the next driver")
        drive(page, robot)


def test_robot_is_stopped_by_the_next_driver_although_that_one_can_not_be_started_at_first(
    robot: Robot, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(link, "RESTART_S", 0.05)
    driving: Any = viewer._live.driving
    drive(page, robot)
    tries: list[object] = []
    with monkeypatch.context() as patch:

        def refuse(*words: object, **_: object) -> None:
            tries.append(words)
            raise BlockingIOError(11, "Resource temporarily unavailable")

        patch.setattr(link.subprocess, "Popen", refuse)
        driving._process._process.kill()
        wait_until(lambda: len(tries) > 3, what="more tries")
        page.socket.close()
        assert robot.is_moved
    wait_until(lambda: robot.is_stopped, what="the stop")


def test_driver_that_ends_at_once_is_tried_for_a_time(
    robot: Robot, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(link, "RESTART_S", 0.05)
    monkeypatch.setattr(link, "MAX_TRY_S", 2.0)
    driving: Any = viewer._live.driving
    drive(page, robot)
    driving._process._command[2] = "import sys; sys.exit(1)"
    driving._process._process.kill()
    wait_until(lambda: not driving._process._driven, what="the end of the tries")
    last = driving._process._process
    assert last.wait() == 1
    driving._process._command[2] = link.PROGRAM
    drive(page, robot)  # and another one is started for what a page wants then
    assert driving._process._process is not last
    wait_until(lambda: robot.is_stopped, what="the stop")


@pytest.mark.parametrize("is_frozen", [True, False])
def test_robot_is_stopped_whose_driver_is_killed_as_its_page_closes(
    is_frozen: bool, robot: Robot, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whether the driver has read of the page's end or not."""
    monkeypatch.setattr(link, "RESTART_S", 0.05)
    driving: Any = viewer._live.driving
    drive(page, robot)
    process = driving._process._process
    if is_frozen:
        process.send_signal(signal.SIGSTOP)
    page.socket.close()
    wait_until(lambda: not viewer._is_open, what="the page's end")
    process.kill()
    wait_until(lambda: driving._process._process is not process, what="the next driver")
    wait_until(lambda: robot.is_stopped, what="the stop")


def test_viewer_that_ends_after_its_driver_was_killed_stops_the_robot(
    robot: Robot, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(link, "RESTART_S", 1000.0)
    driving: Any = viewer._live.driving
    drive(page, robot)
    driving._process._next_start_s = time.monotonic() + 1000.0
    driving._process._process.kill()
    driving.close()
    wait_until(lambda: robot.is_stopped, what="the stop")


def test_driver_that_hangs_is_ended_with_the_viewer(
    robot: Robot, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(link, "MAX_END_S", 0.1)
    drive(page, robot)
    driving: Any = viewer._live.driving
    process = driving._process._process
    process.send_signal(signal.SIGSTOP)
    driving.close()
    wait_until(lambda: process.poll() is not None, what="its end")
    assert process.returncode == -signal.SIGKILL


def test_driver_that_its_wire_holds_up_ends_some_time_after_its_viewer(
    domain_id: int, start_program: Callable[..., Program]
) -> None:
    stuck = (
        "import time\nfrom tfloom.viewer.driving import process\n"
        "process.run_driver = lambda *_: (print('stuck', flush=True), time.sleep(1000.0))\n"
        "sys.exit(process.main(sys.argv[1:]))"
    )
    limit = {"tfloom.viewer.driving.process.MAX_END_S": 0.1}
    program = start_program(sys.executable, *python_with(limit, stuck, str(domain_id), "driver"), stdin=-1)
    program.wait_for("stuck")
    program.process.stdin.close()
    assert program.wait() == 1


def test_driver_that_can_not_be_started_is_told_and_tried_again(
    robot: Robot, viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(link, "RESTART_S", 0.05)
    popen = link.subprocess.Popen

    def refuse(*_: object, **__: object) -> None:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    monkeypatch.setattr(link.subprocess, "Popen", refuse)
    page = open_page(viewer)
    text = "driving needs a process and a thread, which can't be started: Resource temporarily unavailable"
    page.wait_for(lambda: any(line["text"] == text for line in page.log))
    monkeypatch.setattr(link.subprocess, "Popen", popen)
    drive(page, robot)
    wait_until(lambda: robot.is_stopped, what="the stop")


@pytest.mark.parametrize("name", ["tfloom_view_driving", "tfloom_view_driving_words"])
def test_driver_whose_thread_the_system_refuses_is_told_and_tried_again(
    robot: Robot, viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.setattr(link, "RESTART_S", 0.05)

    class RefusedThread(threading.Thread):
        def start(self) -> None:
            if self.name == name:
                raise RuntimeError("can't start new thread")
            super().start()

    monkeypatch.setattr(link.threading, "Thread", RefusedThread)
    page = open_page(viewer)
    page.wait_for(lambda: can_drive(page))

    def is_told() -> bool:
        page.send(**MOVING)
        said = [*(line["text"] for line in page.log), *(str(answer.get("error")) for answer in page.answers)]
        return any("thread" in text and text.endswith("can't start new thread") for text in said)

    page.wait_for(is_told)
    monkeypatch.undo()
    drive(page, robot)
    wait_until(lambda: robot.is_stopped, what="the stop")


def test_driver_that_fails_is_told(
    robot: Robot, viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(viewer._live.driving._environment, "RMW_IMPLEMENTATION", "none")
    page = open_page(viewer)
    page.wait_for(lambda: any(line["text"].startswith("nobody can drive: ") for line in page.log))
    assert sum(line["text"].startswith("nobody can drive: ") for line in page.log) == 1


def test_on_the_wire_within_a_process_a_thread_drives() -> None:
    participant = local.open_participant(199)
    said: list[Twist] = []
    try:
        with (
            live_viewer(participant, topics=("/tf", "/tf_static"), history_s=30.0) as viewer,
            running(viewer),
        ):
            from tests.viewer.test_driver import Robot as LocalRobot

            robot = LocalRobot(participant)
            address = viewer.pages.address.replace("http://", "ws://") + "api"
            with connect(address, max_size=None, proxy=None, ping_interval=None) as socket:
                page = Page(socket)
                page.wait_for(lambda: can_drive(page))

                def is_moved() -> bool:
                    page.send(**MOVING)  # again: what was on its way for long moves nothing
                    said.extend(robot.take())
                    return bool(said)

                wait_until(is_moved, what="a velocity")
                assert viewer._live.driving._process is None
            wait_until(lambda: said.extend(robot.take()) or said[-1].linear.x == 0.0, what="the stop")
    finally:
        participant.close()


def test_thread_that_drives_and_fails_is_told_and_started_again(monkeypatch: pytest.MonkeyPatch) -> None:
    participant = local.open_participant(198)
    told: list[tuple[str, str]] = []
    try:
        participant.add_node(node := NodeName("/", "viewer"))
        driving = Driving(participant, node, lambda: 0)
        driving.on_refusal = lambda *said: told.append(said)
        with monkeypatch.context() as patch:
            patch.setattr(link, "run_driver", lambda *_: 1 / 0)
            driving.open()
            wait_until(lambda: told and driving._thread is not None and not driving._thread.is_alive())
        assert told[0][1].startswith("driving has ended, until a page is opened: ZeroDivisionError")
        driving.open()
        assert driving._thread is not None
        assert driving._thread.is_alive()
        driving.close()
        assert not driving._thread.is_alive()
    finally:
        participant.close()


@contextmanager
def driven_by_a_viewer(start_program: Callable[..., Program], robot: Robot) -> Iterator[tuple[Program, Page]]:
    view = start_program("tfloom", "view", "--no-open", "--port", "0")
    address = view.wait_for("Open http://127.0.0.1:").removeprefix("Open http://")
    with connect(f"ws://{address}api", max_size=None, proxy=None, ping_interval=None) as socket:
        page = Page(socket)
        drive(page, robot)
        yield view, page


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT", "SIGKILL", "SIGSTOP"])
def test_robot_is_stopped_however_its_viewer_ends_though_its_page_drives_on(
    robot: Robot, start_program: Callable[..., Program], name: str
) -> None:
    with driven_by_a_viewer(start_program, robot) as (view, page):
        is_over = threading.Event()

        def go_on() -> None:
            with suppress(ConnectionClosed, OSError):
                while not is_over.wait(0.02):
                    page.send(**MOVING)

        thread = threading.Thread(target=go_on)
        thread.start()
        try:
            wait_until(lambda: robot.is_moved, what="a drive that goes on")
            os.killpg(view.process.pid, getattr(signal, name))  # all of its group, as a terminal does
            wait_until(lambda: robot.is_stopped, what="the stop")
            count = len(robot.velocities)
            if name != "SIGSTOP":
                view.wait()
            time.sleep(0.2)
            assert robot.velocities[count:] == []
        finally:
            is_over.set()
            if name == "SIGSTOP":
                os.killpg(view.process.pid, signal.SIGKILL)
            thread.join(30.0)


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_driver_that_gets_a_signal_stops_the_robot_before_it_ends(
    robot: Robot, viewer: Viewer, page: Page, name: str
) -> None:
    drive(page, robot)
    process = viewer._live.driving._process._process
    process.send_signal(getattr(signal, name))
    wait_until(lambda: robot.is_stopped, what="the stop")
    assert process.wait(30.0) == 0
