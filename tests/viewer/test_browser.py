"""The page in a real browser: Debian's Chromium, without a screen and with software for a graphics card."""

from __future__ import annotations

import csv
import io
import os
import re
import shutil
import sys
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests import conftest
from tests.conftest import Program
from tests.spun import SpunNode, spun
from tests.viewer.a_robot import EVIL
from tests.viewer.sites import site
from tests.viewer.test_layout import RVIZ

import tfloom
from tfloom.interfaces.geometry_msgs.msg import PointStamped, PoseStamped, Twist
from tfloom.interfaces.turtlesim.msg import Pose as TurtlePose
from tfloom.node.node import Node
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener
from tfloom.tf2_tools.text import transform_text
from tfloom.viewer.layout.layout_file import read_layout

# A browser that draws without a graphics card takes a core for itself: beside compilers it would take minutes.
pytestmark = [pytest.mark.slow, pytest.mark.timing]
BROWSER = shutil.which("chromium")
FLAGS = [
    *("--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"),
    *(
        "--disable-component-update",
        "--disable-sync",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
    ),
]
TIMEOUT_S = 120.0
"""The longest wait: a busy machine draws the scene in software."""
LOADED_MS = 1000 * TIMEOUT_S
FOLDER = os.environ.get("TFLOOM_PICTURES")
"""Where to keep pictures of the pages, for a person to look at."""


def wait_until(condition: Callable[[], object], what: str = "") -> None:
    conftest.wait_until(condition, TIMEOUT_S, what)


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="needs playwright, which `make check` installs"
    )
    if BROWSER is None:
        pytest.skip("needs Debian's Chromium: apt-get install chromium")
    with playwright.sync_playwright() as driver:
        made = driver.chromium.launch(executable_path=BROWSER, headless=True, args=FLAGS)
        yield made
        made.close()


@pytest.fixture(scope="module")
def spun_node(module_domain_id: int) -> Iterator[SpunNode]:
    with spun(SpunNode("test", module_domain_id)) as made:
        yield made


@pytest.fixture(scope="module")
def node(spun_node: SpunNode) -> Node:
    """A node of the test, spun by `spin_until`."""
    return spun_node.node


@pytest.fixture(scope="module")
def spin_until(spun_node: SpunNode) -> Callable[..., None]:
    return partial(spun_node.spin_until, timeout_s=TIMEOUT_S)


@pytest.fixture(scope="module")
def address(module_domain_id: int, start_module_program: Callable[..., Program]) -> str:
    start_module_program(sys.executable, Path(__file__).parent / "a_robot.py")
    start_module_program("tfloom", "run", "turtlesim", "turtlesim_node", "--headless")
    view = start_module_program("tfloom", "view", "--no-open", "--port", "0")
    return view.wait_for("Open http://127.0.0.1:").removeprefix("Open ")


class Tab:
    """A tab of the browser with the page."""

    def __init__(self, browser: Any, address: str, query: str = "") -> None:
        self.page = browser.new_page(viewport={"width": 1000, "height": 480})
        self.faults: list[str] = []
        self.requests: list[str] = []
        self.page.on("pageerror", lambda error: self.faults.append(str(error)))
        self.page.on("dialog", lambda dialog: (self.faults.append(dialog.message), dialog.dismiss()))
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("websocket", lambda socket: self.requests.append(socket.url))
        self.page.set_default_timeout(LOADED_MS)
        self.page.goto(f"{address}?dpr={os.environ.get('TFLOOM_DPR', '0.6')}{query}")
        self.page.wait_for_selector("body[data-ready=yes]", timeout=LOADED_MS)
        wait_until(lambda: self.scene is not None, what="the scene")
        self.scene.wait_for_selector("canvas", timeout=LOADED_MS)

    @property
    def scene(self) -> Any:
        self.page.wait_for_timeout(50)  # lets events of the browser in
        return next((frame for frame in self.page.frames if "/scene/" in frame.url), None)

    def text(self, selector: str) -> str:
        self.page.wait_for_timeout(20)
        return str(self.page.text_content(selector) or "")

    def click(self, selector: str) -> None:
        """Click without the wait until nothing moves: software draws the scene too slowly for it."""
        self.page.evaluate("selector => document.querySelector(selector).click()", selector)

    def select(self, frame: str) -> None:
        self.page.evaluate(
            "frame => [...document.querySelectorAll('#rows tr')].find(row => row.dataset.frame === frame)"
            ".querySelector('.name').click()",
            frame,
        )

    def pixels(self) -> np.ndarray:
        from PIL import Image

        picture = self.page.locator("#scene").screenshot(timeout=LOADED_MS)
        return np.asarray(Image.open(io.BytesIO(picture)).convert("RGB")).astype(int)

    def keep(self, name: str) -> None:
        if FOLDER:
            self.page.screenshot(path=str(Path(FOLDER) / f"{name}.png"), timeout=LOADED_MS)


