"""A clone installed by pip, uv and pipx, each into a separate folder: each results in a working `ros2`.

Only pip compiles the clone. In its place uv and pipx get the wheel of a release, because each would compile the same
files with the same backend, for a minute. The command `ros2`, in Python alone, each of them builds from the clone; and
uv reads the clone's own project, too.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.wheels import copy_checkout, path_with_cmake, release_files, wheel_of

ROOT = Path(__file__).parents[2]
COMMAND = "./packages/tfloom-ros2"
INTERFACES = "./packages/tfloom-interfaces"
SENSING = "./packages/tfloom-sensing"
TIMEOUT_S = 600.0

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(os.name != "posix", reason="the places of commands are POSIX's"),
]


@pytest.fixture(scope="module")
def tools(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Install uv and pipx, and return the folder of their commands."""
    folder = tmp_path_factory.mktemp("tools")
    subprocess.run([sys.executable, "-m", "venv", folder], check=True, timeout=TIMEOUT_S)
    run(folder, folder / "bin" / "python", "-m", "pip", "install", "--quiet", "uv", "pipx")
    return folder / "bin"


@pytest.fixture(scope="module")
def clone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return copy_checkout(tmp_path_factory.mktemp("a clone") / "tfloom")


@pytest.fixture(scope="module")
def with_extras(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Return the requirement of a release's wheel with all extras."""
    return f"tfloom[all] @ {wheel_of(release_files(tmp_path_factory), 'tfloom').as_uri()}"


def run(home: Path, *command: str | Path, cwd: Path = ROOT, **environment: object) -> None:
    """Run an installer with a separate home folder; fail with its output."""
    variables = {name: value for name, value in os.environ.items() if name != "VIRTUAL_ENV"}
    done = subprocess.run(
        command,
        cwd=cwd,
        env=variables | {"HOME": str(home)} | {name: str(value) for name, value in environment.items()},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        check=False,
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"


def expect_working(ros2: Path) -> None:
    """Run commands that read definitions and the native codec's plans, without joining a domain."""
    for arguments, expected in (
        (["interface", "show", "geometry_msgs/msg/Vector3"], "float64 x"),
        (["pkg", "executables", "turtlesim"], "turtlesim turtlesim_node"),
    ):
        done = run_to_end([ros2, *arguments])
        assert expected in done.stdout, done.stdout + done.stderr


def expect_commands(folder: Path) -> None:
    """Run the commands that docs/install.md promises of uv and pipx."""
    for name in ("ros2", "tfloom"):
        expect_working(folder / name)
    for name in ("colcon", "xacro"):
        subprocess.run([folder / name, "--help"], check=True, capture_output=True, timeout=60)


def test_pip_installs_all_packages(clone: Path, tmp_path: Path) -> None:
    subprocess.run([sys.executable, "-m", "venv", tmp_path / "venv"], check=True, timeout=TIMEOUT_S)
    python = tmp_path / "venv" / "bin" / "python"
    install = [python, "-m", "pip", "install", "--quiet", ".[all]", COMMAND, INTERFACES, SENSING]
    run(tmp_path, *install, cwd=clone, PATH=path_with_cmake())
    expect_working(tmp_path / "venv" / "bin" / "ros2")
    run(tmp_path, python, "-c", "from nav2_msgs.action import NavigateToPose; NavigateToPose.Goal()")
    run(tmp_path, python, "-c", "from diagnostic_updater import Updater; from cv_bridge import CvBridge")
    definition = tmp_path / "ws" / "share" / "my_interfaces" / "msg" / "Ball.msg"
    definition.parent.mkdir(parents=True)
    definition.write_text("float64 radius\n")
    code = "from my_interfaces.msg import Ball; Ball(radius=1.0)"
    run(tmp_path, python, "-c", code, cwd=tmp_path, AMENT_PREFIX_PATH=tmp_path / "ws")


@pytest.fixture(scope="module")
def home_of_uv(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a home where uv keeps what it has downloaded and built."""
    return tmp_path_factory.mktemp("home")


def test_uv_pip_installs_both_packages(
    tools: Path, clone: Path, home_of_uv: Path, with_extras: str, tmp_path: Path
) -> None:
    venv = tmp_path / "venv"
    run(home_of_uv, tools / "uv", "venv", "--python", sys.executable, venv, cwd=clone)
    install = [tools / "uv", "pip", "install"]
    run(home_of_uv, *install, "--dry-run", ".[all]", COMMAND, cwd=clone, VIRTUAL_ENV=venv)
    run(home_of_uv, *install, with_extras, COMMAND, cwd=clone, VIRTUAL_ENV=venv)
    expect_working(venv / "bin" / "ros2")


def test_uv_installs_a_tool(
    tools: Path, clone: Path, home_of_uv: Path, with_extras: str, tmp_path: Path
) -> None:
    folders = {"UV_TOOL_DIR": tmp_path / "tools", "UV_TOOL_BIN_DIR": tmp_path / "bin"}
    command = ["tool", "install", "--python", sys.executable, with_extras, "--with", COMMAND]
    from_packages = ["--with-executables-from", "tfloom-ros2,colcon-core,xacro"]
    run(home_of_uv, tools / "uv", *command, *from_packages, cwd=clone, **folders)
    expect_commands(tmp_path / "bin")


def test_pipx_installs_and_injects(
    tools: Path, clone: Path, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """The lines of docs/install.md, in a clone whose path has a space, with a wheel that is there."""
    wheel = wheel_of(release_files(tmp_path_factory), "tfloom")
    built = clone / "build" / "wheel"
    built.mkdir(parents=True, exist_ok=True)  # a second try has the same clone
    shutil.copy(wheel, built)
    assert " " in str(clone)
    lines = [
        line for line in (ROOT / "docs/install.md").read_text().splitlines() if line.startswith("pipx i")
    ]
    assert len(lines) == 3
    folders = {"PIPX_HOME": tmp_path / "pipx", "PIPX_BIN_DIR": tmp_path / "bin"}
    path = f"{tools}{os.pathsep}{os.environ['PATH']}"
    script = "set -e\n" + "\n".join(lines)
    run(tmp_path, "bash", "-c", script, cwd=clone, PATH=path, PIPX_DEFAULT_PYTHON=sys.executable, **folders)
    expect_commands(tmp_path / "bin")
