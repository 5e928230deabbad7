"""Robots in a real browser: one maps its room and is driven by the page; one is of a file; points of measurements."""

from __future__ import annotations

import re
import signal
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.conftest import Program
from tests.spun import SpunNode, spun
from tests.tf2_tools.recordings import START_NS, transform
from tests.viewer.messages import cloud
from tests.viewer.test_browser import TIMEOUT_S, Tab, browser, wait_until

from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.interfaces.nav_msgs.msg import Odometry
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr

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


SIGNS = """<robot name="signs"><link name="base">
<visual><origin xyz="0 0 1"/><geometry><mesh filename="quad.obj"/></geometry>
<material name="two"><texture filename="two.png"/></material></visual>
<visual><origin xyz="0 3 1"/><geometry><mesh filename="cube.stl" scale="2 2 2"/></geometry>
<material name="one"><texture filename="one.png"/></material></visual>
<visual><origin xyz="0 -3 1"/><geometry><box size="2 2 2"/></geometry>
<material name="grey"><color rgba="0.25 0.25 0.25 1"/></material></visual>
<visual><origin xyz="0 -6 1"/><geometry><mesh filename="cube.stl" scale="2 2 2"/></geometry>
<material name="grey"/></visual></link></robot>"""
QUAD = """v 0 -1 -1
v 0 1 -1
v 0 1 1
v 0 -1 1
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3
f 1/1 3/3 4/4
"""
"""A square that is seen from before it, along -x."""


def test_texture_is_seen_on_a_mesh_that_has_coordinates_and_its_colour_on_one_without(
    browser: Any, start_program: Callable[..., Any], tmp_path: Path
) -> None:
    trimesh = pytest.importorskip("trimesh")
    image = pytest.importorskip("PIL.Image")
    (tmp_path / "signs.urdf").write_text(SIGNS)
    (tmp_path / "quad.obj").write_text(QUAD)
    trimesh.creation.box((1, 1, 1)).export(tmp_path / "cube.stl")
    two = np.zeros((64, 64, 3), np.uint8)
    two[:, :32], two[:, 32:] = (255, 0, 0), (0, 255, 0)  # along u, so along y
    image.fromarray(two).save(tmp_path / "two.png")
    image.new("RGB", (8, 8), (0, 0, 255)).save(tmp_path / "one.png")
    view = start_program("tfloom", "view", str(tmp_path / "signs.urdf"), "--no-open", "--port", "0")
    address = view.wait_for("Open http://127.0.0.1:").removeprefix("Open ")
    tab = Tab(browser, address, "&camera=9,1.5,1&look_at=0,1.5,1")

    def places(channel: int) -> Any:
        pixels = tab.pixels()
        others = np.delete(pixels, channel, axis=2).max(axis=2)
        return np.argwhere((pixels[:, :, channel] > 90) & (pixels[:, :, channel] > 1.4 * others))

    wait_until(lambda: all(len(places(channel)) > 300 for channel in range(3)), what="the three colours")
    tab.keep("textures")
    across = [float(np.median(places(channel)[:, 1])) for channel in range(3)]
    assert across[0] < across[1] < across[2]  # red, green and the blue cube, as y grows to the right
    height, width = tab.pixels().shape[:2]
    box, mesh = (tab.pixels()[height // 2, int(part * width)] for part in (0.235, 0.058))
    assert 30 < box.max() < 90
    assert np.abs(box - mesh).max() < 12, "a mesh has the colour of a box of the same material"
    tab.page.close()
    assert tab.faults == []
    view.signal(signal.SIGINT)
    assert view.wait() == 0, view.output


def test_point_is_as_wide_on_the_screen_near_and_far(
    browser: Any, start_program: Callable[..., Program], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TFLOOM_DPR", "1")
    point = np.zeros(1, [("x", "f4"), ("y", "f4"), ("z", "f4"), ("rgb", "u4")])
    point["z"], point["rgb"] = 0.5, 0xFF00FF
    seen = cloud(point)
    seen.header.stamp.sec = START_NS // 10**9
    with closing(BagWriter(tmp_path / "bag")) as writer:
        tf = writer.add_topic(Topic("/tf", "tf2_msgs/msg/TFMessage"))
        points = writer.add_topic(Topic("/points", "sensor_msgs/msg/PointCloud2"))
        for stamp_ns in (START_NS, START_NS + 10**9):
            moved = TFMessage(transforms=[transform("map", "base", stamp_ns, (0.0, 0.0, 0.0))])
            writer.push(tf, cdr.encode(moved), stamp_ns, stamp_ns)
        writer.push(points, cdr.encode(seen), START_NS, START_NS)
    view = start_program("tfloom", "view", tmp_path / "bag", "--no-open", "--port", "0", "-d", "/points")
    address = view.wait_for("Open http://127.0.0.1:").removeprefix("Open ")
    for distance_m in (2.0, 20.0, 200.0):
        tab = Tab(browser, address, f"&camera={-distance_m},0,0.5&look_at=0,0,0.5")
        tab.page.evaluate("send({ op: 'axes', length: 0.001 })")
        tab.page.evaluate("send({ op: 'names', on: false })")

        def width_px(tab: Tab = tab) -> int:
            pixels = tab.pixels()
            is_point = (pixels[..., 0] > 150) & (pixels[..., 1] < 110) & (pixels[..., 2] > 150)
            columns = np.flatnonzero(is_point.any(axis=0))
            return int(np.ptp(columns)) + 1 if len(columns) else 0

        wait_until(width_px, what=f"the point, from {distance_m} m")
        tab.keep(f"point_from_{distance_m:g}_m")
        assert 2 <= width_px() <= 6
        tab.page.set_viewport_size({"width": 1000, "height": 960})
        tab.page.wait_for_timeout(500)
        wait_until(width_px, what=f"the point in a higher window, from {distance_m} m")
        assert 2 <= width_px() <= 6
        assert tab.faults == []
        tab.page.close()
