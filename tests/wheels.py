"""The files of a release of this checkout, for tests of what users install."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from tests.shared_folders import shared_folder
from tools import release
from tools.release import Tools

ROOT = Path(__file__).parents[1]


def release_tools(factory: pytest.TempPathFactory) -> Tools:
    """Return the tools of a release, which the first test that asks installs."""
    with shared_folder(factory, "release tools") as folder:
        return Tools(folder / "venv")


def release_files(factory: pytest.TempPathFactory) -> list[Path]:
    """Return the sdists and wheels of all projects, which the first test that asks builds.

    They are built from a copy of the checkout, so that nothing is left in it.
    """
    tools = release_tools(factory)
    with shared_folder(factory, "files of a relëase") as folder:
        dist, clone = folder / "dist", folder / "a clöne" / "tfloom"
        if not dist.exists():
            shutil.rmtree(folder / "unfinished", ignore_errors=True)
            shutil.rmtree(clone, ignore_errors=True)
            unwanted = shutil.ignore_patterns(
                ".git", ".venv*", "build", "dist", "wheels", "__pycache__", ".*_cache", ".hypothesis"
            )
            shutil.copytree(ROOT, clone, ignore=unwanted)
            (folder / "unfinished").mkdir()
            release.build(tools, folder / "unfinished", [clone, *(clone / "packages").iterdir()])
            (folder / "unfinished").rename(dist)
        return sorted(dist.iterdir())


def wheel_of(files: list[Path], name: str) -> Path:
    """Return the wheel of a distribution among the files of a release."""
    (wheel,) = (path for path in files if path.name.startswith(f"{name}-") and path.suffix == ".whl")
    return wheel
