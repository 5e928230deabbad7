"""The commands of the distribution tfloom-rviz, which start others of their names, and otherwise open the page."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end

SOURCE = Path(__file__).parents[2] / "packages" / "tfloom-rviz" / "src"
NAMES = ("rviz2", "rqt_graph", "rqt_plot", "rqt_console", "joint_state_publisher_gui")
pytestmark = pytest.mark.skipif(os.name == "nt", reason="scripts of a shell stand for the other commands")


def install(folder: Path, name: str) -> Path:
    """Write a command as pip does where the path of Python has a space, which the first line can't name."""
    folder.mkdir(exist_ok=True)
    command = folder / name
    command.write_text(
        f"""#!/bin/sh
'''exec' "{sys.executable}" "$0" "$@"
' '''
import sys
from tfloom_rviz import {name}
sys.exit({name}())
""",
        "utf-8",
    )
    command.chmod(0o755)
    return command


def write_script(folder: Path, name: str, line: str) -> Path:
    folder.mkdir(exist_ok=True)
    script = folder / name
    script.write_text(f"#!/bin/sh\n{line}\n", "utf-8")
    script.chmod(0o755)
    return script


def run(command: Path, *words: str, path: tuple[Path, ...]) -> subprocess.CompletedProcess[str]:
    variables = {**os.environ, "PYTHONPATH": str(SOURCE), "PATH": os.pathsep.join(map(str, ("", *path)))}
    return run_to_end([command, *words], env=variables, timeout_s=60.0)


@pytest.mark.parametrize("name", NAMES)
def test_command_without_another_is_that_of_tfloom(name: str, tmp_path: Path) -> None:
    ours = install(tmp_path / "bin", name)
    answer = run(ours, "--help", path=(ours.parent,))
    assert answer.returncode == 0
    assert answer.stdout.startswith(f"usage: {name} ")
    assert "tfloom view" in answer.stdout


def test_command_starts_another_of_its_name_with_the_same_words(tmp_path: Path) -> None:
    ours = install(tmp_path / "bin", "rviz2")
    # It is this process afterwards, so that signals reach it, and its exit code is the answer.
    script = write_script(tmp_path / "ros", "rviz2", 'printf "%s|" "$@"; echo $$; exit 7')
    process = subprocess.Popen(
        [ours, "-d", "a b.rviz", "-h", "", "--ros-args"],
        env={**os.environ, "PYTHONPATH": str(SOURCE), "PATH": f"{ours.parent}:{script.parent}"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    output, _ = process.communicate(timeout=60.0)
    assert output == f"-d|a b.rviz|-h||--ros-args|{process.pid}\n"
    assert process.returncode == 7


def test_links_and_copies_of_a_command_are_not_others(tmp_path: Path) -> None:
    ours = install(tmp_path / "bin", "rqt_graph")
    (tmp_path / "links").mkdir()
    (tmp_path / "links" / "rqt_graph").symlink_to(ours)
    (tmp_path / "copies").mkdir()
    shutil.copy(ours, tmp_path / "copies")
    (tmp_path / "not_run").mkdir()
    (tmp_path / "not_run" / "rqt_graph").write_text("no program")
    others = tuple(tmp_path / name for name in ("links", "copies", "not_run", "absent"))
    answer = run(ours, "--help", path=(*others, ours.parent))
    assert (answer.returncode, answer.stderr) == (0, "")
    assert answer.stdout.startswith("usage: rqt_graph ")
    # One that comes behind them is found.
    script = write_script(tmp_path / "ros", "rqt_graph", "echo real")
    assert run(tmp_path / "links" / "rqt_graph", path=(*others, script.parent)).stdout == "real\n"


@pytest.mark.parametrize("how", ["exec", ""])
def test_script_that_starts_the_command_again_is_not_started_for_ever(how: str, tmp_path: Path) -> None:
    ours = install(tmp_path / "bin", "rqt_plot")
    log = tmp_path / "started"
    script = write_script(tmp_path / "mine", "rqt_plot", f'echo once >> "{log}"; {how} "{ours}" "$@"')
    answer = run(script, "--help", path=(script.parent, ours.parent))
    assert answer.returncode == 0
    assert answer.stdout.startswith("usage: rqt_plot ")
    assert log.read_text() == "once\n" * 2  # by its user, and by the command


def test_other_command_that_can_not_be_started_is_named(tmp_path: Path) -> None:
    ours = install(tmp_path / "bin", "rviz2")
    broken = write_script(tmp_path / "ros", "rviz2", "")
    broken.write_text("#!/no/such/interpreter\n")
    answer = run(ours, path=(broken.parent,))
    assert answer.returncode == 126
    assert answer.stderr == f"rviz2: can't start {broken}, which is on PATH: No such file or directory\n"
    assert answer.stdout == ""
