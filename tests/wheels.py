"""Wheels of this checkout, for tests of what users install."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]


def build_wheel(folder: Path, project: Path = ROOT) -> Path:
    """Build the wheel of a project in an empty folder, leaving nothing in the checkout, and return its path."""
    options = ["--no-deps", "--no-build-isolation", "--config-settings", f"build-dir={folder}/build"]
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--quiet"]
    subprocess.run([*pip, "wheel", *options, "-w", str(folder), str(project)], check=True, timeout=600)
    (wheel,) = folder.glob("*.whl")
    return wheel
