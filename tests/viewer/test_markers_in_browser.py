"""Interactive markers in a real browser: dragged by the mouse, clicked for a menu, let go by a page that closes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from tests.conftest import Program
from tests.viewer.conftest import running_node, spinning
from tests.viewer.messages import marker
from tests.viewer.test_browser import Tab, browser, wait_until
from tests.viewer.test_interactive_markers import HALF, TOPIC, Control, Feedback, Things, control, thing

from tfloom.interfaces.geometry_msgs.msg import Quaternion, Vector3
from tfloom.interfaces.std_msgs.msg import ColorRGBA, Header
from tfloom.interfaces.visualization_msgs.msg import Marker
from tfloom_sensing.menu_handler import MenuHandler

__all__ = ["browser"]
# A browser that draws without a graphics card takes a core for itself: beside compilers it would take minutes.
pytestmark = [pytest.mark.slow, pytest.mark.timing]


def cube(**color: float) -> Marker:
    return marker(
        Marker.CUBE,
        header=Header(),
        scale=Vector3(x=0.6, y=0.6, z=0.6),
        color=ColorRGBA(a=1.0, **color),
    )


@pytest.fixture(scope="module")
def things(module_domain_id: int) -> Iterator[Things]:
    with running_node(module_domain_id, "server") as node, spinning(node):
        made = Things(node)
        along_y = Quaternion(z=HALF, w=HALF)
        slider = thing("slider", 0.0, control(Control.MOVE_AXIS, "along", orientation=along_y))
        slider.description = "along y"
        box = thing("box", 0.0, control(Control.MENU, "ask", cube(b=1.0)), description="A box")
        box.pose.position.z = 1.6
        puck = thing("puck", 0.0, control(Control.MOVE_PLANE, "across", cube(r=1.0, g=1.0)))
        puck.pose.position.y = -1.2
        made.insert(slider, box, puck)
        yield made
        made.server.shutdown()


@pytest.fixture(scope="module")
def address(module_domain_id: int, start_module_program: Callable[..., Program]) -> str:
    view = start_module_program("tfloom", "view", "--no-open", "--port", "0", "--fixed-frame", "map")
    return view.wait_for("Open http://127.0.0.1:").removeprefix("Open ")


@pytest.fixture
def tab(browser: Any, address: str, things: Things) -> Iterator[Tab]:
    things.heard.clear()
    made = Tab(browser, address, "&camera=4,0,1&look_at=0,0,0.8")
    made.click("[data-panel=displays]")
    wait_until(lambda: made.page.locator(f'[data-topic="{TOPIC}"]').count(), what="the row")
    if not made.page.is_checked(f'[data-topic="{TOPIC}"] input'):
        made.click(f'[data-topic="{TOPIC}"] input')
    yield made
    if not made.page.is_closed():
        made.page.close()
    assert made.faults == []


def spot(tab: Tab, is_it: Callable[[np.ndarray], np.ndarray], *, at_end: bool = False) -> tuple[float, float]:
    """Return where on the page pixels of a kind are: in their middle, or at their right end."""
    found = np.empty((0, 2))

    def look() -> bool:
        nonlocal found
        found = np.argwhere(is_it(tab.pixels()))
        return len(found) > 30

    wait_until(look, what="the pixels")
    if at_end:
        found = found[found[:, 1] >= np.quantile(found[:, 1], 0.9)]
    down, across = np.median(found, axis=0)
    box = tab.page.evaluate(
        "(box => [box.left, box.top])(document.getElementById('scene').getBoundingClientRect())"
    )
    return float(box[0] + across), float(box[1] + down)


def is_red(pixels: np.ndarray) -> np.ndarray:
    """Return which pixels are of the gizmo's axis x."""
    return (pixels[..., 0] > 150) & (pixels[..., 1] < 90) & (pixels[..., 2] < 140)


def is_blue(pixels: np.ndarray) -> np.ndarray:
    return (pixels[..., 2] > 100) & (pixels[..., 0] < 60) & (pixels[..., 1] < 60)


def is_yellow(pixels: np.ndarray) -> np.ndarray:
    return (pixels[..., 0] > 150) & (pixels[..., 1] > 150) & (pixels[..., 2] < 130)


def grab(tab: Tab, things: Things) -> tuple[float, float]:
    """Press the mouse on the arrow of the slider, and return where."""
    x, y = spot(tab, is_red, at_end=True)
    tab.page.mouse.move(x, y)
    tab.page.wait_for_timeout(500)  # the scene notes what is under the pointer when it draws
    tab.page.mouse.down()
    wait_until(
        lambda: tab.page.wait_for_timeout(50) or things.types()[:1] == [Feedback.MOUSE_DOWN], what="the press"
    )
    return x, y


