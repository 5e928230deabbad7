"""The turtlesim and tf2 tutorial from start to end: each program a process, over DDS on loopback."""

from __future__ import annotations

import math
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import COLCON_PYTHON, run_to_end

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs bash")

ROOT = Path(__file__).parents[1]
BIN = Path(sys.executable).parent
TWIST = "{linear: {x: 0.5}, angular: {z: 1.0}}"


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Build the example package with colcon."""
    folder = tmp_path / "workspace"
    shutil.copytree(ROOT / "examples" / "turtle_frames", folder / "src" / "turtle_frames")
    result = run_to_end(
        [BIN / "colcon", "build", "--packages-select", "turtle_frames"],
        cwd=folder,
        env={**os.environ, "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}"},
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return folder


def ros2(*words: str) -> list[str]:
    """Run a command to its end and return the words that it prints."""
    result = run_to_end([BIN / "tfloom", *words], timeout_s=60, stdin=subprocess.DEVNULL)
    assert result.returncode == 0, result.stderr
    return result.stdout.split()


def test_tutorial_runs_from_start_to_end(
    domain_id: int,
    tmp_path: Path,
    workspace: Path,
    start_program: Callable[..., Any],
    wait_until: Callable[..., None],
) -> None:
    turtlesim = start_program("tfloom", "run", "turtlesim", "turtlesim_node")
    turtlesim.wait_for("Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]")
    poses = start_program("tfloom", "topic", "echo", "--csv", "/turtle1/pose")
    driver = start_program(
        "tfloom", "topic", "pub", "--rate", "1", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", TWIST
    )
    driver.wait_for(
        "publishing #2: geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=0.5, y=0.0, z=0.0)"
    )
    poses.wait_for(",0.5,1.0")

    line = f"source '{workspace}/install/setup.bash' && exec '{BIN / 'tfloom'}' run turtle_frames broadcaster"
    broadcaster = start_program("bash", "-c", line, env=os.environ | COLCON_PYTHON)
    broadcaster.wait_for("[broadcaster]: Broadcasting world to turtle1")
    assert ros2("node", "list") == ["/broadcaster", "/turtlesim"]
    assert "/tf" in ros2("topic", "list")

    driver.signal(2)
    assert driver.wait() == 2
    wait_until(lambda: poses.lines[-1].endswith(",0.0,0.0"))
    x, y, theta, *_ = (float(value) for value in poses.lines[-1].split(","))
    echo = start_program("tfloom", "run", "tf2_ros", "tf2_echo", "world", "turtle1")
    echo.wait_for(f"- Translation: [{x:.3f}, {y:.3f}, 0.000]")
    # Beyond a third of a turn, which a turtle can reach on a slow machine, tf2 makes z positive, not w.
    sign = -1.0 if theta < -math.tau / 3 else 1.0
    echo.wait_for(f"[0.000, 0.000, {sign * math.sin(theta / 2):.3f}, {sign * math.cos(theta / 2):.3f}]")
    row = (math.cos(theta), -math.sin(theta), 0.0, x)
    echo.wait_for("".join(f"{value:7.3f}" for value in row))

    pictures = start_program("tfloom", "run", "tf2_tools", "view_frames", "--wait-time", "1", cwd=tmp_path)
    assert pictures.wait() == 0
    assert (tmp_path / "frames.pdf").read_bytes().startswith(b"%PDF-")
    stamped = [path.name for path in tmp_path.iterdir() if re.fullmatch(r"frames_.*\.(gv|pdf)", path.name)]
    assert len(stamped) == 2
    graph = next(tmp_path.glob("frames_*.gv")).read_text()
    assert '"world" -> "turtle1"' in graph

    for program in (broadcaster, echo, turtlesim):
        program.signal(2)
    assert [program.wait() for program in (echo, turtlesim)] == [0, 0]
    broadcaster.wait()
    assert "Traceback" not in broadcaster.output
