"""Robots in a real browser: one maps its room and is driven by the page; one of a file is moved by sliders."""

from __future__ import annotations

import re
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.spun import SpunNode, spun
from tests.viewer.test_browser import TIMEOUT_S, Tab, browser, wait_until

from tfloom.interfaces.nav_msgs.msg import Odometry

__all__ = ["browser"]
# A browser that draws without a graphics card takes a core for itself: beside compilers it would take minutes.
pytestmark = [pytest.mark.slow, pytest.mark.timing]
POLE = """<robot name="pole"><link name="base"/><link name="pole"><visual><origin xyz="0 0 5"/>
<geometry><box size="0.6 0.6 10"/></geometry><material name="red"><color rgba="1 0 0 1"/></material></visual></link>
<joint name="tilt" type="revolute"><parent link="base"/><child link="pole"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>"""


def test_robot_maps_its_room_and_is_driven_by_keys(
    browser: Any, start_program: Callable[..., Any], tmp_path: Path
) -> None:
    demo = start_program("tfloom", "demo", "robot", "--seconds", "600", cwd=tmp_path)
    line = demo.wait_for("See it in a browser: http://127.0.0.1:")
    address = line.removeprefix("See it in a browser: ")
    tab = Tab(browser, address, "&camera=-4.7,-1.5,2.3&look_at=-0.4,1.0,0.1")
    wait_until(lambda: "tool" in tab.text("#rows"), what="the frames of the arm")
    for frame in ("map", "odom", "base_link", "laser"):
        assert frame in tab.text("#rows")
    tab.page.evaluate("send({ op: 'axes', length: 0.05 })")

    def shows(low: tuple[int, int, int], high: tuple[int, int, int], count: int) -> bool:
        pixels = tab.pixels()
        return int(((pixels >= low) & (pixels <= high)).all(axis=2).sum()) > count

    wait_until(lambda: shows((215, 215, 215), (245, 245, 245), 10_000), what="the free cells of the map")
    wait_until(lambda: shows((225, 40, 40), (255, 100, 100), 200), what="the scan")
    wait_until(lambda: shows((140, 50, 0), (255, 180, 100), 50), what="the robot")
    tab.keep("robot_in_a_room")

    domain_id = int(re.search(r"export ROS_DOMAIN_ID=(\d+)", demo.output)[1])
    with spun(SpunNode("observer", domain_id)) as observer:
        odometry = observer.received(Odometry, "/odom")

        def wait_for(condition: Callable[[float, float], bool], what: str, key: str = "") -> None:
            def is_met() -> bool:
                if (
                    key
                ):  # as a keyboard does: a page that didn't run for half a second takes each key for released
                    tab.page.keyboard.down(key)
                twist = odometry[-1].twist.twist if odometry else None
                return twist is not None and condition(twist.linear.x, twist.angular.z)

            observer.spin_until(is_met, what, TIMEOUT_S)

        tab.click("[data-tool=drive]")
        wait_until(lambda: "/cmd_vel" in tab.text("#drive-topic"), what="the robot's topic")
        # The tour turns by 1.2 rad/s at most.
        wait_for(
            lambda linear, angular: abs(linear) < 0.05 and angular > 1.5, "a turn by the key", "ArrowLeft"
        )
        tab.page.keyboard.up("ArrowLeft")
        wait_for(lambda linear, angular: linear == angular == 0.0, "its end")
        wait_for(lambda linear, _: linear > 0.3, "the tour that goes on")
    tab.page.close()
    assert tab.faults == []
    demo.signal(signal.SIGINT)
    assert demo.wait() == 0, demo.output
    errors = [
        float(re.search(rf"^{name} +[\d.]+ m +([\d.]+) m", demo.output, re.MULTILINE)[1])
        for name in ("odometry alone", "corrected")
    ]
    assert errors[1] < 0.15
    assert errors[1] < errors[0]


def test_robot_of_a_file_is_moved_by_sliders_and_clicked(
    browser: Any, start_program: Callable[..., Any], tmp_path: Path
) -> None:
    path = tmp_path / "pole.urdf"
    path.write_text(POLE)
    view = start_program("tfloom", "view", str(path), "--no-open", "--port", "0")
    tab = Tab(browser, view.wait_for("Open http://127.0.0.1:").removeprefix("Open "))
    wait_until(lambda: "tilt" in tab.text("#joint-rows"), what="the joint")
    assert "-1.000 rad, -57.3° to 1.000 rad, 57.3°" in tab.text("#joint-rows")
    assert not tab.page.is_visible("[data-tool=drive]")

    def red() -> Any:
        pixels = tab.pixels()
        return np.argwhere((pixels[:, :, 0] > 120) & (pixels[:, :, 1] < 90) & (pixels[:, :, 2] < 90))

    def is_whole() -> bool:
        places = red()
        return len(places) > 300 and np.ptp(places[:, 0]) > 100

    wait_until(is_whole, what="the robot, as large as the picture")
    upright = np.ptp(red()[:, 1])
    tab.page.fill(".joint-slider", "1")
    wait_until(lambda: np.ptp(red()[:, 1]) > upright + 30, what="the robot, tilted")
    assert tab.text(".joint-value") == "1.000 rad, 57.3°"
    tab.click("#pose-rest")
    wait_until(lambda: tab.text(".joint-value") == "0.000 rad, 0.0°", what="the position of rest")
    wait_until(lambda: np.ptp(red()[:, 1]) < upright + 10, what="the robot, upright")
    down, across = np.median(red(), axis=0)
    box = tab.page.query_selector("#scene").bounding_box()
    height, width = tab.pixels().shape[:2]
    tab.page.mouse.click(box["x"] + across / width * box["width"], box["y"] + down / height * box["height"])
    wait_until(
        lambda: "pole is on base by the revolute joint tilt" in tab.text("#selection-text"), what="the link"
    )
    assert tab.text("#selection-title") == "pole in base"
    tab.keep("robot_of_a_file")
    tab.page.close()
    assert tab.faults == []
    view.signal(signal.SIGINT)
    assert view.wait() == 0, view.output
