"""How quick the page is in Chromium: `python -m benchmarks.view.browser`.

It counts the pictures that Chromium draws in the scene, with 100 and with 2,000 moving frames. While a cloud of a
million points comes anew five times a second, it times how long a click on a frame's row takes until the row is
selected, and how long a stop takes from the release of the key to the robot. Chromium draws without a graphics card
here, on the same cores as everything else. There is no peer: RViz has no wheels.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import statistics
import sys
import time
from collections.abc import Iterator
from typing import Any

from playwright.sync_api import sync_playwright

from benchmarks.domain import DOMAIN_ID
from benchmarks.view.__main__ import PORT, Feeder, cores, viewer
from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node.client_library import init, try_shutdown
from tfloom.node.executing.executors import SingleThreadedExecutor

FLAGS = [
    *("--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-sync"),
    *("--disable-component-update", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
]
FEW, MANY = 100, 2_000
FRAMES_HZ = 20.0
POINTS, CLOUD_HZ = 1_000_000, 5.0
SECONDS = 10.0
CLICKS, STOPS = 20, 5
CLICK_MS = 10_000
"""How long a click may take [ms]."""
PATIENCE_MS = 120_000
PICTURES = """seconds => new Promise(done => {
  let count = 0;
  const start = performance.now();
  const next = (now) => {
    if (now - start > 1000 * seconds) done(count / (now - start) * 1000);
    else { count += 1; requestAnimationFrame(next); }
  };
  requestAnimationFrame(next);
})"""
"""The pictures that Chromium draws in a second."""
CLICK = """([frame, most_ms]) => new Promise(done => {
  const line = document.querySelector(`tr[data-frame="${frame}"]`);
  const watch = new MutationObserver(() => {
    if (!line.classList.contains("selected")) return;
    watch.disconnect();
    done(performance.now() - start);
  });
  watch.observe(line, { attributes: true });
  const start = performance.now();
  setTimeout(() => { watch.disconnect(); done(Infinity); }, most_ms);
  line.click();
})"""
"""From a click on a frame's row until the server's answer shows there [ms]; infinity if it doesn't in time."""


@contextlib.contextmanager
def opened_page() -> Iterator[Any]:
    """Open the page for the block."""
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=shutil.which("chromium"), headless=True, args=FLAGS)
        page = browser.new_page(viewport={"width": 1000, "height": 480})
        page.set_default_timeout(PATIENCE_MS)
        page.goto(f"http://127.0.0.1:{PORT}")
        page.wait_for_selector("body[data-ready=yes]")
        page.wait_for_selector("tr[data-frame]")
        yield page
        browser.close()


def scene_of(page: Any) -> Any:
    """Return the frame of the page that has the scene, once it draws."""
    scene = page.query_selector("#scene").content_frame()
    scene.wait_for_selector("canvas")
    return scene


def told(times_ms: list[float]) -> str:
    return (
        f"{statistics.median(times_ms):.0f} ms (median), {max(times_ms):.0f} ms (longest of {len(times_ms)})"
    )


def print_pictures(frames: int) -> None:
    feeder = Feeder(frames, FRAMES_HZ)
    try:
        with viewer() as process, opened_page() as page:
            scene = scene_of(page)
            time.sleep(5.0)  # what is drawn first
            per_second = scene.evaluate(PICTURES, SECONDS)
            used = cores(process)
            print(
                f"{frames} frames at {FRAMES_HZ:g} Hz: {per_second:.1f} pictures a second, server {used:.2f} cores",
                flush=True,
            )
    finally:
        feeder.close()


class Robot:
    """Hears what drives it."""

    def __init__(self, node: Any) -> None:
        self.speeds: list[float] = []
        node.create_subscription(Twist, "cmd_vel", lambda twist: self.speeds.append(twist.linear.x), 10)
        self._executor = SingleThreadedExecutor()
        self._executor.add_node(node)

    def wait(self, *, moves: bool) -> None:
        end = time.monotonic() + PATIENCE_MS / 1000
        while not self.speeds or (self.speeds[-1] != 0.0) != moves:
            assert time.monotonic() < end, self.speeds[-5:]
            self._executor.spin_once(0.01)


def print_answers() -> None:
    feeder = Feeder(FEW, FRAMES_HZ, POINTS, CLOUD_HZ)
    robot = Robot(feeder.node)
    try:
        with viewer(), opened_page() as page:
            scene_of(page)
            feeder.with_clouds = True
            page.wait_for_function("state && state.displays.some(row => row.topic === '/points')")
            page.evaluate("send({ op: 'display', topic: '/points', on: true })")
            time.sleep(5.0)
            clicks = []
            for number in range(CLICKS):
                clicks.append(page.evaluate(CLICK, [f"frame_{1 + number}", CLICK_MS]))
                time.sleep(0.1)
            print(f"{POINTS:,} points at {CLOUD_HZ:g} Hz: a click answers within {told(clicks)}", flush=True)
            page.keyboard.press("v")
            stops = []
            for _ in range(STOPS):
                page.keyboard.down("ArrowUp")
                robot.wait(moves=True)
                begun = time.monotonic()
                page.keyboard.up("ArrowUp")
                robot.wait(moves=False)
                stops.append(1000.0 * (time.monotonic() - begun))
            print(f"… and a stop of Drive reaches the robot within {told(stops)}")
    finally:
        feeder.close()


def main() -> int:
    if shutil.which("chromium") is None:
        print("not measured: there is no chromium")
        return 0
    os.environ["ROS_DOMAIN_ID"] = str(DOMAIN_ID)
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
    init()
    try:
        for frames in (FEW, MANY):
            print_pictures(frames)
        print_answers()
    finally:
        try_shutdown()  # a signal may have done so
    return 0


if __name__ == "__main__":
    sys.exit(main())