@pytest.fixture(scope="module")
def tab(browser: Any, address: str) -> Iterator[Tab]:
    """A tab that the tests share. No script fails in it, and it asks for nothing from elsewhere."""
    made = Tab(
        browser, address, "&camera=-3,-4,4&look_at=0,0,0"
    )  # where it stays: places of the floor are known
    yield made
    made.page.close()
    assert made.faults == []
    for url in made.requests:
        assert url.startswith((address, address.replace("http", "ws"), "data:", "blob:")), url


def coloured(pixels: np.ndarray) -> int:
    """Return how many pixels have a strong colour, as axes and arrows have, and the floor and names don't."""
    return int((np.ptp(pixels, axis=2) > 60).sum())


def test_frames_appear_move_and_have_their_names_as_text(tab: Tab) -> None:
    wait_until(lambda: "base_link" in tab.text("#rows"), what="the tree")
    tab.page.evaluate("send({ op: 'axes', length: 1.0 })")
    wait_until(lambda: coloured(tab.pixels()) > 300, what="axes and arrows")
    before = tab.pixels()
    wait_until(lambda: np.abs(tab.pixels() - before).max() > 60, what="a movement")
    row = tab.page.evaluate("[...document.querySelectorAll('#rows tr')].map(row => row.dataset.frame)")
    assert EVIL in row
    assert EVIL in tab.text("#rows")
    assert tab.page.evaluate("document.querySelectorAll('#rows img').length") == 0
    rate = tab.page.evaluate(
        "Number([...document.querySelectorAll('#rows tr')].find(row => row.dataset.frame === 'base_link')"
        ".querySelector('.number').textContent)"
    )
    assert rate > 10.0
    tab.keep("frames")
    tab.page.evaluate("send({ op: 'axes', length: 0.3 })")


def test_slider_goes_back_and_two_clicks_give_the_transform(
    tab: Tab, node: Node, spin_until: Callable[..., None]
) -> None:
    buffer = Buffer(node=node)
    listener = TransformListener(buffer, node)
    spin_until(lambda: buffer.can("map", "laser"))
    start = buffer.lookup("map", "laser").stamp_ns
    spin_until(lambda: buffer.lookup("map", "laser").stamp_ns > start + 3 * 10**9)
    wait_until(lambda: "laser" in tab.text("#rows"))
    tab.select("map")
    tab.select("laser")
    wait_until(lambda: "- Matrix:" in tab.text("#selection-text"), what="the transform")
    assert tab.text("#selection-title") == "tf2_echo map laser"
    tab.page.evaluate(
        "stamp => send({ op: 'hold', stamp_ns: stamp })", str(start + 10**9)
    )  # what the slider sends, for a stamp that the test's own buffer has, too

    def is_held() -> bool:
        text = tab.text("#selection-text")
        found = re.match(r"At time (\d+)\.(\d+)", text)
        if found is None or int(found[1] + found[2]) != start + 10**9:
            return False
        expected = buffer.lookup("map", "laser", start + 10**9)
        assert text == transform_text(expected.stamp_ns, expected.translation, expected.rotation_xyzw)
        return True

    wait_until(is_held, what="the transform of a second after the start")
    still = tab.pixels()
    assert np.abs(tab.pixels() - still).mean() < 1.0  # it stands
    tab.page.evaluate(
        "() => { const slider = document.querySelector('#slider'); slider.value = 0.5;"
        " slider.dispatchEvent(new Event('input')); }"
    )
    wait_until(lambda: tab.text("#clock").startswith("-"), what="an earlier time")
    wait_until(lambda: not is_held())
    tab.keep("slider")
    tab.click("#live")
    wait_until(lambda: tab.text("#clock").startswith("live"), what="the present")
    tab.click("#unselect")
    listener.unregister()


