"""A program frozen by PyInstaller, as a folder and as one file, on the graph of programs that are not frozen."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import sysconfig
import venv
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import Program, run_to_end
from tests.wheels import release_files, wheel_of

PROGRAM = Path(__file__).with_name("frozen_robot.py")
TIMEOUT_S = 600.0
DESCRIBED = "{type_name: std_msgs/msg/String, type_hash: %s, include_type_sources: true}"

SPEC = f"""\
from PyInstaller.building.api import COLLECT, EXE, PYZ
from PyInstaller.building.build_main import Analysis

analysis = Analysis([{str(PROGRAM)!r}])
pyz = PYZ(analysis.pure)
files = [analysis.binaries, analysis.datas]
EXE(pyz, analysis.scripts, *files, name="one_file")
COLLECT(EXE(pyz, analysis.scripts, name="frozen_robot", exclude_binaries=True), *files, name="one_folder")
"""
"""What `pyinstaller --onefile` and `--onedir` write, in one: the search for modules takes longest, and is the same."""

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(os.name != "posix", reason="the names of commands are POSIX's"),
]


@pytest.fixture(scope="module")
def pyinstaller(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Install tfloom's wheels and PyInstaller into a fresh environment; return the path of the command."""
    folder = tmp_path_factory.mktemp("environment")
    files = release_files(tmp_path_factory)
    wheels = [wheel_of(files, "tfloom"), wheel_of(files, "tfloom_interfaces")]
    venv.create(folder, symlinks=True)
    commands = folder / Path(sysconfig.get_path("scripts")).name
    pip = [
        sys.executable,
        "-m",
        "pip",
        "--disable-pip-version-check",
        "--quiet",
        "--python",
        str(commands / "python"),
    ]
    requirements = [*map(str, wheels), "transforms3d"]
    subprocess.run([*pip, "install", *requirements], check=True, timeout=TIMEOUT_S)
    done = run_to_end([*pip, "install", "pyinstaller>=6"], timeout_s=TIMEOUT_S)
    if done.returncode:
        pytest.skip(f"PyInstaller can't be installed: {done.stderr.strip().splitlines()[-1]}")
    return commands / "pyinstaller"


@pytest.fixture(scope="module")
def frozen(pyinstaller: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Freeze the program as a file and as a folder, and return the folder of both."""
    folder = tmp_path_factory.mktemp("frozen")
    (folder / "robot.spec").write_text(SPEC, "utf-8")
    options = ["--log-level", "WARN", "--distpath", folder, "--workpath", folder / "work"]
    command = [pyinstaller, *options, folder / "robot.spec"]
    done = run_to_end(command, timeout_s=TIMEOUT_S)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.mark.parametrize("path", ["one_folder/frozen_robot", "one_file"])
def test_frozen_program_runs_over_dds(
    path: str, frozen: Path, domain_id: int, start_program: Callable[..., Program]
) -> None:
    robot = start_program(frozen / path)
    robot.wait_for("Odometry NavigateToPose")
    # The façade nav_msgs is not in the program, which imports none of its names.
    modules = "tfloom.interfaces.nav_msgs.msg std_msgs.msg._string nav2_msgs.action._navigate_to_pose"
    robot.wait_for(f"modules: {modules}")
    start_program(
        "ros2",
        "run",
        "tf2_ros",
        "static_transform_publisher",
        "--frame-id",
        "map",
        "--child-frame-id",
        "odom",
    )
    echo = start_program("ros2", "topic", "echo", "/yaws")
    echo.wait_for("data: yaw 0.50")

    from std_msgs.msg import String

    request = DESCRIBED % String._TYPE_HASH
    service = "/robot/get_type_description"
    call = start_program(
        "ros2", "service", "call", service, "type_description_interfaces/srv/GetTypeDescription", request
    )
    call.wait_for("successful=True")
    call.wait_for("string data")

    robot.signal(signal.SIGINT)
    robot.wait_for("stopped")
    assert robot.wait() == 0, robot.output
