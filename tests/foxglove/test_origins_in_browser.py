"""What pages of other sites reach, as Chromium lets them try it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Any
from urllib.parse import urlsplit

import pytest
from tests.conftest import Program, wait_until
from tests.viewer.open_ports import open_ports
from tests.viewer.sites import site
from tests.viewer.test_browser import BROWSER, FLAGS, LOADED_MS, TIMEOUT_S
from viser import __version__

pytestmark = [pytest.mark.slow, pytest.mark.wire]
NAMES = ("evil.example", "rebound.example")
"""Names that the browser resolves to this machine: sites of others, and one that leads a page's own name here."""
TRY_ALL = """([addresses, protocols, timeout_ms]) => Promise.all(addresses.map(address => new Promise(resolve => {
    const socket = new WebSocket(address, protocols);
    socket.onmessage = () => resolve("message");
    socket.onerror = () => resolve("error");
    setTimeout(() => resolve("nothing"), timeout_ms);
})))"""
LOAD = """address => new Promise(resolve => {
    const image = new Image();
    image.onload = image.onerror = resolve;
    image.src = address;
})"""


@pytest.fixture
def browser() -> Iterator[Any]:
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="needs playwright, which `make check` installs"
    )
    if BROWSER is None:
        pytest.skip("needs Debian's Chromium: apt-get install chromium")
    rules = ", ".join(f"MAP {name} 127.0.0.1" for name in NAMES)
    with playwright.sync_playwright() as driver:
        flags = [*FLAGS, f"--host-resolver-rules={rules}"]
        made = driver.chromium.launch(executable_path=BROWSER, headless=True, args=flags)
        yield made
        made.close()


def sockets(ports: set[tuple[str, int]], *hosts: str) -> list[str]:
    return [
        f"ws://{host or address}:{port}{path}"
        for address, port in sorted(ports)
        for host in hosts
        for path in ("/", "/api")
    ]


def test_page_of_another_site_reaches_nothing(
    browser: Any, start_program: Callable[..., Program], start_bridge: Callable[..., tuple[Program, int]]
) -> None:
    bridge, port = start_bridge()
    viewer = start_program("tfloom", "view", "--no-open", "--port", "0")
    address = urlsplit(re.findall(r"http://\S+", viewer.wait_for("Open http"))[0])
    ports = open_ports(bridge.process.pid) | open_ports(viewer.process.pid)
    assert len(ports) == 4
    protocols = ["foxglove.sdk.v1", f"viser-v{__version__}"]
    page = browser.new_page()
    page.set_default_timeout(LOADED_MS)
    failures: dict[str, str] = {}
    page.on("requestfailed", lambda request: failures.update({request.url: request.failure}))
    html = "<iframe sandbox=allow-scripts srcdoc=''></iframe>"
    with site("127.0.0.1", html) as served:
        for name in NAMES:
            page.goto(served.replace("127.0.0.1", name))
            frames = [page.main_frame, *page.main_frame.child_frames]
            assert [frame.evaluate("self.origin") for frame in frames] == [
                served.replace("127.0.0.1", name).rstrip("/"),
                "null",
            ]
            for frame in frames:
                results = frame.evaluate(TRY_ALL, [sockets(ports, "", "localhost", name), protocols, 3000])
                assert set(results) <= {"error", "nothing"}
            image = f"http://127.0.0.1:{address.port}/image?topic=/camera"
            page.evaluate(LOAD, image)
            assert "BLOCKED_BY_RESPONSE" in failures.pop(image)
        # A page of this machine's own server reaches the bridge, and not what is behind it.
        page.goto(served)
        own = [f"ws://127.0.0.1:{port}/"]
        results = page.evaluate(TRY_ALL, [own, ["foxglove.sdk.v1"], 1000 * TIMEOUT_S])
        assert results == ["message"]
        behind = {(host, number) for host, number in ports if host != "127.0.0.1"}
        assert len(behind) == 2
        results = page.evaluate(TRY_ALL, [sockets(behind, "", "localhost"), protocols, 3000])
        assert set(results) <= {"error", "nothing"}
    wait_until(lambda: "pages of http://evil.example" in bridge.output)
    page.close()
