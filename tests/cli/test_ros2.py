"""The commands `ros2` and `launch_test` of the distribution tfloom-ros2, which refuse to run beside real ones."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from tests.conftest import run_to_end

SOURCE = Path(__file__).parents[2] / "packages" / "tfloom-ros2" / "src"
START = "import sys; from tfloom_ros2 import main; sys.exit(main())"


def run(*words: str, path: Path | None = None, start: str = START) -> subprocess.CompletedProcess[str]:
    python_path = os.pathsep.join(map(str, [SOURCE, *([path] if path else [])]))
    return run_to_end([sys.executable, "-c", start, *words], env={**os.environ, "PYTHONPATH": python_path})


def test_ros2_command_is_tfloom_under_its_name() -> None:
    result = run("run", "nope", "x")
    assert (result.returncode, result.stderr) == (1, "Package 'nope' not found\n")
    assert run("topic", "-h").stdout.startswith("usage: ros2 topic ")


def test_ros2_command_refuses_beside_a_real_one(tmp_path: Path) -> None:
    (tmp_path / "ros2cli").mkdir()
    real = tmp_path / "ros2cli" / "__init__.py"
    real.write_text("")
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").touch()
    result = run("topic", "list", path=tmp_path)
    assert result.returncode == 1
    assert str(real) in result.stderr
    assert "Type `tfloom` instead" in result.stderr
    assert result.stdout == ""


def test_ros2_command_runs_beside_a_ros2cli_without_an_rclpy(tmp_path: Path) -> None:
    (tmp_path / "ros2cli").mkdir()
    (tmp_path / "ros2cli" / "__init__.py").touch()
    result = run("run", "nope", "x", path=tmp_path)
    assert (result.returncode, result.stderr) == (1, "Package 'nope' not found\n")


def test_launch_test_command_runs_but_beside_a_real_one(tmp_path: Path) -> None:
    start = "import sys; from tfloom_ros2 import launch_test; sys.exit(launch_test())"
    result = run(str(tmp_path / "none.py"), start=start)
    assert (result.returncode, "does not exist" in result.stderr) == (2, True)
    (tmp_path / "launch_testing").mkdir()
    (tmp_path / "launch_testing" / "__init__.py").touch()
    result = run("x.py", start=start, path=tmp_path)
    assert result.returncode == 1
    assert "Type `python -m launch_testing.launch_test`" in result.stderr