def test_displays_are_switched_on_by_a_click(tab: Tab) -> None:
    tab.click("[data-panel=displays]")
    topics = ["/scan", "/points", "/markers", "/map", "/robot_description", "/plan", "/odom", "/camera/image"]
    wait_until(lambda: all(topic in tab.text("#display-rows") for topic in topics), what="the topics")
    dark = int((tab.pixels().mean(axis=2) > 200).sum())
    for topic in topics:
        tab.click(f'[data-topic="{topic}"] input')
    wait_until(
        lambda: int((tab.pixels().mean(axis=2) > 200).sum()) > dark + 5000, what="the light floor of the map"
    )
    wait_until(
        lambda: tab.page.evaluate("(document.querySelector('.picture img') || {}).naturalWidth") == 160,
        what="the camera's image",
    )

    def statuses() -> str:
        return "".join(
            tab.page.evaluate(
                "[...document.querySelectorAll('.display .status')].map(one => one.textContent)"
            )
        )

    wait_until(lambda: statuses() == "", what="displays without a fault")
    tab.keep("displays")
    for topic in topics:
        tab.click(f'[data-topic="{topic}"] input')
    tab.click("[data-panel=frames]")


def test_dragged_goal_is_published(tab: Tab, node: Node, spin_until: Callable[..., None]) -> None:
    goals: list[PoseStamped] = []
    subscription = node.create_subscription(PoseStamped, "/goal_pose", goals.append, 10)
    wait_until(lambda: "base_link" in tab.text("#rows"))
    tab.click("[data-tool=goal]")
    box = tab.page.locator("#pad").bounding_box()
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def is_published() -> bool:
        tab.page.mouse.move(*middle)
        tab.page.mouse.down()
        tab.page.mouse.move(middle[0], middle[1] - 60)
        tab.page.mouse.up()
        tab.page.wait_for_timeout(200)
        return "published on /goal_pose" in tab.text("#message")

    wait_until(is_published, what="the goal")
    spin_until(lambda: goals)
    # The middle of the screen shows the point at which the camera looks, (0, 0), and up is away from it.
    position, turn = goals[-1].pose.position, goals[-1].pose.orientation
    assert (position.x, position.y) == pytest.approx((0.0, 0.0), abs=0.1)
    assert 2.0 * np.arctan2(turn.z, turn.w) == pytest.approx(np.arctan2(4.0, 3.0), abs=0.1)
    assert goals[-1].header.frame_id == "map"
    tab.keep("goal")
    node.destroy_subscription(subscription)


def test_keys_drive_the_turtle(tab: Tab, node: Node, spin_until: Callable[..., None]) -> None:
    poses: list[TurtlePose] = []
    subscription = node.create_subscription(TurtlePose, "/turtle1/pose", poses.append, 10)
    spin_until(lambda: poses)
    before = poses[-1].x
    tab.click("[data-tool=drive]")
    wait_until(lambda: "/turtle1/cmd_vel" in tab.text("#drive-topic"), what="the turtle's topic")

    def holding() -> bool:
        # As a keyboard does: a page that didn't run for half a second takes each key for released.
        tab.page.keyboard.down("ArrowUp")
        return poses[-1].x > before + 0.5

    spin_until(holding)
    tab.page.keyboard.up("ArrowUp")
    spin_until(lambda: poses[-1].linear_velocity == 0.0)
    tab.click("[data-panel=displays]")
    tab.click('[data-topic="/turtle1/pose"] input')
    wait_until(
        lambda: ((tab.pixels()[..., 2] > 150) & (tab.pixels()[..., 0] < 110)).sum() > 3000, what="water"
    )
    tab.keep("turtle")
    tab.click('[data-topic="/turtle1/pose"] input')
    node.destroy_subscription(subscription)


