"""The scene's own controls in a real browser: names that don't overlap, what the camera sees, cameras, measuring."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.viewer.messages import header, marker, pose
from tests.viewer.test_browser import Tab, browser, wait_until

from tfloom.interfaces.geometry_msgs.msg import TransformStamped, Vector3
from tfloom.interfaces.std_msgs.msg import ColorRGBA
from tfloom.interfaces.visualization_msgs.msg import Marker, MarkerArray
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.viewer.camera import projected
from tfloom.viewer.layout.layout_file import read_layout
from tfloom.viewer.picking import frame_at
from tfloom.viewer.program import Viewer

__all__ = ["browser"]
# A browser that draws without a graphics card takes a core for itself: beside compilers it would take minutes.
pytestmark = [pytest.mark.slow, pytest.mark.timing]

WHITE = 200
"""Least brightness of a label's background."""


def transform(child: str, x: float, y: float = 0.0, z: float = 0.0) -> TransformStamped:
    message = TransformStamped(header=header("map", 1), child_frame_id=child)
    message.transform.translation.x, message.transform.translation.y, message.transform.translation.z = (
        x,
        y,
        z,
    )
    message.transform.rotation.w = 1.0
    return message


@pytest.fixture
def open_tab(browser: Any, viewer: Viewer, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[str], Tab]]:
    monkeypatch.setenv("TFLOOM_DPR", "1")
    tabs: list[Tab] = []

    def open_one(query: str = "") -> Tab:
        tabs.append(Tab(browser, viewer.pages.address, query))
        return tabs[-1]

    yield open_one
    for tab in tabs:
        tab.page.close()
        assert tab.faults == []


def boxes_of(pixels: np.ndarray) -> list[tuple[int, int, float]]:
    """Return the width and the height of each label, and which part of its box is filled."""
    from scipy import ndimage

    white = ndimage.binary_fill_holes(pixels.min(axis=2) > WHITE)  # the letters are dark
    labelled, count = ndimage.label(white)
    found = []
    for number, (rows, columns) in enumerate(ndimage.find_objects(labelled), 1):
        height, width = rows.stop - rows.start, columns.stop - columns.start
        if height > 6 and width > 6:
            found.append((width, height, float((labelled[rows, columns] == number).mean())))
    assert count >= len(found)
    return found


def wait_until_apart(tab: Tab, least: int) -> int:
    """Wait for a picture with so many labels at least of which none overlaps another; return how many it has.

    Each is a box of one line then. A picture that is drawn while the camera moves has them where they were chosen for.
    """
    found: list[tuple[int, int, float]] = []

    def are_apart() -> bool:
        found[:] = boxes_of(tab.pixels())
        return len(found) >= least and all(height <= 26 and filled > 0.8 for _, height, filled in found)

    try:
        wait_until(are_apart)
    except pytest.fail.Exception:
        tab.keep("names_not_apart")
        pytest.fail(f"{least} names are not apart: {found}")
    return len(found)


def scene_of(viewer: Viewer) -> Any:
    """Return what the one open page shows."""
    (own,) = viewer._scenes._pages.values()
    return own


def test_names_dont_overlap_and_those_of_hovered_and_selected_frames_are_shown(
    node: Node, viewer: Viewer, open_tab: Callable[..., Tab]
) -> None:
    broadcaster = StaticTransformBroadcaster(node)
    broadcaster.sendTransform(
        [
            transform(f"link_{column}_{row}", 0.1 * column, 0.1 * row)
            for column in range(8)
            for row in range(8)
        ]
    )
    tab = open_tab("&camera=-1.5,-2,1.5&look_at=0.35,0.35,0")
    tab.page.evaluate("send({ op: 'axes', length: 0.02 })")
    # Arrows are as light as names, and would join one to another.
    tab.page.evaluate("send({ op: 'set_frames', setting: 'show_arrows', value: false })")
    wait_until(lambda: len(viewer.view.poses.names) == 65, what="the frames")
    wait_until_at_rest(tab, viewer)
    few = wait_until_apart(tab, 2)
    tab.keep("names_from_afar")
    assert few < 20
    hidden, _ = unnamed_frame(viewer)
    tab.page.evaluate("frame => send({ op: 'select', frame })", hidden)
    wait_until(lambda: hidden in scene_of(viewer).labels, what="the name of a selected frame")
    wait_until_apart(tab, 1)
    tab.click("#unselect")
    wait_until(lambda: tab.page.is_hidden("#selection"), what="no selection")
    wait_until_at_rest(tab, viewer)
    hovered, spot = unnamed_frame(viewer)
    move_to(tab, *spot)
    wait_until(lambda: hovered in scene_of(viewer).labels, what="the name of a frame at the pointer")
    wait_until_apart(tab, 1)
    move_to(tab, 0.02, 0.02)
    tab.page.keyboard.press("f")
    near = wait_until_apart(tab, few + 1)
    assert near > few
    tab.keep("names_from_near")
    tab.page.evaluate("send({ op: 'names', on: false })")
    wait_until(lambda: boxes_of(tab.pixels()) == [], what="no names")
    tab.page.evaluate("send({ op: 'names', on: true })")
    wait_until_apart(tab, few + 1)


