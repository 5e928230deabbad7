"""What a launch skips that isn't here: packages, programs, launch files and nodes in C++, for `--skip-missing`."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TypeVar

from tfloom.launch.core.error_places import describe_failure
from tfloom.launch.logs.logging import get_logger
from tfloom.workspace import ament

__all__ = ["is_about_missing", "marked_as_missing", "missing_packages_stood_in", "skip_text"]

_Error = TypeVar("_Error", bound=Exception)
_MARK = "launch_missing"


def marked_as_missing(error: _Error) -> _Error:
    """Return an error, marked as one about a program, a file or a node in C++ that isn't here."""
    setattr(error, _MARK, True)
    return error


def is_about_missing(error: BaseException | None) -> bool:
    """Return whether an error, or one that caused it, is about something that isn't here."""
    while error is not None:
        if (
            isinstance(error, (ament.PackageNotFoundError, ModuleNotFoundError))
            or hasattr(error, _MARK)
            # What fails at a file of a package that has a path only in name.
            or str(ament.STAND_IN) in str(error)
        ):
            return True
        error = error.__cause__
    return False


def skip_text(error: Exception) -> str:
    """Return the line about an entity that is skipped because of an error: its place, and what isn't here."""
    # The folders that were searched for a package are many, and the same each time.
    text = re.sub(r", (searching: \[[^\]]*\]|no workspace is sourced[^)]*\))", "", describe_failure(error))
    # A user never gave the path of a folder that stands in: the package and the file in it say the same.
    folder = re.escape(repr(str(ament.STAND_IN) + os.sep)[1:-1])
    separator = re.escape(repr(os.sep)[1:-1])
    text = re.sub(
        rf"\[Errno 2\] No such file or directory: '{folder}(.+?){separator}([^']*)'( \(there is no folder .*\))?",
        r"package '\1' not found: it has \2",
        text,
    )
    return f"skipped: {text.splitlines()[0]}"


@contextmanager
def missing_packages_stood_in() -> Iterator[None]:
    """Give packages that aren't here a share folder that doesn't exist, within the block, and warn of each once.

    A launch file in Python asks for folders before any of its entities is visited, and an error there would stop all of
    it. With such a folder, only what needs a file in it fails.
    """
    names: set[str] = set()

    def stand_in(package: str) -> None:
        if package not in names:
            names.add(package)
            get_logger("launch").warning("package '%s' not found: what needs its files is skipped", package)

    before = ament.on_stand_in
    ament.on_stand_in = stand_in
    try:
        yield
    finally:
        ament.on_stand_in = before