def test_gamepad_drives_the_turtle(tab: Tab, node: Node, spin_until: Callable[..., None]) -> None:
    commands: list[Twist] = []
    subscription = node.create_subscription(Twist, "/turtle1/cmd_vel", commands.append, 10)
    poses: list[TurtlePose] = []
    turtle = node.create_subscription(TurtlePose, "/turtle1/pose", poses.append, 10)
    spin_until(lambda: poses)
    tab.page.evaluate(
        "navigator.getGamepads = () => [null, window.axes ? { axes: window.axes, buttons: [] } : null]"
    )
    tab.click("[data-tool=drive]")
    wait_until(lambda: "/turtle1/cmd_vel" in tab.text("#drive-topic"), what="the turtle's topic")
    tab.page.select_option("#drive-topic", "/turtle1/cmd_vel")

    def hold(across: float, down: float) -> None:
        tab.page.evaluate("axes => { window.axes = axes; }", [across, down])

    hold(0.05, -0.05)  # a stick that is let go is never quite at zero
    tab.page.wait_for_timeout(500)
    spin_until(lambda: len(poses) > 5)
    assert commands == []
    hold(0.5, -0.25)  # ahead, and to the right
    spin_until(lambda: poses[-1].linear_velocity == pytest.approx(0.5) and len(commands) > 3)
    assert (commands[-1].linear.x, commands[-1].angular.z) == pytest.approx((0.5, -1.0))
    # Halfway it is unplugged: the robot is told to stop.
    tab.page.evaluate("() => { window.axes = null; }")
    spin_until(lambda: commands[-1].linear.x == 0.0 and commands[-1].angular.z == 0.0)
    spin_until(lambda: poses[-1].linear_velocity == 0.0)
    # A page that is gone with its stick held says nothing any more: the server stops the robot.
    hold(0.0, -1.0)
    spin_until(lambda: poses[-1].linear_velocity == pytest.approx(2.0))
    tab.page.evaluate("() => { send = () => {}; }")
    spin_until(lambda: poses[-1].linear_velocity == 0.0)
    tab.page.reload()
    tab.page.wait_for_selector("body[data-ready=yes]", timeout=LOADED_MS)
    node.destroy_subscription(subscription)
    node.destroy_subscription(turtle)


def test_image_is_drawn_in_its_cameras_frustum(browser: Any, address: str, tab: Tab) -> None:
    tab.page.goto("about:blank")  # one scene at a time is drawn
    behind = Tab(
        browser, address, "&camera=-0.6,0,0.5&look_at=1,0,0.2"
    )  # behind the robot, which looks ahead
    behind.page.evaluate("send({ op: 'names', on: false }); send({ op: 'fixed_frame', frame: 'base_link' })")
    behind.click("[data-panel=displays]")
    topics = ["/camera/camera_info", "/camera/image"]
    wait_until(lambda: all(topic in behind.text("#display-rows") for topic in topics), what="the topics")

    def purple() -> int:
        """Return how many pixels are red and blue, as the image is, and neither axes nor arrows are."""
        pixels = behind.pixels()
        return int(((pixels[..., 1] < 60) & (pixels[..., 0] > 90) & (pixels[..., 2] > 60)).sum())

    behind.click(f'[data-topic="{topics[0]}"] input')
    behind.page.wait_for_timeout(1000)
    before = purple()
    behind.click(f'[data-topic="{topics[1]}"] input')
    wait_until(lambda: purple() > before + 2000, what="the image in the scene")
    behind.keep("frustum")
    choices = f'[data-topic="{topics[0]}"] select'
    assert behind.page.eval_on_selector(choices, "one => [...one.options].map(each => each.value)") == [
        "",
        "/camera/image",
        "no image",
    ]
    behind.page.select_option(choices, "no image")
    wait_until(lambda: purple() < before + 500, what="the pyramid alone")
    for topic in topics:
        behind.click(f'[data-topic="{topic}"] input')
    behind.page.evaluate("send({ op: 'names', on: true }); send({ op: 'fixed_frame', frame: '' })")
    behind.page.wait_for_timeout(500)
    assert behind.faults == []
    behind.page.close()
    tab.page.goto(f"{address}?dpr=0.6")
    tab.page.wait_for_selector("body[data-ready=yes]", timeout=LOADED_MS)


