"""User programs with ROS's names pass mypy --strict and pyright, against an editable install and against a wheel.

pyright is run as basedpyright, which brings its JavaScript in wheels, with the rules that pyright has by default.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import sysconfig
import venv
from collections.abc import Iterable
from pathlib import Path

import pytest
from tests.wheels import release_files, wheel_of
from tools.facades import recorded

pytestmark = pytest.mark.slow
ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"


def is_checked(path: Path) -> bool:
    """Return whether a program's imports are in the wheel's environment, which has no numpy."""
    return path.name != "setup.py" and "import numpy" not in path.read_text("utf-8")


MISTAKES = Path(__file__).parent / "mistakes.py"
PROGRAMS = [
    *sorted((Path(__file__).parent / "programs").glob("*.py")),
    *sorted(path for path in EXAMPLES.glob("*/*.py") if is_checked(path)),
    *sorted((EXAMPLES / "turtle_frames" / "turtle_frames").glob("*.py")),
]


def mypy(python: Path, *programs: Path, cache: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file=", f"--cache-dir={cache}"]
    command += [f"--python-executable={python}", *map(str, programs)]
    return subprocess.run(command, capture_output=True, text=True, timeout=300, cwd=cache, check=False)


def pyright(python: Path, *programs: Path, folder: Path) -> list[str]:
    """Return the errors that pyright finds, as `file:line: text`."""
    settings = {
        "typeCheckingMode": "standard",
        "pythonVersion": "3.10",
        "extraPaths": [str(EXAMPLES / "robot_in_a_room")],  # its programs import each other
    }
    (folder / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [sys.executable, "-m", "basedpyright", "--outputjson", f"--pythonpath={python}"]
    done = subprocess.run(
        [*command, *map(str, programs)], capture_output=True, text=True, timeout=300, cwd=folder, check=False
    )
    report = json.loads(done.stdout)
    assert report["summary"]["filesAnalyzed"] >= len(programs)
    return [
        f"{diagnostic['file']}:{diagnostic['range']['start']['line'] + 1}: {diagnostic['message']}"
        for diagnostic in report["generalDiagnostics"]
        if diagnostic["severity"] == "error"
    ]


@pytest.fixture(scope="session")
def wheel_python(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Install wheels of a release into a fresh environment, and return that environment's Python."""
    folder = tmp_path_factory.mktemp("wheel")
    files = release_files(tmp_path_factory)
    wheels = [wheel_of(files, name) for name in ("tfloom", "tfloom_interfaces", "tfloom_sensing")]
    venv.create(folder / "venv", symlinks=True)
    python = folder / "venv" / Path(sysconfig.get_path("scripts")).name / "python"
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--quiet", "--python", str(python)]
    subprocess.run([*pip, "install", "--no-deps", *map(str, wheels)], check=True, timeout=300)
    return python


def test_programs_pass_against_the_editable_install(tmp_path: Path) -> None:
    result = mypy(Path(sys.executable), *PROGRAMS, cache=tmp_path)
    assert result.returncode == 0, result.stdout


def test_programs_pass_against_a_wheel(wheel_python: Path, tmp_path: Path) -> None:
    result = mypy(wheel_python, *PROGRAMS, cache=tmp_path)
    assert result.returncode == 0, result.stdout


def test_programs_pass_pyright_against_the_editable_install(tmp_path: Path) -> None:
    assert pyright(Path(sys.executable), *PROGRAMS, folder=tmp_path) == []


def test_programs_pass_pyright_against_a_wheel(wheel_python: Path, tmp_path: Path) -> None:
    assert pyright(wheel_python, *PROGRAMS, folder=tmp_path) == []


def lines_of(reported: Iterable[str]) -> list[int]:
    """Return the lines of errors in the file of mistakes."""
    matches = (re.match(rf"{re.escape(str(MISTAKES))}:(\d+): (?!note)", line) for line in reported)
    return sorted(int(match[1]) for match in matches if match)


@pytest.mark.parametrize("checker", ["mypy", "pyright"])
def test_each_mistake_is_found_and_nothing_else(checker: str, tmp_path: Path) -> None:
    lines = MISTAKES.read_text("utf-8").splitlines()
    planted = [number for number, line in enumerate(lines, 1) if line.endswith("  # mistake")]
    assert len(planted) == 12
    python = Path(sys.executable)
    if checker == "mypy":
        reported = mypy(python, MISTAKES, cache=tmp_path).stdout.splitlines()
    else:
        reported = pyright(python, MISTAKES, folder=tmp_path)
    assert lines_of(reported) == planted, "\n".join(reported)


def test_every_public_name_passes_mypy_and_pyright(tmp_path: Path) -> None:
    reasons = recorded.missing()
    names = [
        name
        for name in recorded.all_names()
        if "." not in name.path and not recorded.reason_for(name, reasons)
    ]
    lines = [f"from {name.module} import {name.path} as name_{number}" for number, name in enumerate(names)]
    modules = ["import rclpy, std_msgs", "rclpy.time.Time().nanoseconds + 1", "std_msgs.msg.Bool(data=True)"]
    program = tmp_path / "all_names.py"
    program.write_text("\n".join([*lines, *modules, ""]))
    assert len(names) > 800
    result = mypy(Path(sys.executable), program, cache=tmp_path)
    assert result.returncode == 0, result.stdout
    assert pyright(Path(sys.executable), program, folder=tmp_path) == []


def test_names_that_a_facade_lacks_are_rejected_by_mypy_and_pyright(tmp_path: Path) -> None:
    program = tmp_path / "wrong.py"
    program.write_text(
        "import rclpy, std_msgs\nfrom rclpy.client import Parameter\nrclpy.spn\nstd_msgs.srv\n"
    )
    result = mypy(Path(sys.executable), program, cache=tmp_path)
    assert result.stdout.count("attr-defined") == 3, result.stdout
    assert len(pyright(Path(sys.executable), program, folder=tmp_path)) == 3


def test_wrong_program_is_rejected_by_mypy(tmp_path: Path) -> None:
    program = tmp_path / "wrong.py"
    program.write_text("from geometry_msgs.msg import Vector3\n\nVector3(x='one')\nVector3().nope\n")
    result = mypy(Path(sys.executable), program, cache=tmp_path)
    assert "arg-type" in result.stdout
    assert "attr-defined" in result.stdout


def test_a_wheel_puts_the_ros_names_last_on_the_path(wheel_python: Path) -> None:
    code = "import sys; print(*(path.replace('\\\\', '/').rpartition('site-packages/')[2] for path in sys.path[-3:]))"
    result = subprocess.run(
        [wheel_python, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert result.stdout == "tfloom/ros_names tfloom_interfaces/ros_names tfloom_sensing/ros_names\n"
