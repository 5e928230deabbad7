"""turtlesim as a process: its end, its recordings, and its window on SDL's driver without a screen."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from tfloom.turtlesim.node import main

TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node")
SPAWNED = "Spawning turtle [turtle1]"


def environment(**changes: str) -> dict[str, str]:
    screenless = {
        name: value for name, value in os.environ.items() if name not in {"DISPLAY", "WAYLAND_DISPLAY"}
    }
    return screenless | changes


@pytest.mark.parametrize(("number", "ending"), [(signal.SIGINT, "gif"), (signal.SIGTERM, "png")])
def test_signal_ends_the_program_cleanly_and_its_picture_is_recorded_without_a_screen(
    domain_id: int, start_program: Callable[..., Any], tmp_path: Path, number: int, ending: str
) -> None:
    path = tmp_path / f"out.{ending}"
    program = start_program(*TURTLESIM, "--record", path, env=environment())
    program.wait_for(SPAWNED)
    program.wait_for("Running headless: ")
    program.signal(number)
    assert program.wait() == 0
    assert "Traceback" not in program.output
    with Image.open(path) as picture:
        assert picture.size == (500, 500)
        assert picture.convert("RGB").getpixel((5, 5)) == pytest.approx((69, 86, 255), abs=6)


def test_signal_during_a_step_ends_the_program_cleanly(
    domain_id: int, start_program: Callable[..., Any]
) -> None:
    """The signal arrives while the node steps, which then publishes on a closed context."""
    text = """
import os, signal, sys
from tfloom.turtlesim import node

class Struck(node.TurtlesimNode):
    def _step(self):
        os.kill(os.getpid(), signal.SIGTERM)
        super()._step()
        super()._step()  # the first only sets the clock

node.TurtlesimNode = Struck
sys.exit(node.main(["--headless"]))
"""
    program = start_program(Path(sys.executable).name, "-c", text, env=environment())
    assert program.wait() == 0, program.output
    assert "Traceback" not in program.output


def test_invalid_recording_gives_an_error_message(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--record", str(tmp_path / "out.avi")]) == 1
    assert capsys.readouterr().err.startswith("turtlesim_node: can't record to")


def test_the_window_opens_and_ends_with_the_node(domain_id: int, start_program: Callable[..., Any]) -> None:
    pytest.importorskip("pygame", reason="the extra `turtlesim` isn't installed")
    program = start_program(*TURTLESIM, env=environment(SDL_VIDEODRIVER="dummy"))
    program.wait_for(SPAWNED)
    program.signal(signal.SIGINT)
    assert program.wait() == 0
    assert "headless" not in program.output
