"""Settings of displays in a real browser: their controls, and what they change of the pixels."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.conftest import Program
from tests.spun import SpunNode, spun
from tests.viewer.messages import cloud, header, marker, pose
from tests.viewer.test_browser import Tab, browser, wait_until

from tfloom.interfaces.geometry_msgs.msg import Point, TransformStamped, Twist, TwistStamped, Vector3
from tfloom.interfaces.nav_msgs.msg import GridCells
from tfloom.interfaces.sensor_msgs.msg import PointCloud2
from tfloom.interfaces.std_msgs.msg import ColorRGBA
from tfloom.interfaces.visualization_msgs.msg import Marker, MarkerArray
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.viewer.layout.layout_file import read_layout

__all__ = ["browser"]
# A browser that draws without a graphics card takes a core for itself: beside compilers it would take minutes.
pytestmark = [pytest.mark.slow, pytest.mark.timing]
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
WALL = np.zeros(3600, [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("intensity", "<f4")])
WALL["y"], WALL["z"] = (part.ravel() for part in np.meshgrid(np.linspace(-2, 2, 60), np.linspace(0, 3, 60)))
"""A wall of points in the plane x = 0, which the camera sees from before it."""
TWIST = Twist(linear=Vector3(y=1.0), angular=Vector3(z=0.6))
CUBES = {"left": (-2.0, (0.0, 1.0, 0.0)), "right": (2.0, (1.0, 0.0, 1.0))}
"""Place and colour of the marker of each namespace."""


@pytest.fixture(scope="module")
def address(module_domain_id: int, start_module_program: Callable[..., Program]) -> str:
    view = start_module_program("tfloom", "view", "--no-open", "--port", "0", "--fixed-frame", "map")
    return view.wait_for("Open http://127.0.0.1:").removeprefix("Open ")


@pytest.fixture(scope="module")
def node(module_domain_id: int) -> Iterator[SpunNode]:
    with spun(SpunNode("sensors", module_domain_id)) as made:
        cubes = [
            marker(
                Marker.CUBE,
                number,
                ns=name,
                pose=pose(0.5, y, 1.5),
                scale=Vector3(x=1.0, y=1.0, z=1.0),
                color=ColorRGBA(r=color[0], g=color[1], b=color[2], a=1.0),
            )
            for number, (name, (y, color)) in enumerate(CUBES.items())
        ]
        cells = GridCells(header=header(), cell_width=0.4, cell_height=0.4)
        cells.cells = [Point(x=float(x), y=0.5 * y) for x in range(3) for y in range(-2, 3)]
        for topic, message in {
            "/wall": cloud(WALL),
            "/cubes": MarkerArray(markers=cubes),
            "/twist": TwistStamped(header=header(), twist=TWIST),
            "/cells": cells,
        }.items():
            made.node.create_publisher(type(message), topic, LATCHED).publish(message)
        yield made


@pytest.fixture
def tab(browser: Any, address: str, node: SpunNode) -> Iterator[Tab]:
    made = Tab(browser, address, "&camera=6,0,2&look_at=0,0,1.4")
    made.click("[data-panel=displays]")
    yield made
    made.page.evaluate(
        "state.displays.filter(row => row.on).forEach(row => send({op: 'display', topic: row.topic, on: false}))"
    )
    wait_until(lambda: made.page.evaluate("state.displays.every(row => !row.on)"), what="nothing shown")
    made.page.close()
    assert made.faults == []


def show(tab: Tab, topic: str) -> None:
    """Switch a display on by a click, and open its settings by another."""
    wait_until(lambda: tab.page.locator(f'[data-topic="{topic}"]').count(), what=f"the row of {topic}")
    tab.click(f'[data-topic="{topic}"] input')
    open_settings(tab, topic)


def open_settings(tab: Tab, name: str) -> None:
    row = f'[data-topic="{name}"]'
    wait_until(lambda: tab.page.locator(f"{row} .more:not([hidden])").count(), what=f"the settings of {name}")
    tab.click(f"{row} .more")


def set_to(tab: Tab, name: str, setting: str, value: object) -> None:
    """Set a control as its user does."""
    tab.page.evaluate(
        """([name, setting, value]) => {
          const line = document.querySelector(`[data-topic="${name}"] [data-setting="${setting}"]`);
          const control = line.querySelector("input, select");
          if (control.type === "checkbox") control.checked = value; else control.value = value;
          control.dispatchEvent(new Event("change"));
        }""",
        [name, setting, value],
    )


def like(tab: Tab, color: tuple[int, int, int], most: int = 60) -> int:
    """Return how many pixels are about of a colour."""
    return int((np.abs(tab.pixels() - np.array(color)).max(axis=2) < most).sum())


def test_cloud_in_a_frame_that_nobody_publishes_says_so_in_its_row_until_it_is(
    tab: Tab, node: SpunNode
) -> None:
    lost = node.node.create_publisher(PointCloud2, "/lost", LATCHED)
    lost.publish(cloud(WALL, "nowhere"))
    wait_until(lambda: tab.page.locator('[data-topic="/lost"]').count(), what="the row")
    tab.click('[data-topic="/lost"] input')
    sentence = "the cloud is in the frame `nowhere`, which nobody publishes"
    wait_until(lambda: tab.text('[data-topic="/lost"] .status') == sentence, what="the sentence")
    assert tab.page.is_visible('[data-topic="/lost"] .status')
    tab.keep("cloud_in_nowhere")
    before = tab.pixels()
    frames = StaticTransformBroadcaster(node.node)
    there = TransformStamped(header=header("map"), child_frame_id="nowhere")
    there.transform.rotation.w = 1.0
    frames.sendTransform(there)
    wait_until(lambda: tab.text('[data-topic="/lost"] .status') == "", what="its end")
    wait_until(lambda: (np.abs(tab.pixels() - before).max(axis=2) > 60).sum() > 500, what="the cloud")
    tab.keep("cloud_in_a_frame")
    node.node.destroy_publisher(lost)
    tab.click('[data-topic="/lost"] input')
    wait_until(lambda: not tab.page.locator('[data-topic="/lost"]').count(), what="the end of the row")
    assert not tab.page.evaluate("displays.has('/lost')"), (
        "the page keeps what it has of each topic that ever was"
    )


def test_cloud_is_coloured_by_an_axis_by_one_colour_and_made_transparent(tab: Tab) -> None:
    show(tab, "/wall")
    set_to(tab, "/wall", "style", "spheres")
    set_to(tab, "/wall", "size", 0.08)
    set_to(tab, "/wall", "color_by", "axis")
    set_to(tab, "/wall", "axis", "y")
    wait_until(lambda: like(tab, (255, 0, 0)) > 100 < like(tab, (204, 0, 255)), what="a rainbow along y")

    def sides() -> tuple[float, float]:
        reds = np.argwhere(np.abs(tab.pixels() - np.array((255, 0, 0))).max(axis=2) < 60)
        return float(reds[:, 1].std()), float(reds[:, 0].std())

    across, down = sides()
    assert down > across  # a column of the least y
    tab.keep("cloud_by_y")
    set_to(tab, "/wall", "axis", "z")
    wait_until(lambda: sides()[0] > sides()[1], what="a row of the least z")
    set_to(tab, "/wall", "axis_auto_range", False)
    set_to(tab, "/wall", "axis_low", 2.9)
    set_to(tab, "/wall", "axis_high", 100)
    wait_until(lambda: like(tab, (204, 0, 255)) == 0, what="a range beyond the wall")
    set_to(tab, "/wall", "color_by", "flat")
    set_to(tab, "/wall", "color", "#00ff00")
    wait_until(lambda: like(tab, (0, 255, 0)) > 3000, what="one colour")
    set_to(tab, "/wall", "opacity", 0.3)
    set_to(tab, "/wall", "style", "squares")
    wait_until(lambda: like(tab, (0, 255, 0)) == 0 < like(tab, (20, 90, 20), 40), what="a transparent wall")
    tab.keep("cloud_transparent")


def test_namespace_is_hidden_and_shown_again_by_a_click(tab: Tab) -> None:
    def greens() -> int:
        return int((np.ptp(tab.pixels(), axis=2) > 60)[:, :].sum())

    show(tab, "/cubes")
    wait_until(lambda: "right" in tab.text('[data-topic="/cubes"] .settings'), what="the namespaces")
    wait_until(lambda: greens() > 4000, what="two cubes")
    both = greens()
    tab.click('[data-topic="/cubes"] [data-part="left"] input')
    wait_until(lambda: 0.25 * both < greens() < 0.75 * both, what="one cube")
    tab.keep("namespace_hidden")
    assert tab.page.evaluate(
        "state.displays.find(row => row.topic === '/cubes').values.hidden_namespaces"
    ) == ["left"]
    tab.click('[data-topic="/cubes"] [data-part="left"] input')
    wait_until(lambda: greens() > 0.9 * both, what="both cubes again")


def test_depth_of_a_queue_is_what_the_page_sets_and_as_usual_when_it_is_empty(
    tab: Tab, tmp_path: Path
) -> None:
    show(tab, "/wall")

    def depth() -> Any:
        """Return what the server has, which it tells the page."""
        return tab.page.evaluate("state.displays.find(row => row.topic === '/wall').values.depth")

    def shown() -> Any:
        return tab.page.evaluate(
            """document.querySelector('[data-topic="/wall"] [data-setting="depth"] input').value"""
        )

    def saved() -> Any:
        with tab.page.expect_download() as download:
            tab.click("#save-layout")
        path = tmp_path / "saved.yaml"
        download.value.save_as(path)
        (display,) = read_layout(path)[0].displays
        return dict(display.settings).get("depth")

    assert (depth(), shown()) == (0, "0")
    set_to(tab, "/wall", "depth", 37)
    wait_until(lambda: (depth(), shown()) == (37, "37"), what="the depth at the server")
    assert saved() == 37
    for wrong in (-1, 10_001, 2.5):
        set_to(tab, "/wall", "depth", wrong)
        wait_until(lambda: shown() == "37", what=f"the depth in place of {wrong}")
        assert depth() == 37
    set_to(tab, "/wall", "depth", "")
    wait_until(lambda: (depth(), shown()) == (0, "0"), what="the usual depth")
    assert saved() is None


def test_topic_is_shown_twice_and_saved_as_a_file_of_rviz(tab: Tab, tmp_path: Path) -> None:
    show(tab, "/wall")
    set_to(tab, "/wall", "color_by", "flat")
    set_to(tab, "/wall", "color", "#ff0000")
    set_to(tab, "/wall", "size_px", 1)
    wait_until(lambda: 0 < like(tab, (255, 0, 0)) < 8000, what="small red points")
    small = like(tab, (255, 0, 0))
    set_to(tab, "/wall", "size_px", 6)
    wait_until(lambda: like(tab, (255, 0, 0)) > 2 * small, what="large red points")
    tab.page.evaluate(
        """() => { const again = document.querySelector('[data-topic="/wall"] .again');
        again.value = "PointCloud2"; again.dispatchEvent(new Event("change")); }"""
    )
    open_settings(tab, "/wall #2")
    set_to(tab, "/wall #2", "color_by", "flat")
    set_to(tab, "/wall #2", "color", "#0000ff")
    set_to(tab, "/wall #2", "style", "boxes")
    wait_until(lambda: like(tab, (0, 0, 255), 120) > 50 < like(tab, (255, 0, 0)), what="both")
    tab.keep("topic_twice")
    with tab.page.expect_download() as download:
        tab.click("#save-rviz")
    path = tmp_path / "saved.rviz"
    download.value.save_as(path)
    layout, unknown = read_layout(path)
    assert unknown == []
    assert [(shown.topic, dict(shown.settings).get("color")) for shown in layout.displays] == [
        ("/wall", (255, 0, 0)),
        ("/wall", (0, 0, 255)),
    ]
    assert layout.camera is not None
    assert layout.camera.position == pytest.approx((6.0, 0.0, 2.0), abs=0.01)


def test_displays_without_a_topic_and_arrows_are_drawn(tab: Tab) -> None:
    tab.page.evaluate("send({ op: 'names', on: false })")  # they would cover the cells
    for kind in ("Axes", "Grid"):
        tab.page.evaluate(
            """kind => { const add = document.getElementById("add-plain");
            add.value = kind; add.dispatchEvent(new Event("change")); }""",
            kind,
        )
    open_settings(tab, "Axes")
    set_to(tab, "Axes", "length", 2)
    wait_until(lambda: like(tab, (0, 0, 255), 120) > 300, what="the z axis")
    open_settings(tab, "Grid")
    set_to(tab, "Grid", "color", "#ffff00")
    set_to(tab, "Grid", "opacity", 1)
    wait_until(lambda: like(tab, (255, 255, 0), 100) > 300, what="the grid")
    show(tab, "/cells")
    wait_until(lambda: like(tab, (25, 255, 0), 100) > 300, what="the cells")
    show(tab, "/twist")
    wait_until(lambda: like(tab, (204, 51, 51), 70) > 100, what="the linear velocity")
    wait_until(lambda: like(tab, (204, 204, 51), 70) > 100, what="the angular velocity")
    tab.keep("plain_and_twist")
    tab.click("[data-panel=frames]")
    tab.click("#frames-more")
    wait_until(lambda: "timeout s" in tab.text("#frame-settings"), what="the settings of frames")
    tab.keep("frame_settings")
