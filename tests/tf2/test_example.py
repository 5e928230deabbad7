"""The example that deskews a cloud does what its docstring states."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

from tests.conftest import run_to_end

EXAMPLE = Path(__file__).parents[2] / "examples" / "deskew_cloud.py"


def test_deskewed_points_lie_on_the_walls_and_are_drawn(tmp_path: Path) -> None:
    path = tmp_path / "deskew.png"
    has_matplotlib = importlib.util.find_spec("matplotlib") is not None
    done = run_to_end([sys.executable, EXAMPLE, *(["--plot", path] if has_matplotlib else [])])
    assert done.returncode == 0, done.stderr
    words = done.stdout.split()
    skewed_m, deskewed_m = float(words[3]), float(words[8])
    assert skewed_m > 0.1
    assert deskewed_m < 1e-4
    assert not has_matplotlib or path.read_bytes().startswith(b"\x89PNG")
