"""The example workspace: built, tested and run, in this environment and in a fresh one with a wheel."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import COLCON_PYTHON, run_to_end
from tests.launch.ros.user import expect_clean_end
from tests.wheels import release_files, wheel_of
from tests.workspace.conftest import BIN, colcon

pytestmark = [pytest.mark.slow, pytest.mark.skipif(os.name != "posix", reason="needs bash")]

SOURCE = Path(__file__).parents[2] / "examples" / "workspace" / "src"
PARAMETERS = "install/train_bringup/share/train_bringup/config/train.yaml"
WAGONS = 10
STARTED_S = 180.0
"""The longest time until all programs of the train have started, beside compilers [s]."""


def copy_sources(folder: Path) -> Path:
    shutil.copytree(SOURCE, folder / "src", ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def expect_train(
    folder: Path, binaries: Path, start_program: Callable[..., object], wait_until: Callable[..., None]
) -> None:
    """Launch the train of a built workspace, and wait until the last wagon is behind the turtle before it."""

    def start(line: str) -> object:
        script = f". install/setup.bash && exec tfloom {line}"
        path = f"{binaries}{os.pathsep}{os.environ['PATH']}"
        variables = {**os.environ, **COLCON_PYTHON, "PATH": path}
        return start_program("/bin/bash", "-c", script, cwd=folder, env=variables)

    # Fourteen programs end at once, beside compilers.
    train = start("launch train_bringup train.launch.yaml gap:=0.6 sigterm_timeout:=50")
    train.wait_for(f"The train has {WAGONS} wagons", STARTED_S)  # fourteen programs start at once
    echo = start("topic echo --once /train_state")
    echo.wait_for(f"- wagon{WAGONS}")
    echo.wait_for("gap: 0.6")
    refused = start('service call /set_gap train_interfaces/srv/SetGap "{gap: 0.1}"')
    refused.wait_for("SetGap_Response(accepted=False, reason='the smallest gap is 0.2 m')")
    assert refused.wait() == 0
    last = start(f"run tf2_ros tf2_echo wagon{WAGONS - 1} wagon{WAGONS} 10")

    def is_behind() -> bool:
        places = [line for line in last.lines if line.startswith("- Translation:")]
        return bool(places) and float(places[-1].split("[")[1].split(",")[0]) < 0.0

    wait_until(is_behind, what="the last wagon to be behind the one before it")
    expect_clean_end(train)
    demo = start("launch turtle_tf2_py turtle_tf2_demo.launch.py --show-args")
    assert demo.wait() == 0
    assert "    'target_frame':" in demo.lines


def test_workspace_builds_and_passes_its_tests(tmp_path: Path) -> None:
    copy_sources(tmp_path)
    built = colcon(tmp_path, "build")
    assert built.code == 0, built.output
    assert "4 packages finished" in built.output
    tested = colcon(tmp_path, "test", "--return-code-on-test-failure")
    assert tested.code == 0, tested.output
    result = colcon(tmp_path, "test-result", "--all")
    assert "Summary: 5 tests, 0 errors, 0 failures, 1 skipped" in result.output


def test_links_pick_up_an_edit(
    tmp_path: Path, domain_id: int, start_program: Callable[..., object], wait_until: Callable[..., None]
) -> None:
    copy_sources(tmp_path)
    built = colcon(tmp_path, "build", "--symlink-install")
    assert built.code == 0, built.output
    node = tmp_path / "src" / "turtle_train" / "turtle_train" / "frames.py"
    text = node.read_text("utf-8")
    node.write_text(text.replace("super().__init__('frames')", "super().__init__('frames_edited')"), "utf-8")
    config = tmp_path / "src" / "train_bringup" / "config" / "train.yaml"
    config.write_text(config.read_text("utf-8").replace("wagons: 10", "wagons: 2"), "utf-8")
    assert "wagons: 2" in (tmp_path / PARAMETERS).read_text("utf-8")
    script = ". install/setup.bash && exec tfloom run turtle_train frames"
    path = f"{BIN}{os.pathsep}{os.environ['PATH']}"
    start_program("/bin/bash", "-c", script, cwd=tmp_path, env={**os.environ, **COLCON_PYTHON, "PATH": path})

    def nodes() -> str:
        return run_to_end([BIN / "tfloom", "node", "list"]).stdout

    wait_until(lambda: "/frames_edited" in nodes())


def test_train_runs_over_dds(
    tmp_path: Path, domain_id: int, start_program: Callable[..., object], wait_until: Callable[..., None]
) -> None:
    copy_sources(tmp_path)
    assert colcon(tmp_path, "build").code == 0
    expect_train(tmp_path, BIN, start_program, wait_until)


def test_fresh_environment_builds_and_runs_it(
    tmp_path: Path,
    tmp_path_factory: pytest.TempPathFactory,
    domain_id: int,
    start_program: Callable[..., object],
    wait_until: Callable[..., None],
) -> None:
    (tmp_path / "ws").mkdir()
    wheel = wheel_of(release_files(tmp_path_factory), "tfloom")
    venv = tmp_path / "venv"
    subprocess.run([sys.executable, "-m", "venv", venv], check=True, timeout=120)
    install = [venv / "bin" / "python", "-m", "pip", "install", "--quiet", f"{wheel}[workspace]"]
    done = run_to_end(install, timeout_s=600)
    assert done.returncode == 0, done.stderr
    workspace = copy_sources(tmp_path / "ws")
    begin = time.monotonic()
    clean = {
        name: value for name, value in os.environ.items() if name not in {"AMENT_PREFIX_PATH", "PYTHONPATH"}
    }
    built = run_to_end(
        [venv / "bin" / "colcon", "build"],
        cwd=workspace,
        env={**clean, "PATH": f"{venv / 'bin'}{os.pathsep}/usr/bin{os.pathsep}/bin"},
        timeout_s=240,
    )
    print(f"colcon build: {time.monotonic() - begin:.1f} s")
    assert built.returncode == 0, built.stdout + built.stderr
    expect_train(workspace, venv / "bin", start_program, wait_until)
