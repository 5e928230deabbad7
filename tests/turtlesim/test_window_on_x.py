"""The window on a virtual X server: its content, and driving, resizing and closing.

Xvfb is the server; pictures are taken from its screen by ImageMagick's `import`.
"""

from __future__ import annotations

import ctypes
import ctypes.util
import os
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PIL import Image, ImageChops
from tests.conftest import run_to_end, wait_until
from tests.spun import SpunNode, spun

from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.turtlesim.simulation import TurtleSim

pygame = pytest.importorskip("pygame", reason="the extra `turtlesim` isn't installed")
MISSING = [name for name in ("Xvfb", "xdotool", "xwininfo", "import") if shutil.which(name) is None]
pytestmark = [
    pytest.mark.skipif(
        bool(MISSING), reason=f"not installed: {', '.join(MISSING)}; the window isn't looked at"
    ),
]
TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node")
STEADY = 20
"""How often in a row a window must be found to be the one that stays."""
BACKGROUND = (69, 86, 255)
PEN = (179, 184, 255)


class Screen:
    """A virtual X server."""

    def __init__(self, name: str) -> None:
        self.name = name

    @property
    def environment(self) -> dict[str, str]:
        kept = {
            n: value for n, value in os.environ.items() if n not in {"WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}
        }
        return kept | {"DISPLAY": self.name}

    def run(self, *command: str) -> str:
        """Return a tool's output; empty if it hangs because a window was closed meanwhile."""
        try:
            done = run_to_end(command, env=self.environment, timeout_s=5)
        except subprocess.TimeoutExpired:
            return ""
        return done.stdout.strip()

    def find(self) -> str:
        """Return the window's id; empty while there is none."""
        return self.run("xdotool", "search", "--onlyvisible", "--class", "turtlesim_node").partition("\n")[0]

    def size(self, window: str) -> tuple[int, int]:
        lines = self.run("xdotool", "getwindowgeometry", "--shell", window).splitlines()
        values = dict(line.partition("=")[::2] for line in lines)
        return int(values["WIDTH"]), int(values["HEIGHT"])

    def picture(self, window: str, path: Path) -> Image.Image:
        subprocess.run(["import", "-window", window, path], env=self.environment, check=True, timeout=10)
        with Image.open(path) as file:
            picture: Image.Image = file.convert("RGB")
        return picture


@pytest.fixture(scope="module")
def screen() -> Iterator[Screen]:
    reading, writing = os.pipe()
    # Without -noreset, it restarts when the last client disconnects, and drops new connections.
    command = [
        "Xvfb",
        "-displayfd",
        str(writing),
        "-screen",
        "0",
        "1280x1024x24",
        "-nolisten",
        "tcp",
        "-noreset",
    ]
    server = subprocess.Popen(command, pass_fds=[writing], stderr=subprocess.DEVNULL)
    os.close(writing)
    with os.fdopen(reading, encoding="ascii") as numbers:
        number = numbers.readline().strip()
    try:
        assert number, "Xvfb didn't start"
        yield Screen(f":{number}")
    finally:
        server.terminate()
        server.wait()


class Watcher(SpunNode):
    """Subscribes to the turtle's pose."""

    def __init__(self, domain_id: int) -> None:
        super().__init__("watcher", domain_id)
        self.poses = self.received(Pose, "/turtle1/pose")

    def is_at_rest(self) -> bool:
        last = self.poses[-2:]
        return len(last) == 2 and last[0] == last[1] and not last[0].linear_velocity


@pytest.fixture
def watcher(module_domain_id: int) -> Iterator[Watcher]:
    with spun(Watcher(module_domain_id)) as watcher:
        yield watcher


@pytest.fixture(scope="module")
def turtlesim(screen: Screen, module_domain_id: int, start_module_program: Callable[..., Any]) -> Any:
    """The program, whose turtle the first test finds at rest and the second one moves; the third closes the window."""
    return start_module_program(*TURTLESIM, env=screen.environment)


@pytest.fixture(scope="module")
def window(turtlesim: Any, screen: Screen) -> str:
    """The window's id. Before it, the toolkit may create one or two windows, which it closes at once."""
    turtlesim.wait_for("Spawning turtle [turtle1]")
    seen: list[str] = []

    def stays() -> bool:
        seen.append(screen.find())
        return "" not in seen[-STEADY:] and len(set(seen[-STEADY:])) == 1 and len(seen) >= STEADY

    wait_until(stays, timeout_s=60)
    return seen[-1]


def expected(pose: Pose, size_px: int) -> Image.Image:
    """Render the expected picture: the turtle at its position, with a straight stroke from the centre."""
    sim = TurtleSim()
    turtle = sim.world.turtles["turtle1"]
    turtle.teleport(pose.x, pose.y, pose.theta)
    sim.step()
    return sim.render(size_px)


def unlike(picture: Image.Image, other: Image.Image) -> float:
    """Return the fraction of pixels that clearly differ."""
    assert picture.size == other.size
    difference = ImageChops.difference(picture, other).convert("L").point(lambda value: 255 * (value > 40))
    return difference.histogram()[255] / (picture.width * picture.height)


def test_picture_resolution_follows_the_window_size(window: str, screen: Screen, tmp_path: Path) -> None:
    assert '"TurtleSim"' in screen.run("xwininfo", "-id", window)
    assert screen.size(window) == (500, 500)
    screen.run("xdotool", "windowmove", window, "0", "0")

    def is_shown(size: tuple[int, int]) -> bool:
        side = min(size)
        left, top = (size[0] - side) // 2, (size[1] - side) // 2
        picture = screen.picture(window, tmp_path / "window.png")
        if picture.size != size:
            return False
        shown = picture.crop((left, top, left + side, top + side))
        return ImageChops.difference(shown, TurtleSim().render(side)).getbbox() is None

    for size in ((1000, 800), (300, 420)):
        screen.run("xdotool", "windowsize", window, *map(str, size))
        wait_until(lambda size=size: is_shown(size))


def test_window_shows_the_turtle_driven_by_keys(
    window: str,
    screen: Screen,
    watcher: Watcher,
    start_teleop: Callable[..., Any],
    press: Callable[[bytes], int],
    tmp_path: Path,
) -> None:
    screen.run("xdotool", "windowsize", window, "500", "500")
    teleop = start_teleop()
    watcher.spin_until(lambda: press(b"\x1b[A") and watcher.poses and watcher.poses[-1].x > 7.5)
    watcher.spin_until(watcher.is_at_rest)
    press(b"q")
    assert teleop.wait() == 0
    scene = expected(watcher.poses[-1], 500)
    path = tmp_path / "window.png"
    wait_until(lambda: unlike(screen.picture(window, path), scene) < 0.002)
    picture = screen.picture(window, path)
    assert picture.getpixel((5, 5)) == BACKGROUND
    assert picture.getpixel((270, 250)) == PEN
    assert unlike(picture, expected(Pose(x=5.5, y=5.5), 500)) > 0.004, (
        "the comparison sees a turtle elsewhere"
    )


def ask_to_close(display: str, window: int) -> None:
    """Send WM_DELETE_WINDOW, as a desktop does when the user closes a window."""
    x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XInternAtom.restype = ctypes.c_ulong

    class ClientMessage(ctypes.Structure):
        _fields_ = (
            ("type", ctypes.c_int),
            ("serial", ctypes.c_ulong),
            ("send_event", ctypes.c_int),
            ("display", ctypes.c_void_p),
            ("window", ctypes.c_ulong),
            ("message_type", ctypes.c_ulong),
            ("format", ctypes.c_int),
            ("data", ctypes.c_long * 5),
            ("padding", ctypes.c_long * 24),  # XEvent is a union of 24 longs
        )

    connection = ctypes.c_void_p(x11.XOpenDisplay(display.encode()))
    protocols = x11.XInternAtom(connection, b"WM_PROTOCOLS", 0)
    delete = x11.XInternAtom(connection, b"WM_DELETE_WINDOW", 0)
    client_message, bits = 33, 32
    event = ClientMessage(
        type=client_message, window=window, message_type=protocols, format=bits, data=(delete, 0, 0, 0, 0)
    )
    x11.XSendEvent(connection, ctypes.c_ulong(window), 0, ctypes.c_long(0), ctypes.byref(event))
    x11.XSync(connection, 0)
    x11.XCloseDisplay(connection)


@pytest.mark.skipif(ctypes.util.find_library("X11") is None, reason="no libX11 to ask a window to close with")
def test_closed_window_ends_the_node(turtlesim: Any, window: str, screen: Screen) -> None:
    ask_to_close(screen.name, int(window))
    assert turtlesim.wait() == 0
    assert "Traceback" not in turtlesim.output
