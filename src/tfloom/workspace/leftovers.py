"""Files that an earlier build of a package has left, although their sources are gone."""

from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from tfloom.common.files import write_file

RECORD = "install_manifest.txt"
"""The list, in a package's build folder, of the files that the last build installed, as CMake names it."""


def remove_dangling_links(folders: Iterable[Path]) -> None:
    """Remove symbolic links to sources that were removed or renamed, which setup.py's patterns still find.

    Raises:
        OSError: a link can't be removed.
    """
    for top in folders:
        for folder, folders_in_it, names in os.walk(top):
            for name in (*folders_in_it, *names):
                path = Path(folder, name)
                if path.is_symlink() and not path.exists():
                    path.unlink()


def remove_copies(build: Path, prefix: Path) -> None:
    """Remove what setup.py has copied, before links replace it.

    colcon itself removes only modules, and then fails at a data file that is new.

    Args:
        build: The package's build folder, with setuptools' list of what it copied.
        prefix: Where it is installed; files elsewhere stay.

    Raises:
        OSError: a file can't be removed.
    """
    record = build / "install.log"
    if record.is_file():
        for path in map(Path, record.read_text("utf-8").splitlines()):
            if path.is_relative_to(prefix) and (path.is_symlink() or path.is_file()):
                path.unlink()
        record.unlink()


def remove_former_files(build: Path, prefix: Path, installed: Iterable[Path]) -> None:
    """Remove what the last build installed and this one doesn't, and note what this one does.

    Args:
        build: The package's build folder.
        prefix: Where it is installed; files elsewhere, of a build with another prefix, stay.
        installed: The files that this build has installed.

    Raises:
        OSError: a file can't be removed, or the note not be written.
    """
    record = build / RECORD
    now = dict.fromkeys(map(str, installed))
    former: list[str] = []
    with suppress(FileNotFoundError):
        former = record.read_text("utf-8").splitlines()
    for path in (Path(line) for line in former if line not in now):
        if path.is_relative_to(prefix) and (path.is_symlink() or path.is_file()):
            path.unlink()
            with suppress(OSError):  # it holds other files
                path.parent.rmdir()
    build.mkdir(parents=True, exist_ok=True)
    write_file(record, "".join(f"{path}\n" for path in now))