def test_log_graph_and_parameters(tab: Tab) -> None:
    tab.click("[data-panel=log]")
    wait_until(lambda: "[robot] at " in tab.text("#log-lines"), what="the log")
    tab.click("[data-panel=graph]")
    wait_until(lambda: "/turtlesim" in tab.text("#graph-picture"), what="the graph")
    tab.keep("graph")
    tab.click("[data-panel=parameters]")
    wait_until(lambda: "use_sim_time" in tab.text("#parameter-rows"), what="the parameters")


class Form:
    """The form of a tab, filled in as a user does it."""

    def __init__(self, tab: Tab, what: str, name: str) -> None:
        self._tab = tab
        tab.click("[data-panel=send]")
        tab.page.select_option("#form-what", what)
        wait_until(
            lambda: tab.page.evaluate(
                "name => [...document.querySelectorAll('#form-names option')].some(one => one.value === name)",
                name,
            ),
            what="the name",
        )
        tab.page.fill("#form-name", name)
        tab.page.dispatch_event("#form-name", "change")
        tab.page.wait_for_selector("#form-send:not([disabled])")

    def set(self, field: str, text: str) -> None:
        self._tab.page.fill(f"#form-fields [data-field={field}] input", text)

    def send(self, answer: str) -> None:
        """Send it, and wait for an answer."""
        self._tab.click("#form-send")
        wait_until(lambda: answer in self._tab.text("#form-answer"), what=answer)


def test_forms_publish_call_and_send_goals(tab: Tab, node: Node, spin_until: Callable[..., None]) -> None:
    aims: list[PoseStamped] = []
    subscription = node.create_subscription(PoseStamped, "/aim", aims.append, 10)
    form = Form(tab, "topic", "/aim")
    tab.page.fill("#form-fields [data-field=position] [data-field=x] input", "2.5")
    form.set("frame_id", EVIL)
    form.send("published on /aim: 1 subscription")
    spin_until(lambda: aims)
    assert aims[-1].pose.position.x == 2.5
    assert aims[-1].header.frame_id == EVIL
    assert aims[-1].header.stamp.sec > 0
    tab.keep("form_topic")
    tab.page.fill("#form-fields [data-field=position] [data-field=x] input", "far")
    form.send("pose.position.x: could not convert string to float")
    node.destroy_subscription(subscription)

    form = Form(tab, "service", "/spawn")
    for field, text in (("x", "2"), ("y", "3"), ("name", "formed")):
        form.set(field, text)
    form.send("name: formed")
    form.send("name: ''")  # there is one of this name already
    tab.keep("form_service")

    form = Form(tab, "action", "/turtle1/rotate_absolute")
    form.set("theta", "1.2")
    form.send("remaining: ")
    wait_until(lambda: "SUCCEEDED" in tab.text("#form-answer"), what="the result")
    tab.keep("form_action")
    form.set("theta", "-1.9")
    form.send("remaining: ")
    tab.click("#form-cancel")
    wait_until(lambda: "CANCELED" in tab.text("#form-answer"), what="the goal's end")
    tab.click("[data-panel=frames]")


def test_form_publishes_at_a_rate_until_stop_is_clicked(
    tab: Tab, node: Node, spin_until: Callable[..., None]
) -> None:
    heard: list[PointStamped] = []
    subscription = node.create_subscription(PointStamped, "/steady", heard.append, 1000)
    form = Form(tab, "topic", "/steady")
    tab.page.fill("#form-rate", "20")
    form.set("frame_id", "odom")
    form.send("messages on /steady")  # a count, which grows
    assert tab.page.is_visible("#form-cancel")
    assert tab.text("#form-cancel") == "Stop"
    spin_until(lambda: len(heard) >= 10)
    stamps = [(one.header.stamp.sec, one.header.stamp.nanosec) for one in heard]
    assert stamps == sorted(set(stamps))  # each has its own time, by the word `now`
    assert {one.header.frame_id for one in heard} == {"odom"}
    assert tab.text("#form-state") == "publishing"
    tab.keep("form_rate")
    # What is refused ends nothing, and can be stopped as before.
    for rate, text, reason in (("-3", "odom", "a rate is a number"), ("20", "x" * 60_000, "60,000")):
        tab.page.fill("#form-rate", rate)
        form.set("frame_id", text)
        tab.click("#form-send")
        wait_until(lambda reason=reason: reason in tab.text("#form-answer"), what="the refusal")
    count = len(heard)
    spin_until(lambda: len(heard) > count + 10)
    assert "60,000" in tab.text("#form-answer")
    assert tab.text("#form-state") == "publishing"
    tab.click("#form-cancel")
    wait_until(lambda: not tab.page.is_visible("#form-cancel"), what="the end of publishing")
    said = re.fullmatch(r"published (\d+) messages on /steady", tab.text("#form-answer"))
    assert said is not None
    spin_until(lambda: len(heard) == int(said[1]))
    form.set("frame_id", "odom")
    tab.page.fill("#form-rate", "500")
    form.send("above 0 and at most 100 Hz")
    tab.page.fill("#form-rate", "")
    node.destroy_subscription(subscription)


