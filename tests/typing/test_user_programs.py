"""User programs with ROS's names pass mypy --strict and pyright, against an editable install and against a wheel.

pyright is run as basedpyright, which brings its JavaScript in wheels, with the rules that pyright has by default. Each
checker reads tfloom once for an installation, with the programs that are right and those that are wrong: reading it
takes longer than all of them.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.wheels import release_files, wheel_of
from tools.facades import recorded

pytestmark = pytest.mark.slow
ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"


def is_checked(path: Path) -> bool:
    """Return whether a program's imports are in the wheel's environment, which has no numpy."""
    return path.name != "setup.py" and "import numpy" not in path.read_text("utf-8")


MESSAGES = Path(__file__).parent / "messages.py"
MISTAKES = Path(__file__).parent / "mistakes.py"
PROGRAMS = [
    *sorted((Path(__file__).parent / "programs").glob("*.py")),
    *sorted(path for path in EXAMPLES.glob("*/*.py") if is_checked(path)),
    *sorted((EXAMPLES / "turtle_frames" / "turtle_frames").glob("*.py")),
]
WRONG_NAMES = "import rclpy, std_msgs\nfrom rclpy.client import Parameter\nrclpy.spn\nstd_msgs.srv\n"
MODULES = "import rclpy, std_msgs\nrclpy.time.Time().nanoseconds + 1\nstd_msgs.msg.Bool(data=True)\n"


def mypy(python: Path, programs: list[Path], folder: Path) -> list[str]:
    """Return the errors that mypy finds, as `file:line: text`."""
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file=", "--show-absolute-path"]
    command += [f"--cache-dir={folder}", f"--python-executable={python}", *map(str, programs)]
    done = run_to_end(command, cwd=folder, timeout_s=300)
    *lines, summary = done.stdout.splitlines()
    assert f"{len(programs)} source files" in summary, done.stdout + done.stderr
    return [line for line in lines if ": note: " not in line]


def pyright(python: Path, programs: list[Path], folder: Path) -> list[str]:
    """Return the errors that pyright finds, as `file:line: text`."""
    settings = {
        "typeCheckingMode": "standard",
        "pythonVersion": "3.10",
        "extraPaths": [str(EXAMPLES / "robot_in_a_room")],  # its programs import each other
    }
    (folder / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [sys.executable, "-m", "basedpyright", "--outputjson", f"--pythonpath={python}"]
    done = run_to_end([*command, *map(str, programs)], cwd=folder, timeout_s=300)
    report = json.loads(done.stdout)
    assert report["summary"]["filesAnalyzed"] >= len(programs)
    return [
        f"{diagnostic['file']}:{diagnostic['range']['start']['line'] + 1}: {diagnostic['message']}"
        for diagnostic in report["generalDiagnostics"]
        if diagnostic["severity"] == "error"
    ]


CHECKERS = {"mypy": mypy, "pyright": pyright}


@pytest.fixture(scope="module")
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


@pytest.fixture(scope="module")
def public_names(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Write a program that imports every public name of the recorded ones, and return its path."""
    reasons = recorded.missing()
    names = [
        name
        for name in recorded.all_names()
        if "." not in name.path and not recorded.reason_for(name, reasons)
    ]
    assert len(names) > 800
    lines = [f"from {name.module} import {name.path} as name_{number}" for number, name in enumerate(names)]
    program = tmp_path_factory.mktemp("public names") / "all_names.py"
    program.write_text("\n".join([*lines, MODULES]))
    return program


@pytest.fixture(scope="module", params=CHECKERS)
def errors(
    request: pytest.FixtureRequest, public_names: Path, tmp_path_factory: pytest.TempPathFactory
) -> dict[str, list[str]]:
    """Return what a checker reports of all programs against the editable install, by their paths."""
    folder = tmp_path_factory.mktemp(request.param)
    wrong = folder / "wrong.py"
    wrong.write_text(WRONG_NAMES)
    programs = [*PROGRAMS, MESSAGES, MISTAKES, public_names, wrong]
    result: dict[str, list[str]] = {str(program): [] for program in programs}
    for error in CHECKERS[request.param](Path(sys.executable), programs, folder):
        result[re.split(r":\d+:", error)[0]].append(error)
    return result


def test_programs_pass_against_the_editable_install(errors: dict[str, list[str]]) -> None:
    assert [error for program in (*PROGRAMS, MESSAGES) for error in errors[str(program)]] == []


@pytest.mark.parametrize("checker", CHECKERS)
def test_programs_pass_against_a_wheel(checker: str, wheel_python: Path, tmp_path: Path) -> None:
    assert CHECKERS[checker](wheel_python, PROGRAMS, tmp_path) == []


def test_each_mistake_is_found_and_nothing_else(errors: dict[str, list[str]]) -> None:
    lines = MISTAKES.read_text("utf-8").splitlines()
    planted = [number for number, line in enumerate(lines, 1) if line.endswith("  # mistake")]
    assert len(planted) == 19
    reported = errors[str(MISTAKES)]
    assert sorted(int(error.split(":")[1]) for error in reported) == planted, "\n".join(reported)


def test_every_public_name_passes(errors: dict[str, list[str]], public_names: Path) -> None:
    assert errors[str(public_names)] == []


def test_names_that_a_facade_lacks_are_rejected(errors: dict[str, list[str]]) -> None:
    (reported,) = (reported for path, reported in errors.items() if path.endswith("wrong.py"))
    assert len(reported) == 3


def test_a_wheel_puts_the_ros_names_last_on_the_path(wheel_python: Path) -> None:
    code = "import sys; print(*(path.replace('\\\\', '/').rpartition('site-packages/')[2] for path in sys.path[-3:]))"
    result = subprocess.run(
        [wheel_python, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert result.stdout == "tfloom/ros_names tfloom_interfaces/ros_names tfloom_sensing/ros_names\n"
