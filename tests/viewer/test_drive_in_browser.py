"""Robots that are driven in a browser: whatever becomes of the page while a key or the stick is held, they stop."""

from __future__ import annotations

import base64
import itertools
import json
import shutil
import signal
import socket
import threading
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import psutil
import pytest
from tests.conftest import Program, wait_until
from tests.viewer.test_driving import Robot
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node.node import Node
from tfloom.viewer.driving.driver import SILENCE_S
from tfloom.viewer.program import Viewer

# A browser that draws without a graphics card takes a core for itself: beside compilers it would take minutes.
pytestmark = [pytest.mark.slow, pytest.mark.timing]
BROWSER = shutil.which("chromium")
FLAGS = [
    *("--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"),
    *("--disable-component-update", "--disable-sync", "--proxy-server=direct://", "--touch-events=enabled"),
    *("--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1", "--remote-debugging-port=0"),
]
TIMEOUT_S = 60.0
ALONE_S = 1.5
"""How long nothing may move a robot that was stopped [s]: three times the silence that stops it."""
SCENE = "<!doctype html><body tabindex=0>scene</body>"


class Browser:
    """Chromium, spoken to by its debugging port, so that nothing stands between the test and what happens to a page."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.port = program.wait_for("DevTools listening on ", TIMEOUT_S).split(":")[-1].partition("/")[0]

    def targets(self) -> list[dict[str, Any]]:
        with urllib.request.urlopen(f"http://127.0.0.1:{self.port}/json") as response:
            return json.load(response)  # type: ignore[no-any-return]

    def new(self) -> dict[str, Any]:
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}/json/new?about:blank", method="PUT")
        with urllib.request.urlopen(request) as response:
            return json.load(response)  # type: ignore[no-any-return]

    def do(self, what: str, target: str) -> None:
        with urllib.request.urlopen(f"http://127.0.0.1:{self.port}/json/{what}/{target}"):
            pass

    def processes(self) -> list[psutil.Process]:
        first = psutil.Process(self.program.process.pid)
        return [first, *first.children(recursive=True)]


class DrivenTab:
    """A tab whose page drives a robot; a plain page stands for the scene, which software would draw slowly."""

    def __init__(self, browser: Browser, address: str, robot: Robot) -> None:
        self.browser = browser
        self.robot = robot
        self.others: list[str] = []
        """Tabs that came to the front."""
        self._numbers = itertools.count(1)
        target = browser.new()
        self.id = target["id"]
        self._socket = connect(target["webSocketDebuggerUrl"], max_size=None, proxy=None, ping_interval=None)
        self.cdp("Fetch.enable", patterns=[{"urlPattern": "*/scene/*"}])
        self.cdp("Page.enable")
        self.cdp("Page.bringToFront")
        self.cdp("Page.navigate", url=address)
        self.choose()

    def cdp(self, method: str, **parameters: Any) -> Any:
        """Call a method of the debugging protocol, and return its result."""
        number = next(self._numbers)
        self._socket.send(json.dumps({"id": number, "method": method, "params": parameters}))
        end_s = time.monotonic() + TIMEOUT_S
        while True:
            message = json.loads(self._socket.recv(timeout=end_s - time.monotonic()))
            self._take(message)
            if message.get("id") == number:
                assert "error" not in message, (method, message)
                return message["result"]

    def _take(self, message: dict[str, Any]) -> None:
        if message.get("method") == "Fetch.requestPaused":
            fulfilled = {
                "requestId": message["params"]["requestId"],
                "responseCode": 200,
                "responseHeaders": [{"name": "Content-Type", "value": "text/html"}],
                "body": base64.b64encode(SCENE.encode()).decode(),
            }
            self._socket.send(
                json.dumps({"id": next(self._numbers), "method": "Fetch.fulfillRequest", "params": fulfilled})
            )

    def js(self, expression: str) -> Any:
        return self.cdp("Runtime.evaluate", expression=expression, returnByValue=True)["result"].get("value")

    def choose(self) -> None:
        """Choose the tool when the page knows of the robot."""
        self.wait_for(
            "document.body && document.body.dataset.ready === 'yes' && state && "
            "state.drive_topics.includes('/cmd_vel')"
        )
        self.js("chooseTool('drive')")

    def wait_for(self, expression: str) -> None:
        wait_until(lambda: self.js(f"Boolean({expression})"), TIMEOUT_S, expression)

    def end(self) -> None:
        for tab in (self.id, *self.others):
            with suppress(OSError):
                self.browser.do("close", tab)
        self._socket.close()

    # What a user does.

    def hold_key(self) -> None:
        self.js("window.focus(); document.activeElement.blur()")
        self.key("rawKeyDown")

    def key(self, kind: str) -> None:
        self.cdp("Input.dispatchKeyEvent", type=kind, code="KeyW", key="w", windowsVirtualKeyCode=87)

    def hold_key_in_the_scene(self) -> None:
        self.wait_for(
            "$('scene').contentWindow.location.pathname === '/scene/' && "
            "$('scene').contentDocument.readyState === 'complete'"
        )
        self.js("$('scene').contentWindow.focus()")
        self.key("rawKeyDown")

    def _middle(self) -> dict[str, float]:
        x, y = self.js(
            "(() => { const b = $('stick').getBoundingClientRect(); return [b.left + 70, b.top + 70]; })()"
        )
        return {"x": x, "y": y}

    def touch_stick(self) -> None:
        middle = self._middle()
        self.touch("touchStart", [middle])
        self.touch("touchMove", [{**middle, "y": middle["y"] - 40}])

    def touch(self, kind: str, points: list[dict[str, float]]) -> None:
        self.cdp("Input.dispatchTouchEvent", type=kind, touchPoints=points)

    def drag_stick(self) -> None:
        middle = self._middle()
        self.mouse("mousePressed", middle)
        self.mouse("mouseMoved", {**middle, "y": middle["y"] - 40})

    def mouse(self, kind: str, point: dict[str, float]) -> None:
        self.cdp("Input.dispatchMouseEvent", type=kind, button="left", buttons=1, clickCount=1, **point)

    def tilt_gamepad(self) -> None:
        self.js("navigator.getGamepads = () => [{ axes: [0, -1], buttons: [] }]")

    # What becomes of the page.

    def go_behind(self) -> None:
        self.others.append(self.browser.new()["id"])
        self.browser.do("activate", self.others[-1])
        self.wait_for("document.hidden")

    def freeze(self) -> None:
        self.cdp("Page.setWebLifecycleState", state="frozen")

    def freeze_and_thaw(self) -> None:
        self.freeze()
        wait_until(lambda: self.robot.is_stopped, TIMEOUT_S, "the stop")
        self.cdp("Page.setWebLifecycleState", state="active")

    def go_offline(self) -> None:
        self.cdp("Network.enable")
        self.cdp(
            "Network.emulateNetworkConditions",
            offline=True,
            latency=0,
            downloadThroughput=0,
            uploadThroughput=0,
        )

    def sleep(self) -> None:
        """The machine sleeps: nothing of the browser runs, and what is held is let go meanwhile."""
        processes = self.browser.processes()
        for process in processes:
            process.send_signal(signal.SIGSTOP)
        try:
            wait_until(lambda: self.robot.is_stopped, TIMEOUT_S, "the stop")
        finally:
            for process in processes:
                process.send_signal(signal.SIGCONT)

    def leave(self) -> None:
        self.cdp("Page.navigate", url="about:blank")

    def reload(self) -> None:
        self.cdp("Page.reload")
        wait_until(lambda: self.robot.is_stopped, TIMEOUT_S, "the stop")
        self.choose()

    def close(self) -> None:
        self.browser.do("close", self.id)

    def crash(self) -> None:
        with suppress(ConnectionClosed, TimeoutError):
            self._socket.send(json.dumps({"id": next(self._numbers), "method": "Page.crash"}))


HOLDS: dict[str, Callable[[DrivenTab], None]] = {
    "key": DrivenTab.hold_key,
    "key in the scene": DrivenTab.hold_key_in_the_scene,
    "touch": DrivenTab.touch_stick,
    "mouse": DrivenTab.drag_stick,
    "gamepad": DrivenTab.tilt_gamepad,
}
ENDS: dict[str, Callable[[DrivenTab], None]] = {
    "behind another tab": DrivenTab.go_behind,
    "frozen": DrivenTab.freeze,
    "frozen and thawed": DrivenTab.freeze_and_thaw,
    "offline": DrivenTab.go_offline,
    "slept": DrivenTab.sleep,
    "left": DrivenTab.leave,
    "loaded anew": DrivenTab.reload,
    "closed": DrivenTab.close,
    "crashed": DrivenTab.crash,
}
CASES = [(hold, end) for hold in ("key", "touch") for end in ENDS] + [
    ("key in the scene", "behind another tab"),
    ("key in the scene", "closed"),
    ("key in the scene", "slept"),
    ("mouse", "behind another tab"),
    ("gamepad", "behind another tab"),
    ("gamepad", "closed"),
]


@pytest.fixture(scope="module")
def browser(
    start_module_program: Callable[..., Program], tmp_path_factory: pytest.TempPathFactory
) -> Browser:
    return started(start_module_program, tmp_path_factory.mktemp("browser"))


def started(start: Callable[..., Program], folder: Path) -> Browser:
    if BROWSER is None:
        pytest.skip("needs Debian's Chromium: apt-get install chromium")
    return Browser(start(BROWSER, *FLAGS, f"--user-data-dir={folder}", "about:blank"))


@pytest.fixture
def robot(spun: Node) -> Robot:
    return Robot(spun)


@pytest.fixture
def driven(browser: Browser, viewer: Viewer, robot: Robot) -> Iterator[DrivenTab]:
    tab = DrivenTab(browser, viewer.pages.address, robot)
    yield tab
    tab.end()


def hold(tab: DrivenTab, how: Callable[[DrivenTab], None]) -> None:
    """Hold something until the robot moves."""
    how(tab)
    wait_until(lambda: tab.robot.velocities and tab.robot.velocities[-1][0] > 0.0, TIMEOUT_S, "a velocity")


def expect_stopped(tab: DrivenTab) -> None:
    """Wait for the stop, and see that nothing moves the robot after it."""
    wait_until(lambda: tab.robot.is_stopped, TIMEOUT_S, "the stop")
    count = len(tab.robot.velocities)
    time.sleep(ALONE_S)
    assert [velocity for velocity in tab.robot.velocities[count:] if velocity != (0.0, 0.0)] == []


@pytest.mark.parametrize(("held", "end"), CASES, ids=[f"{held}, {end}" for held, end in CASES])
def test_robot_is_stopped_and_stands_when_a_page_is(driven: DrivenTab, held: str, end: str) -> None:
    hold(driven, HOLDS[held])
    ENDS[end](driven)
    expect_stopped(driven)


@pytest.mark.parametrize("kind", ["touchEnd", "touchCancel"])
def test_touch_that_ends_in_either_way_lets_the_stick_go(driven: DrivenTab, kind: str) -> None:
    for _ in range(2):
        hold(driven, DrivenTab.touch_stick)
        driven.touch(kind, [])
        expect_stopped(driven)
        assert driven.js("stick") == [0, 0]


def test_finger_that_rests_on_the_stick_drives_on_and_a_menu_elsewhere_lets_go(driven: DrivenTab) -> None:
    hold(driven, DrivenTab.touch_stick)
    menu = "dispatchEvent(new MouseEvent('contextmenu', { bubbles: true, cancelable: true }))"
    assert driven.js(f"$('stick').{menu}") is False  # no menu is shown
    assert driven.js("stick") != [0, 0]
    driven.js(f"document.body.{menu}")
    expect_stopped(driven)


def test_key_that_is_let_go_over_a_field_is_let_go(driven: DrivenTab) -> None:
    hold(driven, DrivenTab.hold_key)
    driven.js("openPanel('log'); $('log-node').focus()")
    driven.key("keyUp")
    expect_stopped(driven)


def test_shortcut_of_the_browser_moves_nothing(driven: DrivenTab) -> None:
    driven.js(
        "dispatchEvent(new KeyboardEvent('keydown', { code: 'KeyS', key: 's', ctrlKey: true, bubbles: true }))"
    )
    assert driven.js("held.size") == 0
    hold(driven, DrivenTab.hold_key)
    assert all(velocity[0] > 0.0 for velocity in driven.robot.velocities)


def test_robot_that_is_no_longer_chosen_is_stopped(driven: DrivenTab, spun: Node) -> None:
    others: list[Twist] = []
    spun.create_subscription(Twist, "/other/cmd_vel", others.append, 10)
    driven.wait_for("state.drive_topics.length === 2")
    driven.js("$('drive-topic').value = '/cmd_vel'")
    hold(driven, DrivenTab.hold_key)
    driven.js("$('drive-topic').value = '/other/cmd_vel'")
    expect_stopped(driven)
    wait_until(lambda: others and others[-1].linear.x > 0.0, TIMEOUT_S, "the other robot's velocity")
    driven.key("keyUp")
    wait_until(lambda: others[-1].linear.x == 0.0, TIMEOUT_S, "its stop")


@pytest.mark.parametrize("is_held", [True, False])
def test_key_moves_no_other_robot_when_nobody_listens_on_the_chosen_topic(
    driven: DrivenTab, spun: Node, is_held: bool
) -> None:
    others: list[Twist] = []
    first = spun.create_subscription(Twist, "/a/cmd_vel", lambda _: None, 10)
    spun.create_subscription(Twist, "/b/cmd_vel", others.append, 10)
    driven.wait_for("state.drive_topics.length === 3")
    driven.js("$('drive-topic').value = '/a/cmd_vel'")
    if is_held:
        driven.hold_key()
        driven.wait_for("driven === '/a/cmd_vel'")
    spun.destroy_subscription(first)
    driven.wait_for("state.drive_topics.length === 2")
    driven.hold_key()  # again, as a keyboard does
    run_on(driven, 2 * SILENCE_S)
    assert driven.js("[tool, driven]") == ["", ""]
    said = driven.js("$('message').textContent")  # by the page, or by the server
    assert said.startswith("nobody subscribes to velocities on ")
    assert "/a/cmd_vel" in said
    moved = [twist.linear.x for twist in others if twist.linear.x]
    assert moved + [velocity for velocity in driven.robot.velocities if velocity != (0.0, 0.0)] == []


def test_robot_is_stopped_when_the_browser_is_killed(
    viewer: Viewer, robot: Robot, start_program: Callable[..., Program], tmp_path: Path
) -> None:
    tab = DrivenTab(started(start_program, tmp_path), viewer.pages.address, robot)
    hold(tab, DrivenTab.hold_key)
    for process in tab.browser.processes():
        process.kill()
    expect_stopped(tab)


@contextmanager
def standing_network(viewer: Viewer) -> Iterator[tuple[int, threading.Event]]:
    """Yield the port of a way to the viewer, on which nothing moves on while the event is not set."""
    moves = threading.Event()
    moves.set()
    listener = socket.create_server(("127.0.0.1", 0))
    ends: list[socket.socket] = [listener]

    def carry(source: socket.socket, target: socket.socket) -> None:
        with suppress(OSError):
            while data := source.recv(65536):
                moves.wait()
                target.sendall(data)
        with suppress(OSError):
            target.shutdown(socket.SHUT_WR)

    def accept() -> None:
        with suppress(OSError):
            while True:
                near, _ = listener.accept()
                far = socket.create_connection(("127.0.0.1", viewer.pages._port))
                ends.extend((near, far))
                for way in ((near, far), (far, near)):
                    threading.Thread(target=carry, args=way, daemon=True).start()

    threading.Thread(target=accept, daemon=True).start()
    try:
        yield listener.getsockname()[1], moves
    finally:
        moves.set()
        for end in ends:
            with suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
            end.close()


def run_on(tab: DrivenTab, duration_s: float) -> None:
    """Wait until a page has run for some time."""
    start_s = tab.js("performance.now()") / 1000
    tab.wait_for(f"performance.now() / 1000 > {start_s + duration_s}")


def test_network_that_stands_still_and_goes_on_moves_nothing_by_what_was_said_before(
    browser: Browser, viewer: Viewer, robot: Robot
) -> None:
    with standing_network(viewer) as (port, moves):
        tab = DrivenTab(browser, f"http://127.0.0.1:{port}/", robot)
        try:
            hold(tab, DrivenTab.hold_key)
            moves.clear()
            wait_until(lambda: robot.is_stopped, TIMEOUT_S, "the stop")
            said_s = tab.js("performance.now()") / 1000
            tab.wait_for(
                f"performance.now() / 1000 > {said_s + 1.0}"
            )  # the page goes on to say that it drives
            assert tab.js("driven") == "/cmd_vel"
            tab.key("keyUp")
            run_on(tab, 2 * SILENCE_S)
            count = len(robot.velocities)
            moves.set()
            wait_until(lambda: len(robot.velocities) > count, TIMEOUT_S, "what was said last")
            expect_stopped(tab)
            assert set(robot.velocities[count:]) == {(0.0, 0.0)}
            hold(tab, DrivenTab.hold_key)  # and from now on it drives again
        finally:
            tab.end()
