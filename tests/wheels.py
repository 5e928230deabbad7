"""Wheels of this checkout, for tests of what users install."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from tests.shared_folders import shared_folder

ROOT = Path(__file__).parents[1]
INTERFACES = ROOT / "packages" / "tfloom-interfaces"


def build_wheel(factory: pytest.TempPathFactory, project: Path = ROOT) -> Path:
    """Return the wheel of a project, which the first test that asks builds, leaving nothing in the checkout."""
    with shared_folder(factory, f"wheel of {project.name}") as folder:
        if not list(folder.glob("*.whl")):
            options = ["--no-deps", "--no-build-isolation", "--config-settings", f"build-dir={folder}/build"]
            pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--quiet"]
            command = [*pip, "wheel", *options, "-w", str(folder), str(project)]
            subprocess.run(command, check=True, timeout=1800)
        (wheel,) = folder.glob("*.whl")
        return wheel