def test_form_whose_connection_was_lost_says_that_it_has_ended(tab: Tab, node: Node) -> None:
    subscription = node.create_subscription(PointStamped, "/steady", lambda _: None, 1)
    form = Form(tab, "topic", "/steady")
    tab.page.fill("#form-rate", "20")
    form.send("messages on /steady")
    tab.page.evaluate("socket.close()")
    wait_until(lambda: "the connection was lost" in tab.text("#form-answer"), what="the end")
    assert not tab.page.is_visible("#form-cancel")
    assert tab.text("#form-state") == ""
    form.send("messages on /steady")  # what is sent from now on is of the new connection
    tab.click("#form-cancel")
    wait_until(lambda: not tab.page.is_visible("#form-cancel"), what="the end of publishing")
    tab.page.fill("#form-rate", "")
    node.destroy_subscription(subscription)


def add_plot(tab: Tab, topic: str, field: str, place: str = "") -> None:
    wait_until(
        lambda: tab.page.evaluate(
            "topic => [...document.querySelectorAll('#plot-topics option')].some(one => one.value === topic)",
            topic,
        ),
        what=topic,
    )
    tab.page.fill("#plot-topic", topic)
    tab.page.dispatch_event("#plot-topic", "change")
    tab.page.wait_for_selector("#plot-fields option", state="attached")
    tab.page.fill("#plot-field", field)
    if place:
        tab.page.select_option("#plot-place", place)
    tab.click("#plot-add")
    tab.page.wait_for_selector(f"[data-series='{topic} {field}']", state="attached")


def colored(tab: Tab, plot: int, color: str) -> int:
    """Return how many pixels of a plot have about a colour, as #4aa3ff."""
    return int(
        tab.page.evaluate(
            "([plot, color]) => { const canvas = document.querySelector(`[data-plot='${plot}'] canvas`);"
            " const wanted = [1, 3, 5].map(at => parseInt(color.slice(at, at + 2), 16));"
            " const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;"
            " let count = 0; for (let i = 0; i < data.length; i += 4)"
            " count += data[i + 3] > 60 && wanted.every((part, at) => Math.abs(part - data[i + at]) < 50);"
            " return count; }",
            [plot, color],
        )
    )


def time_of_plots(tab: Tab) -> dict[str, Any]:
    tab.page.wait_for_timeout(20)
    return dict(tab.page.evaluate("state.plot_time"))


