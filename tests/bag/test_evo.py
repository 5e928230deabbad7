"""evo reads trajectories of transforms from recordings through tfloom's tf2_py, geometry_msgs and rclpy.time.

evo's licence is the GPL, so it is installed in its own environment, and only run as a program.
"""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from pathlib import Path

import numpy as np
import pytest
from tests.conftest import run_to_end

from tfloom.bag import frames

EXAMPLE = Path(__file__).parents[2] / "examples" / "bags" / "make_recording.py"
TIMEOUT_S = 600
WHERE = "import evo.tools.tf_cache, tf2_py, rclpy.time; print(tf2_py.__file__); print(rclpy.time.__file__)"

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def programs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Install evo beside what this environment has, and return the folder of its programs."""
    folder = tmp_path_factory.mktemp("evo")
    subprocess.run([sys.executable, "-m", "venv", folder], check=True, timeout=TIMEOUT_S)
    library = sysconfig.get_path("purelib", "venv", vars={"base": str(folder), "platbase": str(folder)})
    ours = sysconfig.get_path("purelib")
    (Path(library) / "tfloom_environment.pth").write_text(f"import site; site.addsitedir({ours!r})\n")
    bin_folder = Path(sysconfig.get_path("scripts", "venv", vars={"base": str(folder)}))
    pip = [bin_folder / "python", "-m", "pip", "--disable-pip-version-check", "--quiet"]
    subprocess.run([*pip, "install", "evo"], check=True, timeout=TIMEOUT_S)
    return bin_folder


def run(home: Path, *command: str | Path) -> str:
    """Run a program with a home folder of its own, without ROS; return its output."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    done = run_to_end(
        command, cwd=home, env=environment | {"HOME": str(home), "MPLBACKEND": "agg"}, timeout_s=TIMEOUT_S
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    return done.stdout


def test_trajectory_of_evo_equals_ours(programs: Path, tmp_path: Path) -> None:
    bag = tmp_path / "drive"
    run(tmp_path, programs / "python", EXAMPLE, bag)
    where = run(tmp_path, programs / "python", "-c", WHERE).splitlines()[-2:]
    assert all("ros_names" in line for line in where)
    run(tmp_path, programs / "evo_traj", "bag2", bag, "/tf:map.base_link", "--save_as_tum")
    (saved,) = tmp_path.glob("*.tum")
    theirs = np.loadtxt(saved)
    assert len(theirs) >= 40
    stamps = np.rint(theirs[:, 0] * 1e6).astype(np.int64) * 1000  # evo computes with seconds as float64
    ours = frames(bag).trajectory("map", "base_link", stamps)
    assert np.abs(ours.positions - theirs[:, 1:4]).max() < 1e-6
    assert np.abs(ours.rotations_xyzw - theirs[:, 4:]).max() < 1e-6


def test_evo_reads_our_text(programs: Path, tmp_path: Path) -> None:
    bag = tmp_path / "drive"
    run(tmp_path, programs / "python", EXAMPLE, bag)
    way = frames(bag).trajectory("map", "base_link")
    way.write_tum(tmp_path / "way.tum")
    way.write_kitti(tmp_path / "way.kitti")
    for form in ("tum", "kitti"):
        found = run(tmp_path, programs / "evo_traj", form, tmp_path / f"way.{form}")
        assert f"{len(way.stamps_ns)} poses, {way.length_m:.3f}m path length" in found
