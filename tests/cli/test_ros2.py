"""The command `ros2` of the distribution tfloom-ros2, which refuses to run beside a real one."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).parents[2] / "packages" / "tfloom-ros2" / "src"
START = "import sys; from tfloom_ros2 import main; sys.exit(main())"


def run(*words: str, path: Path | None = None) -> subprocess.CompletedProcess[str]:
    python_path = os.pathsep.join(map(str, [SOURCE, *([path] if path else [])]))
    return subprocess.run(
        [sys.executable, "-c", START, *words],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
        env={**os.environ, "PYTHONPATH": python_path},
    )


def test_ros2_command_is_tfloom_under_its_name() -> None:
    result = run("run", "nope", "x")
    assert (result.returncode, result.stderr) == (1, "Package 'nope' not found\n")
    assert run("topic", "-h").stdout.startswith("usage: ros2 topic ")


def test_ros2_command_refuses_beside_a_real_one(tmp_path: Path) -> None:
    (tmp_path / "ros2cli").mkdir()
    real = tmp_path / "ros2cli" / "__init__.py"
    real.write_text("")
    result = run("topic", "list", path=tmp_path)
    assert result.returncode == 1
    assert str(real) in result.stderr
    assert "Type `tfloom` instead" in result.stderr
    assert result.stdout == ""
