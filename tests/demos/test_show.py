"""`tfloom demo`: its output and drawing, and that no process is left at any end."""

from __future__ import annotations

import signal
import urllib.error
import urllib.request
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import wait_until
from tests.demos.marked import alive, kill_when_there

pytestmark = pytest.mark.wire
Start = Callable[..., Any]
DRAWN = "The tree of frames is drawn in "


def test_demonstration_prints_draws_serves_its_page_and_ends(
    start_program: Start, tmp_path: Path, mark: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """How it ends after a duration is tested in one process, and by the robot's page of the documentation."""
    pytest.importorskip("viser", reason="the page needs the extra: pip install 'tfloom[view]'")
    browser = tmp_path / "browser"
    browser.write_text(f'#!/bin/sh\necho "$1" > {tmp_path / "opened"}\n')
    browser.chmod(0o755)
    monkeypatch.setenv("BROWSER", str(browser))
    monkeypatch.delenv("CI", raising=False)
    demo = start_program("tfloom", "demo", "--view", cwd=tmp_path)
    line = demo.wait_for("See it in a browser: http://127.0.0.1:")
    address = line.removeprefix("See it in a browser: ")
    with urllib.request.urlopen(address) as response:
        assert b"<title>tfloom view</title>" in response.read()
    # The address is the last line, and what it is behind of all is there.
    assert demo.output.count("- Matrix:") >= 1
    assert f"{DRAWN}{tmp_path / 'frames.pdf'}" in demo.output
    assert len(alive(mark)) >= 9
    demo.signal(signal.SIGINT)
    assert demo.wait() == 0
    assert (tmp_path / "opened").read_text().strip() == address
    assert demo.lines[-1].startswith(("The picture of the turtles is in", "The demonstration has ended."))
    assert "At time" not in demo.output.partition("See it in a browser: ")[2]
    assert "Traceback" not in demo.output
    graph = (tmp_path / "frames.gv").read_text()
    for ends in ('"world" -> "turtle1"', '"world" -> "turtle2"', '"turtle1" -> "laser"'):
        assert ends in graph
    assert (tmp_path / "turtles.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "frames.pdf").read_bytes().startswith(b"%PDF-")
    wait_until(lambda: alive(mark) == {}, what="the end of all processes")
    with pytest.raises(urllib.error.URLError):
        urllib.request.urlopen(address)


@pytest.mark.parametrize(
    "number",  # the test above sends SIGINT
    [pytest.param(signal.SIGTERM, marks=pytest.mark.slow), signal.SIGKILL],
)
def test_no_process_is_left(start_program: Start, tmp_path: Path, mark: str, number: signal.Signals) -> None:
    demo = start_program("tfloom", "demo", cwd=tmp_path)
    demo.wait_for("At time")
    assert len(alive(mark)) >= 8
    demo.signal(number)
    assert demo.wait() == (-signal.SIGKILL if number == signal.SIGKILL else 0)
    wait_until(lambda: alive(mark) == {}, what="the end of all processes")
    assert "Traceback" not in demo.output


def test_program_that_ends_unexpectedly_is_reported(start_program: Start, tmp_path: Path, mark: str) -> None:
    demo = start_program("tfloom", "demo", cwd=tmp_path)
    kill_when_there("curve_driver", mark)
    assert demo.wait() == 1
    assert "driver ended unexpectedly with exit code -9" in demo.output
    assert alive(mark) == {}
