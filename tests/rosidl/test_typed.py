"""mypy, strict, over user code that imports messages by ROS's names."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent / "typed"

pytestmark = pytest.mark.slow  # mypy is installed for the checks


def test_user_code_passes_strict_mypy(tmp_path: Path) -> None:
    for name in ("user.py", "wrong.py"):
        shutil.copy(HERE / name, tmp_path)
    run = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "user.py", "wrong.py"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    found = re.findall(r"^(\w+\.py):(\d+): error: .*\[([a-z-]+)\]$", run.stdout, re.MULTILINE)
    lines = (HERE / "wrong.py").read_text("utf-8").splitlines()
    expected = [
        ("wrong.py", str(n), line.split()[-1]) for n, line in enumerate(lines, 1) if "  # error: " in line
    ]
    assert found == expected, run.stdout + run.stderr