def drag(tab: Tab, things: Things, x: float, y: float, width: float) -> None:
    """Move the mouse until the server has heard of it."""

    def is_moved() -> bool:
        tab.page.mouse.move(x, y, steps=3)
        tab.page.mouse.move(x + width, y, steps=5)
        tab.page.wait_for_timeout(50)
        return Feedback.POSE_UPDATE in things.types()

    wait_until(is_moved, what="a pose")


def test_marker_is_dragged_along_its_axis_and_stays_where_it_was_let_go(tab: Tab, things: Things) -> None:
    x, y = grab(tab, things)
    tab.keep("marker_grabbed")
    drag(tab, things, x, y, 60.0)
    tab.page.mouse.up()
    wait_until(
        lambda: tab.page.wait_for_timeout(50) or things.types()[-1] == Feedback.MOUSE_UP, what="the release"
    )
    made = things.server.get("slider")
    assert made is not None
    place = made.pose.position
    assert abs(place.y) > 0.1
    assert (place.x, place.z) == pytest.approx((0.0, 0.0), abs=1e-3)
    # To the right on the page, from before: the camera looks along -x, so that is +y.
    assert place.y > 0.0
    tab.page.mouse.move(x, 470.0)  # what is under the pointer has another colour
    wait_until(lambda: spot(tab, is_red, at_end=True)[0] > x + 20.0, what="the gizmo where it was let go")
    tab.keep("marker_dragged")
    assert {said.control_name for said in things.heard} == {"along"}


def test_shape_of_a_marker_is_dragged_across_the_view_and_its_camera_stays(tab: Tab, things: Things) -> None:
    x, y = spot(tab, is_yellow, at_end=True)
    tab.page.mouse.move(x, y)
    tab.page.wait_for_timeout(500)  # the scene notes what is under the pointer when it draws
    tab.page.mouse.down()
    drag(tab, things, x, y, 50.0)
    tab.keep("marker_shape_grabbed")
    tab.page.mouse.up()
    wait_until(
        lambda: tab.page.wait_for_timeout(50) or things.types()[-1] == Feedback.MOUSE_UP, what="the release"
    )
    assert things.types()[0] == Feedback.MOUSE_DOWN
    assert {said.control_name for said in things.heard} == {"across"}
    made = things.server.get("puck")
    assert made is not None
    place = made.pose.position
    # Its plane is across the axis x, along which the camera looks: to the right is +y.
    assert place.y > -1.1
    assert place.x == pytest.approx(0.0, abs=1e-6)
    tab.page.mouse.move(x, 470.0)  # what is under the pointer has another colour
    wait_until(lambda: spot(tab, is_yellow, at_end=True)[0] > x + 20.0, what="the shape where it was let go")
    tab.keep("marker_shape_dragged")


def test_menu_opens_by_a_click_and_its_entry_is_chosen(tab: Tab, things: Things) -> None:
    menu = MenuHandler()
    chosen: list[str] = []
    outer = menu.insert("drive")
    fast = menu.insert("fast", parent=outer, callback=lambda said: chosen.append(said.marker_name))
    menu.setCheckState(fast, MenuHandler.CHECKED)
    menu.insert("<b>stop</b>")
    menu.apply(things.server, "box")
    things.server.applyChanges()
    x, y = spot(tab, is_blue)

    def is_open() -> bool:
        if tab.page.locator("#marker-menu").count():
            return True
        tab.page.mouse.move(x, y)
        tab.page.wait_for_timeout(300)
        tab.page.mouse.down()
        tab.page.wait_for_timeout(50)
        tab.page.mouse.up()
        tab.page.wait_for_timeout(1000)
        return bool(tab.page.locator("#marker-menu").count())

    wait_until(is_open, what="the menu")
    assert tab.text("#marker-menu b") == "A box"
    assert [entry.strip() for entry in tab.page.locator("#marker-menu > ul > li").all_text_contents()] == [
        "drive ▸",
        "<b>stop</b>",
    ]
    tab.click(f'#marker-menu [data-entry="{outer}"]')
    wait_until(lambda: "[x] fast" in tab.text("#marker-menu"), what="the inner menu")
    tab.keep("marker_menu")
    tab.click(f'#marker-menu [data-entry="{fast}"]')
    wait_until(lambda: tab.page.wait_for_timeout(50) or chosen == ["box"], what="the choice")
    assert tab.page.locator("#marker-menu").count() == 0


def test_page_that_closes_during_a_drag_lets_the_marker_go(tab: Tab, things: Things) -> None:
    x, y = grab(tab, things)
    drag(tab, things, x, y, -40.0)
    assert Feedback.MOUSE_UP not in things.types()
    tab.page.close()
    wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="the release")