def test_fields_are_plotted_in_a_plot_with_two_axes_zoomed_paused_and_saved(tab: Tab) -> None:
    tab.click("[data-panel=plot-panel]")
    add_plot(tab, "/odom", "pose.pose.position.x")
    add_plot(tab, "/scan", "ranges[3]", "1")
    row = tab.page.locator("#plot-rows .display").nth(1)
    row.locator("select").nth(1).select_option("right")
    wait_until(lambda: tab.page.evaluate("state.plots[1].axis") == "right", what="the right axis")
    blue, yellow = "#4aa3ff", "#ffd166"
    wait_until(lambda: colored(tab, 1, blue) > 60 and colored(tab, 1, yellow) > 60, what="both curves")
    wait_until(
        lambda: tab.page.evaluate("state.plots.every(one => one.seconds[0] < -0.5 * one.length_s)"),
        what="half of the time",
    )
    tab.keep("plots")
    over = tab.page.locator("[data-plot='1'] .u-over")
    box = over.bounding_box()
    assert box["width"] > 200  # also after the plot was made anew for its second axis
    # The value under the cursor, in the legend.
    tab.page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 40)
    wait_until(lambda: tab.text("#plot-at").startswith("at -"), what="the time under the cursor")
    values = tab.page.locator("[data-plot='1'] .plot-value").all_text_contents()
    assert all(abs(float(value)) < 100.0 for value in values)
    # A click shows that time, and nothing is zoomed.
    tab.page.mouse.move(box["x"] + 0.8 * box["width"], box["y"] + 40)
    tab.page.mouse.down()
    tab.page.mouse.up()
    wait_until(lambda: tab.text("#clock").startswith("-"), what="an earlier time")
    assert not time_of_plots(tab)["is_zoomed"]
    tab.click("#live")
    # The wheel shows less of the time, up to the newest; with Shift less of the values.
    whole_s = time_of_plots(tab)["end_s"] - time_of_plots(tab)["start_s"]
    tab.page.mouse.wheel(0, -100)
    wait_until(lambda: time_of_plots(tab)["is_zoomed"], what="less of the time")
    assert not time_of_plots(tab)["is_paused"]
    assert -time_of_plots(tab)["start_s"] == pytest.approx(0.8 * whole_s, rel=0.2)
    span = "(() => { const { min, max } = charts.get(1).uplot.scales.%s; return max - min; })()"
    before = tab.page.evaluate(span % "left")
    tab.page.keyboard.down("Shift")
    tab.page.mouse.wheel(0, -100)
    tab.page.keyboard.up("Shift")
    wait_until(lambda: tab.page.evaluate(span % "left") < 0.85 * before, what="less of the values")
    # A drag zooms into a box, in which the plot stands still.
    tab.page.mouse.move(box["x"] + 0.3 * box["width"], box["y"] + 0.3 * box["height"])
    tab.page.mouse.down()
    tab.page.mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 0.7 * box["height"], steps=5)
    before = tab.page.evaluate(span % "right")
    tab.page.mouse.up()
    wait_until(lambda: time_of_plots(tab)["is_paused"], what="the box")
    assert tab.page.evaluate(span % "right") == pytest.approx(0.4 * before, rel=0.1)
    time_s = time_of_plots(tab)
    assert time_s["end_s"] - time_s["start_s"] == pytest.approx(0.3 * 0.8 * whole_s, rel=0.25)
    tab.keep("plots_zoomed")
    tab.page.wait_for_timeout(600)
    assert time_of_plots(tab)["start_s"] == time_s["start_s"]
    assert tab.text("#plot-pause") == "Follow"
    # What is shown, as a file.
    with tab.page.expect_download(timeout=LOADED_MS) as download:
        tab.click("[data-plot='1'] button")
    assert download.value.suggested_filename == "plot_1.csv"
    rows = list(csv.reader(Path(download.value.path()).read_text().splitlines()))
    assert rows[0][2:] == ["/odom pose.pose.position.x", "/scan ranges[3]"]
    assert float(rows[-1][1]) <= time_s["end_s"] - time_s["start_s"]
    assert len(rows) > 3
    # A double click shows all.
    over.dblclick(timeout=LOADED_MS)
    wait_until(lambda: not time_of_plots(tab)["is_zoomed"], what="all of it")
    assert not time_of_plots(tab)["is_paused"]
    assert tab.page.evaluate("charts.get(1).zoom") == {}
    # A paused plot stands still, and follows again.
    tab.click("#plot-pause")
    wait_until(lambda: time_of_plots(tab)["is_paused"], what="the pause")
    assert not time_of_plots(tab)["is_zoomed"]
    tab.click("#plot-pause")
    wait_until(lambda: not time_of_plots(tab)["is_paused"], what="its end")
    for _ in range(2):
        tab.click("#plot-rows button")
        tab.page.wait_for_timeout(500)
    wait_until(lambda: tab.page.evaluate("state.plots.length") == 0, what="no plots")
    assert tab.page.locator(".uplot").count() == 0
    tab.click("[data-panel=frames]")
    assert tab.faults == []