def wait_until_at_rest(tab: Tab, viewer: Viewer) -> None:
    """Wait until the viewer knows the size that the scene has on the page: a panel that opens or closes changes it."""
    (page,) = viewer._server.pages()

    def is_known() -> bool:
        width, height = tab.scene.evaluate("[innerWidth, innerHeight]")
        camera = viewer._server.camera(page)
        return (
            camera is not None
            and camera.aspect == pytest.approx(width / height, rel=0.01)
            and scene_of(viewer).size_px == (width, height)
        )

    wait_until(is_known, what="the size of the scene")


def unnamed_frame(viewer: Viewer) -> tuple[str, tuple[float, float]]:
    """Return a frame whose name is not shown, and where it is in the picture: of them that nearest to its middle."""
    (page,) = viewer._server.pages()
    own, poses, camera = scene_of(viewer), viewer.view.poses, viewer._server.camera(page)
    assert camera is not None
    seen = projected(camera, poses.positions)
    for index in np.argsort(np.hypot(seen[:, 0] - 0.5, seen[:, 1] - 0.5)).tolist():
        across, down, _ = seen[index].tolist()
        name = poses.names[index]
        if name not in own.labels and frame_at(camera, across, down, poses, own.size_px[1]) == name:
            return name, (across, down)
    raise AssertionError("all frames have their names")


def move_to(tab: Tab, across: float, down: float) -> tuple[float, float]:
    box = tab.page.locator("#scene").bounding_box()
    x, y = box["x"] + across * box["width"], box["y"] + down * box["height"]
    tab.page.mouse.move(x, y)
    return x, y


def red(tab: Tab) -> np.ndarray:
    """Return the rows and the columns of red pixels."""
    pixels = tab.pixels()
    return np.argwhere((pixels[:, :, 0] > 120) & (pixels[:, :, 0] > 1.6 * pixels[:, :, 1:].max(axis=2)))


def at_red(tab: Tab) -> tuple[float, float]:
    """Return where the middle of what is red is: across and down."""
    height, width = tab.pixels().shape[:2]
    down, across = np.median(red(tab), axis=0)
    return float(across) / width, float(down) / height


def test_double_click_fits_the_camera_to_what_is_there_and_f_to_all(
    node: Node, viewer: Viewer, open_tab: Callable[..., Tab]
) -> None:
    broadcaster = StaticTransformBroadcaster(node)
    broadcaster.sendTransform([transform("far", 12.0), transform("farther", 12.0, 12.0)])
    cube = node.create_publisher(
        Marker, "/cube", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    )
    cube.publish(marker(Marker.CUBE, pose=pose(6.0, 3.0), color=ColorRGBA(r=1.0, a=1.0)))
    tab = open_tab("&camera=-3,-4,4&look_at=4,2,0")
    wait_until(lambda: "/cube" in tab.text("#display-rows"), what="the topic")
    tab.page.evaluate("send({ op: 'display', topic: '/cube', on: true })")
    tab.page.evaluate("send({ op: 'axes', length: 0.1 })")
    wait_until(lambda: len(red(tab)) > 20, what="the cube")
    small = len(red(tab))
    x, y = move_to(tab, *at_red(tab))
    tab.page.mouse.dblclick(x, y)
    wait_until(lambda: len(red(tab)) > 5 * small, what="the cube from near")
    tab.keep("double_click")
    assert np.ptp(red(tab)[:, 0]) < 0.9 * tab.pixels().shape[0]
    assert looks_at(viewer) == pytest.approx([6.0, 3.0, 0.0], abs=0.05)
    tab.page.keyboard.press("f")
    wait_until(lambda: looks_at(viewer) == pytest.approx([6.0, 6.0, 0.0], abs=0.3), what="all")
    wait_until(lambda: 0 < len(red(tab)) < 5 * small, what="the cube among all")
    x, y = move_to(tab, 0.5, 0.02)
    tab.page.mouse.dblclick(x, y)
    wait_until(lambda: "there is nothing at this place" in tab.text("#message"), what="why nothing follows")


