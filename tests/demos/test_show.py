"""`tfloom demo`: its output and drawing, and that no process is left at any end."""

from __future__ import annotations

import os
import signal
import sys
import urllib.error
import urllib.request
import uuid
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.wire
DRAWN = "The tree of frames is drawn in "


@pytest.fixture
def mark(monkeypatch: pytest.MonkeyPatch) -> str:
    """An environment variable that marks all processes of the demonstration."""
    if sys.platform != "linux":
        pytest.skip("processes are found in /proc, which Linux has")
    value = str(uuid.uuid4())
    monkeypatch.setenv("TFLOOM_TEST_MARK", value)
    return f"TFLOOM_TEST_MARK={value}"


def read(path: Path) -> bytes:
    """Return the content of a file under /proc; empty if its process has ended."""
    try:
        return path.read_bytes()
    except OSError:
        return b""


def alive(mark: str) -> dict[int, str]:
    """Return the commands of the marked processes, by process id."""
    return {
        int(folder.name): read(folder / "cmdline").replace(b"\0", b" ").decode()
        for folder in Path("/proc").glob("[0-9]*")
        if mark.encode() in read(folder / "environ")
    }


def test_demonstration_prints_draws_and_ends(
    start_program: Callable[..., Any], tmp_path: Path, mark: str
) -> None:
    demo = start_program("tfloom", "demo", "--seconds", "1", cwd=tmp_path)
    assert demo.wait(60.0) == 0
    assert f"{DRAWN}{tmp_path / 'frames.pdf'}" in demo.lines
    assert demo.output.count("- Matrix:") >= 3
    graph = (tmp_path / "frames.gv").read_text()
    for ends in ('"world" -> "turtle1"', '"world" -> "turtle2"', '"turtle1" -> "laser"'):
        assert ends in graph
    assert (tmp_path / "turtles.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "frames.pdf").read_bytes().startswith(b"%PDF-")
    assert alive(mark) == {}


def test_page_is_served_beside_the_demonstration(
    start_program: Callable[..., Any], tmp_path: Path, mark: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("viser", reason="the page needs the extra: pip install 'tfloom[view]'")
    browser = tmp_path / "browser"
    browser.write_text(f'#!/bin/sh\necho "$1" > {tmp_path / "opened"}\n')
    browser.chmod(0o755)
    monkeypatch.setenv("BROWSER", str(browser))
    demo = start_program("tfloom", "demo", "--view", cwd=tmp_path)
    demo.wait_for("See it in a browser: http://127.0.0.1:")
    line = next(line for line in demo.lines if line.startswith("See it in a browser: "))
    address = line.removeprefix("See it in a browser: ")
    with urllib.request.urlopen(address) as response:
        assert b"<title>tfloom view</title>" in response.read()
    demo.signal(signal.SIGINT)
    assert demo.wait() == 0
    assert (tmp_path / "opened").read_text().strip() == address
    assert alive(mark) == {}
    with pytest.raises(urllib.error.URLError):
        urllib.request.urlopen(address)


@pytest.mark.parametrize(
    "number", [signal.SIGINT, pytest.param(signal.SIGTERM, marks=pytest.mark.slow), signal.SIGKILL]
)
def test_no_process_is_left(
    start_program: Callable[..., Any],
    wait_until: Callable[..., None],
    tmp_path: Path,
    mark: str,
    number: signal.Signals,
) -> None:
    demo = start_program("tfloom", "demo", cwd=tmp_path)
    demo.wait_for("At time")
    assert len(alive(mark)) >= 8
    demo.signal(number)
    assert demo.wait() == (-signal.SIGKILL if number == signal.SIGKILL else 0)
    wait_until(lambda: alive(mark) == {}, what="the end of all processes")
    assert "Traceback" not in demo.output


def test_program_that_ends_unexpectedly_is_reported(
    start_program: Callable[..., Any], tmp_path: Path, mark: str
) -> None:
    demo = start_program("tfloom", "demo", cwd=tmp_path)
    demo.wait_for("At time")
    (driver,) = (process for process, command in alive(mark).items() if "curve_driver" in command)
    os.kill(driver, signal.SIGKILL)
    assert demo.wait() == 1
    assert "driver ended unexpectedly with exit code -9" in demo.output
    assert alive(mark) == {}
