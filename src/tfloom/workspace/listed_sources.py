"""The files that a check of code style is for."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from pathlib import Path

_IGNORE_MARKER = "AMENT_IGNORE"


def add_paths(parser: argparse.ArgumentParser, what: str) -> None:
    """Add the arguments that name files and folders.

    Args:
        parser: The parser of a check.
        what: Which files of a folder are checked.
    """
    parser.add_argument("paths", nargs="*", default=[os.curdir], help=f"files, or folders with {what}")
    parser.add_argument("--exclude", metavar="filename", nargs="*", dest="excludes", default=[])


def files_of(paths: Sequence[str], excludes: Sequence[str], endings: tuple[str, ...]) -> list[str]:
    """Return the files named, and those in the folders named whose names have one of the endings, sorted.

    Left out are folders whose names begin with a dot or an underscore, those with a file AMENT_IGNORE, and the files
    to exclude, given by path or by name.
    """
    excluded = {*excludes, *map(os.path.abspath, excludes)}
    files = []
    for path in paths:
        if not Path(path).is_dir():
            files.append(path)
            continue
        for folder, folders, names in os.walk(path):
            if _IGNORE_MARKER in names:
                folders.clear()
                continue
            folders[:] = sorted(name for name in folders if name[0] not in "._")
            files += [str(Path(folder, name)) for name in names if name.endswith(endings)]
    return sorted(
        path for path in files if not {path, str(Path(path).absolute()), Path(path).name} & excluded
    )