def looks_at(viewer: Viewer) -> list[float]:
    (page,) = viewer._server.pages()
    view_point = viewer._server.view_point(page)
    assert view_point is not None
    return list(view_point.look_at)


class Car:
    """A frame `base` with a red cube, which a test moves, beside a green one that stands at the origin of the map."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._broadcaster = TransformBroadcaster(node)
        self._cubes = node.create_publisher(
            MarkerArray, "/cubes", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        )
        size = Vector3(x=1.0, y=1.0, z=1.0)
        car = marker(Marker.CUBE, 1, color=ColorRGBA(r=1.0, a=1.0), scale=size, frame_locked=True)
        car.header.frame_id, car.header.stamp.sec = "base", 0
        still = marker(Marker.CUBE, 2, color=ColorRGBA(g=1.0, a=1.0), scale=size)
        self._cubes.publish(MarkerArray(markers=[car, still]))

    def move(self, x: float, y: float, yaw_rad: float = 0.0) -> None:
        made = transform("base", x, y)
        made.transform.rotation.z, made.transform.rotation.w = (
            math.sin(yaw_rad / 2.0),
            math.cos(yaw_rad / 2.0),
        )
        made.header.stamp = self._node.get_clock().now().to_msg()
        self._broadcaster.sendTransform(made)

    def show(self, tab: Tab) -> None:
        """Show the cubes on a page."""
        wait_until(lambda: self.move(0.0, 4.0) or "/cubes" in tab.text("#display-rows"), what="the topic")
        tab.page.evaluate("send({ op: 'display', topic: '/cubes', on: true })")
        tab.page.evaluate("send({ op: 'names', on: false })")
        tab.page.evaluate("frame => send({ op: 'select', frame })", "base")
        wait_until(
            lambda: self.move(0.0, 4.0) or (len(red(tab)) > 20 and len(green(tab)) > 20), what="the cubes"
        )
        wait_until(lambda: not tab.page.evaluate("document.querySelector('#selection').hidden"), what="base")


def green(tab: Tab) -> np.ndarray:
    pixels = tab.pixels()
    return np.argwhere((pixels[:, :, 1] > 120) & (pixels[:, :, 1] > 1.15 * pixels[:, :, [0, 2]].max(axis=2)))


def moved_px(tab: Tab, before: tuple[float, float]) -> float:
    height, width = tab.pixels().shape[:2]
    across, down = at_red(tab)
    return math.hypot((across - before[0]) * width, (down - before[1]) * height)


def test_camera_follows_a_frame_by_a_key_and_stays_when_that_is_gone(
    node: Node, viewer: Viewer, open_tab: Callable[..., Tab]
) -> None:
    car, tab = Car(node), open_tab("&camera=-10,-8,9&look_at=0,2,0")
    car.show(tab)
    still = np.median(green(tab), axis=0)
    tab.page.keyboard.press("l")
    wait_until(lambda: tab.text("#camera-state") == "the camera follows base", what="the camera")
    before = at_red(tab)
    wait_until(
        lambda: car.move(3.0, 6.0) or (looks_at(viewer)[0] > 2.9 and len(green(tab)) > 5), what="the way"
    )
    wait_until(lambda: moved_px(tab, before) < 12.0, what="the car where it was")
    assert np.abs(np.median(green(tab), axis=0) - still).max() > 10.0
    tab.keep("camera_follows")
    tab.page.evaluate("send({ op: 'fixed_frame', frame: 'elsewhere' })")
    gone = "base is gone: the camera stays where it is"
    wait_until(lambda: tab.text("#camera-state") == gone == tab.text("#message"), what="that it is gone")
    tab.page.evaluate("send({ op: 'fixed_frame', frame: 'map' })")
    wait_until(lambda: tab.text("#camera-state") == "the camera follows base", what="that it is back")
    tab.page.keyboard.press("l")
    wait_until(lambda: scene_of(viewer).following.turns, what="its yaw")
    wait_until(lambda: moved_px(tab, before) < 12.0, what="the car where it was")
    start = viewer._server.view_point(viewer._server.pages()[0])
    wait_until(lambda: car.move(3.0, 6.0, 1.5) or is_turned(viewer, start, 1.5), what="the turn")
    wait_until(lambda: moved_px(tab, before) < 12.0, what="the car where it was, turned with it")


def is_turned(viewer: Viewer, start: Any, angle_rad: float) -> bool:
    now = viewer._server.view_point(viewer._server.pages()[0])
    assert now is not None
    first, second = (
        math.atan2(view.look_at[1] - view.position[1], view.look_at[0] - view.position[0])
        for view in (start, now)
    )
    return abs(math.remainder(second - first - angle_rad, 2.0 * math.pi)) < 0.05


def test_camera_from_above_has_no_perspective_and_that_of_a_first_person_is_in_its_frame(
    node: Node, viewer: Viewer, open_tab: Callable[..., Tab]
) -> None:
    car, tab = Car(node), open_tab("&camera=-1,-9,9&look_at=0,2,0")
    car.show(tab)
    tab.page.keyboard.press("t")

    def is_above() -> bool:
        """Whether both cubes are squares of one size, which only a view straight from above shows."""
        cubes = [red(tab), green(tab)]
        if min(map(len, cubes)) < 100:
            return False
        sides = [float(side) for cube in cubes for side in np.ptp(cube, axis=0)]
        return max(sides) - min(sides) <= 3.0

    wait_until(is_above, what="squares of one size")
    tab.keep("camera_from_above")
    tab.page.keyboard.press("i")
    wait_until(lambda: tab.text("#camera-state") == "the camera is in base", what="the camera in base")
    # Before the car is nothing; when it turns to the other cube, that is in the middle of the picture.
    wait_until(lambda: car.move(0.0, 4.0, -math.pi / 2.0) or len(green(tab)) > 500, what="the other cube")
    across = np.median(green(tab), axis=0)[1] / tab.pixels().shape[1]
    assert across == pytest.approx(0.5, abs=0.05)
    tab.keep("camera_of_a_first_person")
    tab.page.keyboard.press("o")
    wait_until(lambda: scene_of(viewer).following.is_free, what="an orbit")


def test_saved_view_is_shown_again_and_is_in_the_layout(
    node: Node, viewer: Viewer, open_tab: Callable[..., Tab], tmp_path: Path
) -> None:
    car, tab = Car(node), open_tab("&camera=-4,-6,6&look_at=0,2,0")
    car.show(tab)
    first, before = viewer._server.view_point(viewer._server.pages()[0]), at_red(tab)
    assert first is not None
    tab.page.keyboard.press("b")
    tab.page.fill("#view-name", "door")
    tab.click("#view-save")
    wait_until(lambda: "door" in tab.text("#view-rows"), what="the view")
    tab.keep("saved_view")
    tab.page.evaluate("document.activeElement.blur()")
    tab.page.keyboard.press("Escape")
    tab.page.keyboard.press("t")
    wait_until(lambda: np.abs(np.subtract(at_red(tab), before)).max() > 0.04, what="another view")
    viewer.layout_path = tmp_path / "view.yaml"
    tab.click("#save-layout")
    wait_until(viewer.layout_path.exists, what="the file")
    layout, unknown = read_layout(viewer.layout_path)
    assert (unknown, layout.camera_kind, [view.name for view in layout.views]) == ([], "top", ["door"])
    viewer.view.views.clear()
    wait_until(lambda: tab.page.evaluate("state.views.length") == 0, what="no views")
    viewer.apply(layout)
    wait_until(lambda: tab.page.evaluate("state.views.length") == 1, what="those of the layout")
    tab.page.keyboard.press("b")
    wait_until(lambda: "door" in tab.text("#view-rows"), what="the view of the layout")
    tab.page.evaluate("document.querySelector('#view-rows .view span').click()")
    tab.page.keyboard.press("b")
    wait_until(
        lambda: len(red(tab)) and np.abs(np.subtract(at_red(tab), before)).max() < 0.03, what="the first view"
    )
    again = viewer._server.view_point(viewer._server.pages()[0])
    assert again is not None
    assert (*again.position, *again.look_at) == pytest.approx((*first.position, *first.look_at), abs=0.01)


def click_at(tab: Tab, across: float, down: float) -> None:
    tab.page.mouse.click(*move_to(tab, across, down))


def test_measure_gives_a_known_distance_by_a_key_and_escape_clears_it(
    node: Node, viewer: Viewer, open_tab: Callable[..., Tab]
) -> None:
    broadcaster = StaticTransformBroadcaster(node)
    broadcaster.sendTransform([transform("left", -2.0, 1.0), transform("right", 2.0, 4.0, 1.0)])
    tab = open_tab("&camera=0,-8,7&look_at=0,2,0")
    tab.page.evaluate("send({ op: 'names', on: false })")
    wait_until(lambda: len(viewer.view.poses.names) == 3, what="the frames")

    def cyan() -> int:
        pixels = tab.pixels()
        return int(((pixels[:, :, 0] < 140) & (pixels[:, :, 1] > 190) & (pixels[:, :, 2] > 210)).sum())

    def place(name: str) -> list[float]:
        camera = viewer._server.camera(viewer._server.pages()[0])
        assert camera is not None
        found: list[float] = projected(
            camera, viewer.view.poses.positions[[viewer.view.poses.index_of(name)]]
        )[0].tolist()
        return found[:2]

    before, said = cyan(), "5.099 m from left to right: dx 4.000, dy 3.000, dz 1.000 m in map"
    for _ in range(2):
        tab.page.keyboard.press("r")
        wait_until(lambda: tab.page.is_visible("#pad"), what="the tool")
        click_at(tab, *place("left"))
        wait_until(lambda: "from left" in tab.text("#message"), what="the first place")
        click_at(tab, *place("right"))
        wait_until(lambda: tab.text("#message") == said, what="the distance")
        wait_until(lambda: cyan() > before + 40, what="the ends and the line")
        assert len(boxes_of(tab.pixels())) == 1  # the distance in the scene
        tab.keep("measure")
        tab.page.keyboard.press("Escape")
        wait_until(lambda: cyan() <= before + 5 and tab.text("#message") == "", what="nothing")
        assert tab.page.is_hidden("#pad")
    tab.page.keyboard.press("?")
    assert "measure" in tab.text("#key-rows")


def test_focus_on_a_click_sets_what_the_camera_turns_about(
    node: Node, viewer: Viewer, open_tab: Callable[..., Tab]
) -> None:
    car, tab = Car(node), open_tab("&camera=-4,-8,6&look_at=0,0,0")
    car.show(tab)
    tab.page.keyboard.press("k")
    wait_until(lambda: tab.page.is_visible("#pad"), what="the tool")
    click_at(tab, *at_red(tab))
    wait_until(lambda: "the camera turns about" in tab.text("#message"), what="the camera")
    wait_until(lambda: np.abs(np.subtract(at_red(tab), 0.5)).max() < 0.06, what="the car in the middle")
    assert looks_at(viewer) == pytest.approx([0.0, 4.0, 0.0], abs=0.8)
    assert tab.page.is_hidden("#pad")
    # The car stays there when the user turns the camera.
    x, y = move_to(tab, 0.5, 0.8)
    tab.page.mouse.down()
    tab.page.mouse.move(x + 80, y, steps=5)
    tab.page.mouse.up()
    view_point = viewer._server.view_point(viewer._server.pages()[0])
    wait_until(lambda: viewer._server.view_point(viewer._server.pages()[0]) == view_point, what="rest")
    assert np.abs(np.subtract(at_red(tab), 0.5)).max() < 0.06
    tab.keep("focus")
