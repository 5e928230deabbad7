"""Packages around a file that no workspace has built: sources in a clone."""

from __future__ import annotations

import functools
import itertools
import re
from collections.abc import Iterator
from pathlib import Path

from tfloom.common.files import open_regular, read_at_most

__all__ = ["folders_above", "packages_around", "packages_of_clones"]

MAX_LEVELS = 8
"""Number of folders above a file in which packages are looked for."""
MAX_FOLDERS = 500
"""Number of folders in each of them that are looked at."""
MAX_MANIFEST_BYTES = 1024 * 1024


def folders_above(near: Path) -> list[Path]:
    """Return a folder and those that it is in, the nearest first."""
    return list(itertools.islice((near.absolute(), *near.absolute().parents), MAX_LEVELS))


@functools.lru_cache(MAX_FOLDERS)
def packages_around(near: Path, package: str) -> tuple[Path, ...]:
    """Return the folders of a package of this name: one that the folder `near` is in, then those beside it."""
    return tuple(_find_packages(near, package))


@functools.lru_cache(MAX_FOLDERS)
def packages_of_clones(near: Path, package: str) -> tuple[Path, ...]:
    """Return the folders of a package in other clones beside that of the folder `near`, as `src/CLONE/PACKAGE`.

    They may be a stranger's, so an installed package counts before them.
    """
    if not _is_name(package):
        return ()
    beside = itertools.chain.from_iterable(map(_folders, folders_above(near)))
    return tuple(found for folder in beside if _has_name(found := folder / package, package))


def _is_name(package: str) -> bool:
    return bool(re.fullmatch(r"[\w.-]+", package) and package.strip("."))


def _find_packages(near: Path, package: str) -> Iterator[Path]:
    if not _is_name(package):
        return
    above = folders_above(near)
    for folder in above:
        if folder.name == package:
            yield folder
        yield from (found for found in (folder / package, folder / "share" / package) if found.is_dir())
    for folder in above:
        yield from (found for found in _folders(folder) if _has_name(found, package))


def _folders(folder: Path) -> list[Path]:
    try:
        return [found for found in itertools.islice(folder.iterdir(), MAX_FOLDERS) if found.is_dir()]
    except OSError:
        return []


def _has_name(folder: Path, package: str) -> bool:
    """Return whether a folder's package.xml is of a package of this name."""
    try:
        with open_regular(folder / "package.xml") as file:
            content = read_at_most(file, MAX_MANIFEST_BYTES) or b""
    except (OSError, ValueError):
        return False
    match = re.search(rb"<name>\s*([^<\s]+)\s*</name>", content)
    return match is not None and match[1] == package.encode()
