"""The panels in a real browser: what a scene without anything says, the log, the graph, keys, and narrow screens."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from tests.conftest import Program
from tests.spun import SpunNode, spun
from tests.viewer.test_browser import Tab, browser, wait_until

from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.node.node import Node
from tfloom.turtlesim.canvas import DEFAULT_BACKGROUND

__all__ = ["browser"]
# A browser that draws without a graphics card takes a core for itself: beside compilers it would take minutes.
pytestmark = [pytest.mark.slow, pytest.mark.timing]


@pytest.fixture(scope="module")
def address(module_domain_id: int, start_module_program: Callable[..., Program]) -> str:
    view = start_module_program("tfloom", "view", "--no-open", "--port", "0", "--display", "/turtle1/pose")
    return view.wait_for("Open http://127.0.0.1:").removeprefix("Open ")


@pytest.fixture(scope="module")
def observer(module_domain_id: int) -> Iterator[SpunNode]:
    with spun(SpunNode("observer", module_domain_id)) as made:
        yield made


@pytest.fixture
def tab(browser: Any, address: str) -> Iterator[Tab]:
    made = Tab(browser, address)
    yield made
    made.page.close()
    assert made.faults == []


def box_of(tab: Tab, selector: str) -> dict[str, float]:
    found: dict[str, float] = tab.page.evaluate(
        "selector => { const box = document.querySelector(selector).getBoundingClientRect();"
        "return {left: box.left, right: box.right, top: box.top, bottom: box.bottom}; }",
        selector,
    )
    return found


def test_empty_scene_says_what_helps_and_offers_what_there_is(
    tab: Tab, observer: SpunNode, module_domain_id: int
) -> None:
    wait_until(lambda: "nothing publishes /tf" in tab.text("#empty-text"), what="the sentence")
    assert f"domain {module_domain_id}" in tab.text("#empty-text")
    tab.keep("empty")
    turtle = observer.node.create_publisher(Pose, "/turtle2/pose", 1)
    wait_until(lambda: "show /turtle2/pose" in tab.text("#empty-offers"), what="the offer")
    tab.click("#empty-offers button")
    wait_until(turtle.get_subscription_count, what="the display")
    wait_until(lambda: turtle.publish(Pose(x=5.0, y=5.0)) or tab.page.is_hidden("#empty"), what="the turtle")
    tab.page.evaluate("send({ op: 'display', topic: '/turtle2/pose', on: false })")
    observer.node.destroy_publisher(turtle)


def test_floor_of_turtlesim_is_bright_and_stays_so(tab: Tab, observer: SpunNode) -> None:
    turtle = observer.node.create_publisher(Pose, "/turtle1/pose", 1)
    wait_until(turtle.get_subscription_count, what="the display")

    def floor() -> Any:
        """Return the colour that most of the blue pixels have; None where few are blue."""
        pixels = tab.pixels().reshape(-1, 3)
        blue = pixels[(pixels[:, 2] > 60) & (pixels[:, 2] > 1.5 * pixels[:, 0])]
        return np.median(blue, axis=0) if len(blue) > 0.1 * len(pixels) else None

    # The camera is where it sees the floor, which fills much of the picture.
    wait_until(lambda: turtle.publish(Pose(x=5.0, y=5.0)) or floor() is not None, what="the floor")
    for _ in range(20):  # also when the scene has loaded its lights
        np.testing.assert_allclose(floor(), DEFAULT_BACKGROUND, atol=40)
    tab.keep("turtle_floor")
    tab.page.evaluate("send({ op: 'display', topic: '/turtle1/pose', on: false })")
    observer.node.destroy_publisher(turtle)


HAS_LINE = "text => lines.some(line => line.text === text)"


def log_of(tab: Tab, node: Node, numbers: range) -> None:
    """Log lines, not more at once than a subscription to the log keeps, until the page has them."""
    for number in numbers:
        node.get_logger().info(f"line {number:04}")
        if number % 20 == 19 or number == numbers[-1]:
            last = f"line {number:04}"
            wait_until(lambda last=last: tab.page.evaluate(HAS_LINE, last), what="the lines")


def test_log_opens_at_its_end_follows_and_stays_where_its_user_scrolled(tab: Tab, observer: SpunNode) -> None:
    node = observer.node
    wait_until(lambda: node.count_subscribers("/rosout"), what="the reader of the log")
    log_of(tab, node, range(200))
    tab.click("[data-panel=log]")

    def is_at_end() -> bool:
        return bool(
            tab.page.evaluate(
                "(box => box.scrollHeight > box.clientHeight + 200 &&"
                "box.scrollHeight - box.scrollTop - box.clientHeight < 5)(document.getElementById('log-lines'))"
            )
        )

    def top() -> float:
        return float(tab.page.evaluate("document.getElementById('log-lines').scrollTop"))

    wait_until(is_at_end, what="the end of the log")
    before = top()
    log_of(tab, node, range(200, 210))
    wait_until(lambda: top() > before and is_at_end(), what="the next lines")
    tab.page.evaluate("document.getElementById('log-lines').scrollTop = 100")
    wait_until(lambda: tab.page.evaluate("!followsLog"), what="the end of following")
    log_of(tab, node, range(210, 220))
    wait_until(lambda: "line 0219" in tab.text("#log-lines"), what="more lines")
    assert top() == 100.0
    tab.page.fill("#log-text", "LINE 0003")
    wait_until(lambda: tab.text("#log-lines").count("line ") == 1, what="the filtered line")
    tab.page.fill("#log-text", "")
    wait_until(is_at_end, what="all lines")
    tab.click("[data-panel=frames]")
    tab.click("[data-panel=log]")
    wait_until(is_at_end, what="the end, though another panel was open")


def test_graph_is_whole_in_layers_and_leads_to_a_nodes_parameters(tab: Tab, observer: SpunNode) -> None:
    node = observer.node
    publishers = [node.create_publisher(String, f"/topic_{number}", 1) for number in range(12)]
    node.declare_parameter("speed", 7)
    with spun(SpunNode("hearer", node.context.get_domain_id())) as hearer:
        for number in range(12):
            hearer.received(String, f"/topic_{number}")
        wait_until(lambda: all(one.get_subscription_count() for one in publishers), what="the readers")
        tab.click("[data-panel=graph]")
        ready = "document.querySelectorAll('#graph-picture .vertex').length >= 14"
        wait_until(
            lambda: tab.page.evaluate(ready) or tab.click("#graph-refresh"),
            what="two nodes and twelve topics",
        )
    panel = box_of(tab, "#graph-picture")
    boxes = tab.page.evaluate(
        "Object.fromEntries([...document.querySelectorAll('#graph-picture .vertex')].map(group => {"
        "const box = group.querySelector('rect').getBoundingClientRect();"
        "return [group.dataset.name, [box.left, box.top, box.right, box.bottom]]; }))"
    )
    assert panel["right"] - panel["left"] <= 400
    for left, top, right, bottom in boxes.values():
        assert panel["left"] - 1 <= left < right <= panel["right"] + 1
        assert panel["top"] - 1 <= top < bottom <= panel["bottom"] + 1
    assert boxes["/observer"][2] < boxes["/topic_3"][0] < boxes["/topic_3"][2] < boxes["/hearer"][0]
    tops = sorted(box[1] for name, box in boxes.items() if name.startswith("/topic_"))
    assert np.diff(tops).min() > 0.0
    assert "topic" in tab.text("#graph-legend")
    tab.keep("graph_in_layers")
    before = tab.page.get_attribute("#graph-picture svg", "viewBox")
    tab.page.mouse.move(150, 200)
    tab.page.mouse.wheel(0, -300)
    wait_until(lambda: tab.page.get_attribute("#graph-picture svg", "viewBox") != before, what="the zoom")
    tab.click("#graph-whole")
    wait_until(lambda: tab.page.get_attribute("#graph-picture svg", "viewBox") == before, what="the whole")
    tab.page.evaluate(
        "[...document.querySelectorAll('#graph-picture .vertex')].find(one => one.dataset.name === '/observer')"
        ".dispatchEvent(new MouseEvent('click', {bubbles: true}))"
    )
    observer.spin_until(lambda: "speed" in tab.text("#parameter-rows"), "the node's parameters", 60.0)
    assert tab.page.is_visible("#parameters")
    for publisher in publishers:
        node.destroy_publisher(publisher)


def test_keys_choose_tools_and_are_listed(tab: Tab) -> None:
    def chosen() -> str:
        return str(tab.page.evaluate("document.querySelector('#tools .on').dataset.tool"))

    for key, tool in (("g", "goal"), ("p", "initial"), ("c", "point"), ("v", "drive"), ("m", "")):
        tab.page.keyboard.press(key)
        wait_until(lambda tool=tool: chosen() == tool, what=f"the tool of {key}")
    tab.page.keyboard.press("g")
    tab.page.keyboard.press("Escape")
    wait_until(lambda: chosen() == "", what="no tool")
    tab.page.keyboard.press("?")
    wait_until(lambda: tab.page.is_visible("#keys"), what="the list of keys")
    assert "see all that is shown" in tab.text("#keys")
    tab.page.keyboard.press("Escape")
    wait_until(lambda: tab.page.is_hidden("#keys"), what="its end")
    tab.click("[data-panel=log]")
    tab.page.focus("#log-node")
    tab.page.keyboard.press("g")  # a letter in a field is no key
    assert tab.page.input_value("#log-node") == "g"
    assert chosen() == ""
    tab.page.fill("#log-node", "")


@pytest.mark.parametrize(("width", "height"), [(390, 844), (820, 1180)])
def test_narrow_screens_have_the_scene_and_a_drawer(tab: Tab, width: int, height: int) -> None:
    tab.page.set_viewport_size({"width": width, "height": height})
    wait_until(lambda: box_of(tab, "#scene")["right"] == width, what="the layout")
    scene = box_of(tab, "#scene")
    assert scene["left"] == 0
    assert scene["bottom"] - scene["top"] > 0.6 * height
    assert tab.page.is_hidden("#rows")
    assert tab.page.evaluate("document.documentElement.scrollWidth") == width
    tab.click("#menu")
    wait_until(lambda: tab.page.is_visible("#tabs") and box_of(tab, "#left")["left"] == 0, what="the drawer")
    assert box_of(tab, "#left")["right"] <= width
    tab.keep(f"drawer_{width}")
    tab.click("#shade")
    wait_until(lambda: tab.page.is_hidden("#tabs"), what="the end of the drawer")
    tab.click("[data-tool=drive]")
    stick = box_of(tab, "#stick")
    assert scene["left"] <= stick["left"] < stick["right"] <= scene["right"]
    assert stick["bottom"] <= scene["bottom"]
    assert stick["right"] - stick["left"] >= 120
    tab.keep(f"narrow_{width}")


def test_log_has_each_line_once_when_the_connection_is_opened_again(
    browser: Any, address: str, observer: SpunNode
) -> None:
    tab = Tab(browser, address)
    tab.click("[data-panel=log]")
    said = [f"line {number} of the log" for number in range(3)]
    for text in said[:2]:
        observer.node.get_logger().info(text)
    wait_until(lambda: all(text in tab.text("#log-lines") for text in said[:2]), what="the lines")
    for _ in range(2):
        tab.page.evaluate("socket.close()")
        tab.page.wait_for_selector("body:not([data-ready=yes])", timeout=120_000.0)
        tab.page.wait_for_selector("body[data-ready=yes]", timeout=120_000.0)
    observer.node.get_logger().info(said[2])
    wait_until(lambda: said[2] in tab.text("#log-lines"), what="the next line")
    assert [tab.text("#log-lines").count(text) for text in said] == [1, 1, 1]
    assert tab.page.evaluate("lines.length === new Set(lines.map(line => JSON.stringify(line))).size")
    tab.page.close()
    assert tab.faults == []


def test_address_names_the_panel_that_is_open(browser: Any, address: str, observer: SpunNode) -> None:
    observer.node.create_publisher(Pose, "/turtle1/pose", 1)
    opened = Tab(browser, address, "&panel=graph")
    wait_until(lambda: opened.page.is_visible("#graph"), what="the panel")
    wait_until(
        lambda: "/turtle1/pose" in opened.text("#graph-picture"), what="the graph, which was asked for"
    )
    assert box_of(opened, "#left")["right"] > 0.55 * 1000
    assert opened.page.is_hidden("#frames")
    # A connection that is opened again leaves the panel that its user has chosen since.
    opened.page.evaluate("openPanel('send'); socket.close()")
    opened.page.wait_for_selector("body:not([data-ready=yes])", timeout=120_000.0)
    opened.page.wait_for_selector("body[data-ready=yes]", timeout=120_000.0)
    assert opened.page.is_visible("#send")
    opened.page.close()
    for query, panel in (("&panel=plots", "#plot-panel"), ("&panel=nothing", "#frames")):
        other = Tab(browser, address, query)
        wait_until(lambda panel=panel, other=other: other.page.is_visible(panel), what=panel)
        other.page.close()
        assert other.faults == []
    assert opened.faults == []
