"""The example that goes from arrays to a deskewed cloud does what it says."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

EXAMPLE = Path(__file__).parents[2] / "examples" / "deskew_cloud.py"


def test_deskewing_puts_the_points_back_on_the_walls() -> None:
    done = subprocess.run([sys.executable, EXAMPLE], capture_output=True, text=True, timeout=120, check=True)
    words = done.stdout.split()
    skewed_m, deskewed_m = float(words[3]), float(words[8])
    assert skewed_m > 0.1
    assert deskewed_m < 1e-4
