"""The files of a release of this checkout, for tests of what users install."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import pytest
from tests.shared_folders import shared_folder
from tools import generated, release
from tools.release import Tools
from tools.set_up import PACKAGES

ROOT = Path(__file__).parents[1]


def path_with_cmake() -> str:
    """Return PATH with this environment's CMake first: ccache then has the core's files, which the set-up compiled.

    Another version of CMake orders the compiler's options in another way.
    """
    return f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"


def copy_checkout(clone: Path) -> Path:
    """Copy the files of a clone to a new folder, so that builds leave nothing in this checkout; return the folder.

    Like a clone it has no generated files, so a build generates them.
    """
    unwanted = shutil.ignore_patterns(
        ".git", ".venv*", "build", "dist", "wheels", "__pycache__", ".*_cache", ".hypothesis"
    )
    shutil.copytree(ROOT, clone, ignore=unwanted)
    for name in generated.files_there(clone):
        (clone / name).unlink()
    return clone


def release_tools(factory: pytest.TempPathFactory) -> Tools:
    """Return the tools of a release, which the first test that asks installs."""
    with shared_folder(factory, "release tools") as folder:
        return Tools(folder / "venv")


def release_files(factory: pytest.TempPathFactory) -> list[Path]:
    """Return the sdists and wheels of all projects, which the first test that asks builds."""
    tools = release_tools(factory)
    with shared_folder(factory, "release files") as folder:
        dist, unfinished = folder / "dist", folder / "unfinished"
        if not dist.exists():
            shutil.rmtree(unfinished, ignore_errors=True)  # of a build that failed
            clone = copy_checkout(unfinished / "a clöne" / "tfloom")
            (unfinished / "dist").mkdir()
            with pytest.MonkeyPatch.context() as patch:
                patch.setenv("PATH", path_with_cmake())
                projects = [clone, *(clone / "packages" / name for name in PACKAGES)]
                release.build(tools, unfinished / "dist", projects)
            (unfinished / "dist").rename(dist)
        return sorted(dist.iterdir())


def wheel_of(files: list[Path], name: str) -> Path:
    """Return the wheel of a distribution among the files of a release."""
    (wheel,) = (path for path in files if path.name.startswith(f"{name}-") and path.suffix == ".whl")
    return wheel
