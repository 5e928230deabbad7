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

import pytest
from tests.conftest import COLCON_PYTHON, run_to_end

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs bash and a pseudo-terminal")

ROOT = Path(__file__).parents[1]
BIN = Path(sys.executable).parent
IN_A_TERMINAL = "import pty, sys; pty.spawn(sys.argv[1:])"
TWIST = "{linear: {x: 0.5}, angular: {z: 1.0}}"
UP, LEFT = "\x1b[A", "\x1b[D"


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the example package with colcon."""
    folder = tmp_path_factory.mktemp("workspace")
    shutil.copytree(ROOT / "examples" / "turtle_frames", folder / "src" / "turtle_frames")
    result = run_to_end(
        [BIN / "colcon", "build", "--packages-select", "turtle_frames"],
        cwd=folder,
        env={**os.environ, "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}"},
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return folder


@pytest.fixture
def in_workspace(workspace: Path, start_program: Callable[..., object]) -> Callable[..., object]:
    """Start a command in the environment of the sourced workspace."""

    def start(command: str) -> object:
        line = f"source '{workspace}/install/setup.bash' && exec '{BIN / 'tfloom'}' {command}"
        return start_program("bash", "-c", line, env=os.environ | COLCON_PYTHON)

    return start


def ros2(*words: str) -> str:
    """Run a command to its end and return its output."""
    result = run_to_end([BIN / "tfloom", *words], timeout_s=60, stdin=subprocess.DEVNULL)
    assert result.returncode == 0, result.stderr
    return result.stdout


def pose() -> tuple[float, ...]:
    """Return the turtle's x, y [m], theta [rad] and velocities."""
    return tuple(
        float(value) for value in ros2("topic", "echo", "--once", "--csv", "/turtle1/pose").split(",")
    )


def run_program(package: str, program: str, *words: str) -> list[str]:
    return ["tfloom", "run", package, program, *words]


def test_turtle_is_driven_by_keys(
    domain_id: int, start_program: Callable[..., object], wait_until: Callable[..., None]
) -> None:
    turtlesim = start_program(
        *run_program("turtlesim", "turtlesim_node", "--ros-args", "-p", "background_r:=1")
    )
    turtlesim.wait_for("Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]")
    keys = BIN / "tfloom", "run", "turtlesim", "turtle_teleop_key"
    teleop = start_program("python", "-c", IN_A_TERMINAL, *keys, stdin=subprocess.PIPE)
    teleop.wait_for("Reading from keyboard")
    start = pose()
    wait_until(lambda: "/teleop_turtle" in ros2("node", "list"))

    def press(key: str) -> None:
        teleop.process.stdin.write(key)
        teleop.process.stdin.flush()

    press(UP)
    wait_until(lambda: pose()[0] > start[0] + 0.5)
    press(LEFT)
    wait_until(lambda: pose()[2] > 0.5)
    press("q")
    assert teleop.wait() == 0


def test_tutorial_runs_from_start_to_end(
    domain_id: int,
    tmp_path: Path,
    start_program: Callable[..., object],
    in_workspace: Callable[..., object],
    wait_until: Callable[..., None],
) -> None:
    turtlesim = start_program(*run_program("turtlesim", "turtlesim_node"))
    turtlesim.wait_for("Spawning turtle [turtle1]")
    driver = start_program(
        "tfloom", "topic", "pub", "--rate", "1", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", TWIST
    )
    driver.wait_for(
        "publishing #2: geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=0.5, y=0.0, z=0.0)"
    )
    assert pose()[3:] == (0.5, 1.0)

    broadcaster = in_workspace("run turtle_frames broadcaster")
    broadcaster.wait_for("[broadcaster]: Broadcasting world to turtle1")
    assert ros2("node", "list").split() == ["/broadcaster", "/turtlesim"]
    assert "/tf" in ros2("topic", "list").split()

    driver.signal(2)
    assert driver.wait() == 2
    wait_until(lambda: pose()[3:] == (0.0, 0.0))
    x, y, theta, *_ = pose()
    echo = start_program(*run_program("tf2_ros", "tf2_echo", "world", "turtle1"))
    echo.wait_for(f"- Translation: [{x:.3f}, {y:.3f}, 0.000]")
    # Beyond a third of a turn, which a turtle can reach on a slow machine, tf2 makes z positive, not w.
    sign = -1.0 if theta < -math.tau / 3 else 1.0
    echo.wait_for(f"[0.000, 0.000, {sign * math.sin(theta / 2):.3f}, {sign * math.cos(theta / 2):.3f}]")
    row = (math.cos(theta), -math.sin(theta), 0.0, x)
    echo.wait_for("".join(f"{value:7.3f}" for value in row))

    pictures = start_program(*run_program("tf2_tools", "view_frames", "--wait-time", "1"), cwd=tmp_path)
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


@pytest.mark.parametrize("victim", ["turtlesim", "broadcaster"])
def test_restarted_program_restores_the_transform(
    victim: str,
    domain_id: int,
    start_program: Callable[..., object],
    in_workspace: Callable[..., object],
    wait_until: Callable[..., None],
) -> None:
    start = {
        "turtlesim": lambda: start_program(*run_program("turtlesim", "turtlesim_node")),
        "broadcaster": lambda: in_workspace("run turtle_frames broadcaster"),
    }
    programs = {name: begin() for name, begin in start.items()}
    echo = start_program(*run_program("tf2_ros", "tf2_echo", "world", "turtle1", "10"))
    echo.wait_for("- Translation: [5.544, 5.544, 0.000]")

    programs[victim].signal(9)
    assert programs[victim].wait() == -9

    def stamps() -> set[str]:
        return {line for line in echo.lines if line.startswith("At time ")}

    start[victim]()
    known = stamps()
    wait_until(lambda: len(stamps() - known) > 3)
    assert echo.process.poll() is None