def test_click_on_a_frame_in_the_scene_selects_it(browser: Any, address: str, tab: Tab) -> None:
    tab.page.goto("about:blank")  # one scene at a time is drawn
    # The camera looks at the origin of the map, close enough that its axes are many pixels long.
    close = Tab(browser, address, "&camera=-1,-1,1.2&look_at=0,0,0")
    wait_until(lambda: "base_link" in close.text("#rows"))
    box = close.page.locator("#scene").bounding_box()

    def is_selected() -> bool:
        if close.page.evaluate("document.querySelector('#selection').hidden"):
            close.page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
            close.page.wait_for_timeout(500)
        return close.text("#selection-title") == "map"

    wait_until(is_selected, what="the click on map")
    close.click("#unselect")
    close.page.close()


def test_layout_of_rviz_is_shown_and_saved_as_ours(
    browser: Any, address: str, tmp_path: Path, start_module_program: Callable[..., Program], tab: Tab
) -> None:
    assert address  # the robot publishes
    tab.page.goto("about:blank")  # one scene at a time is drawn
    config = tmp_path / "robot.rviz"
    config.write_text(RVIZ.replace("/points", "/no_points").replace("Distance: 10", "Distance: 7"))
    view = start_module_program("tfloom", "view", "--config", config, "--no-open", "--port", "0")
    opened = view.wait_for("Open http://127.0.0.1:").removeprefix("Open ")
    assert any("shown without what is not known here: the display Handles" in line for line in view.lines)
    saved = Tab(browser, opened)
    wait_until(lambda: "base_link" in saved.text("#rows"), what="the tree")
    wait_until(
        lambda: saved.page.evaluate(
            "['/robot_description', '/scan'].every(topic => state.displays.some(one => one.topic === topic && one.on))"
        ),
        what="the displays",
    )
    assert saved.page.evaluate("state.fixed_frame") == "odom"
    wait_until(lambda: coloured(saved.pixels()) > 300, what="the robot")
    saved.keep("layout")
    with saved.page.expect_download(timeout=LOADED_MS) as download:
        saved.click("#save-layout")
    kept = tmp_path / "kept.yaml"
    download.value.save_as(kept)
    layout, unknown = read_layout(kept)
    assert unknown == []
    assert layout.fixed_frame == "odom"
    assert {one.topic for one in layout.displays} >= {"/robot_description", "/scan", "/no_points"}
    assert layout.camera is not None
    assert layout.camera.look_at == pytest.approx((1.0, 2.0, 3.0), abs=0.01)
    assert np.linalg.norm(np.subtract(*layout.camera)) == pytest.approx(7.0, abs=0.05)
    assert saved.faults == []
    saved.page.close()


def test_page_is_shown_in_a_notebooks_frame_and_in_no_other_sites(
    browser: Any, module_domain_id: int, address: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A server at localhost stands for a notebook's; `tfloom view` itself lets nobody show it in a frame."""
    monkeypatch.setenv("ROS_DOMAIN_ID", str(module_domain_id))
    page = browser.new_page(viewport={"width": 1000, "height": 800})
    page.set_default_timeout(LOADED_MS)
    with tfloom.view() as inline_page:
        html = f"{inline_page._repr_html_()}<iframe title=refused src='{address}'></iframe>"

        def rows(title: str) -> Any:
            return page.frame_locator(f"iframe[title='{title}']").locator("#rows tr")

        with site("localhost", html) as notebook:
            page.goto(notebook)
            rows("tfloom view").first.wait_for(state="attached")
            assert rows("refused").count() == 0
            scene = page.frame_locator("iframe[title='tfloom view']").frame_locator("iframe")
            scene.locator("canvas").first.wait_for(state="attached")
            if FOLDER:
                page.screenshot(path=str(Path(FOLDER) / "notebook.png"), timeout=LOADED_MS)
        # 127.0.0.2 is a site of this machine, too, but none of those that serve notebooks.
        refusals: list[str] = []
        page.on("console", lambda message: refusals.append(message.text))
        with site("127.0.0.2", html) as elsewhere:
            page.goto(elsewhere)

            def is_refused() -> bool:
                page.wait_for_timeout(50)
                return sum("frame-ancestors" in text for text in refusals) == 2

            wait_until(is_refused, "both frames are refused")
            assert rows("tfloom view").count() == 0
    page.close()
