"""The example that deskews a cloud does what its docstring states."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "deskew_cloud.py"


def test_deskewed_points_lie_on_the_walls() -> None:
    done = subprocess.run([sys.executable, EXAMPLE], capture_output=True, text=True, timeout=120, check=True)
    words = done.stdout.split()
    skewed_m, deskewed_m = float(words[3]), float(words[8])
    assert skewed_m > 0.1
    assert deskewed_m < 1e-4


def test_example_draws_a_picture(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    path = tmp_path / "deskew.png"
    subprocess.run([sys.executable, EXAMPLE, "--plot", path], timeout=120, check=True)
    assert path.read_bytes().startswith(b"\x89PNG")
