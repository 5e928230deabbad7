"""Where an error of a launch comes from: a file and a line of the user's."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from traceback import extract_tb
from types import FrameType

from tfloom.launch.invalid_launch_file_error import InvalidLaunchFileError

__all__ = ["describe_failure", "keep_place", "place_of_construction"]

_OURS = str(Path(__file__).parents[2]) + os.sep
_PYTHONS = str(Path(os.__file__).parent) + os.sep
_PLACE = "launch_place"


def place_of_construction() -> str:
    """Return the file and line where the object under construction was made; "" if tfloom makes it.

    To be called by its `__init__`, which those of derived classes call.
    """
    frame: FrameType | None = sys._getframe(1)  # noqa: SLF001  # the only way, and a fast one
    while frame is not None and frame.f_code.co_name == "__init__":
        frame = frame.f_back
    if frame is None or frame.f_code.co_filename.startswith(_OURS):
        return ""
    return f"{frame.f_code.co_filename}:{frame.f_lineno}"


def keep_place(error: Exception, place: str) -> None:
    """Note on an error the place of the action that raised it, unless an action inside has done so."""
    if place and not hasattr(error, _PLACE) and not isinstance(error, InvalidLaunchFileError):
        setattr(error, _PLACE, place)


def describe_failure(error: BaseException) -> str:
    """Return the text of an error that ends a launch: its place, if it is known, and what is wrong.

    If a function of the user's raised it, this has its line and its type, too; else it is where the action was made.
    """
    text = str(error) or type(error).__name__
    frames = [each for each in extract_tb(error.__traceback__) if _is_users(each.filename)]
    if frames and not isinstance(error, InvalidLaunchFileError):
        return f"{frames[-1].filename}:{frames[-1].lineno}: {type(error).__name__}: {error}"
    place = getattr(error, _PLACE, "")
    return f"{place}: {text}" if place else text


def _is_users(path: str) -> bool:
    is_installed = path.startswith(_PYTHONS) and "site-packages" not in path
    return not (path.startswith((_OURS, "<")) or is_installed)
