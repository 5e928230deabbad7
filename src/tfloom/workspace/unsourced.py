"""Packages that no program finds: a workspace holds them, not sourced or not built, or something stands in for them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

from tfloom.workspace import index


def how_to_find(package: str) -> str:
    """Return a sentence on how to make a package known that a workspace here or above holds.

    Where none does, the sentence is what stands in for the package here; empty if nothing does.
    A workspace is a folder whose `install/` or `src/` has the package; the one nearest to the working directory counts.
    """
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_-]*", package):
        return ""
    for folder in _here_and_above():
        if _is_installed(folder / "install", package):
            return f"it is built, but not sourced in this terminal: {_command(folder / 'install')}"
        if _has_source(folder / "src", package):
            build = "colcon build" if folder == Path.cwd() else f"cd {folder} && colcon build"
            return f"its source is in {folder / 'src'}, but it isn't built: {build} && {_command(folder / 'install')}"
    return index.STAND_INS.get(package, "")


def _here_and_above() -> Iterator[Path]:
    try:
        here = Path.cwd()
    except OSError:  # it was removed
        return
    yield here
    yield from here.parents


def _is_installed(install: Path, package: str) -> bool:
    """Return whether colcon has installed a package here: in its own folder, or merged with the others."""
    marker = Path(index.RESOURCE_INDEX, "packages", package)
    return _is_file(install / package / marker) or _is_file(install / marker)


def _has_source(source: Path, package: str) -> bool:
    """Return whether the package's folder is in `source`, or in a folder of it, as a repository's packages are."""
    return any(_is_file(folder / package / "package.xml") for folder in (source, *source.glob("*")))


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # it is not ours to look into
        return False


def _command(install: Path) -> str:
    if os.name == "nt":
        return f"call {install / 'setup.bat'}"
    shell = Path(os.environ.get("SHELL", "bash")).name
    return f"source {install}/setup.{shell if shell in {'bash', 'zsh'} else 'bash'}"
