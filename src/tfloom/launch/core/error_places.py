"""Where an error of a launch comes from: a file and a line of the user's.

An error keeps the place that it is given first, which is the innermost one.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from traceback import extract_tb
from types import FrameType

from tfloom.launch.core.invalid_launch_file_error import InvalidLaunchFileError

__all__ = [
    "add_to_error",
    "describe_error",
    "describe_failure",
    "keep_place",
    "place_error",
    "place_of_construction",
]

_OURS = str(Path(__file__).parents[2]) + os.sep
_PYTHONS = str(Path(os.__file__).parent) + os.sep
_PLACE = "launch_place"


def place_of_construction() -> str:
    """Return the file and line where the object under construction was made; "" if tfloom makes it.

    To be called by its `__init__`, which those of derived classes call.
    """
    frame: FrameType | None = sys._getframe(1)  # the only way, and a fast one
    while frame is not None and frame.f_code.co_name == "__init__":
        frame = frame.f_back
    if frame is None or frame.f_code.co_filename.startswith(_OURS):
        return ""
    return f"{frame.f_code.co_filename}:{frame.f_lineno}"


def keep_place(error: Exception, place: str) -> None:
    """Note on an error the place of the action that raised it, unless an action inside has done so."""
    if place and not hasattr(error, _PLACE) and not isinstance(error, InvalidLaunchFileError):
        setattr(error, _PLACE, place)


def place_error(error: Exception, place: str) -> None:
    """Note on an error the place of an element of a launch file, unless one inside has done so, and add it to the text.

    The error keeps its type. Its text begins with the place, if the type allows it.

    Args:
        error: What the element's parsing raised.
        place: File and line; "" if they aren't known.
    """
    if place and not hasattr(error, _PLACE):
        add_to_error(error, before=f"{place}: ")
        setattr(error, _PLACE, place)


def add_to_error(error: Exception, *, before: str = "", after: str = "") -> None:
    """Add to an error's text, if its first argument is its whole text, as it is with most types.

    Args:
        error: The error.
        before: What stands before its text.
        after: What stands after it.
    """
    if isinstance(error, SyntaxError):
        error.msg = f"{before}{error.msg}{after}"
    elif len(error.args) == 1 and isinstance(error.args[0], str) and str(error) == error.args[0]:
        error.args = (f"{before}{error.args[0]}{after}",)


def describe_error(error: Exception, path: str) -> str:
    """Return what is wrong with a launch file, beginning with the place.

    Args:
        error: What its parsing raised.
        path: Path of the file, for errors without a place.
    """
    place = getattr(error, _PLACE, path)
    text = str(error)
    return text if text.startswith(place) else f"{place}: {type(error).__name__}: {text}"


def describe_failure(error: BaseException) -> str:
    """Return the text of an error that ends a launch: its place, if it is known, and what is wrong.

    If a function of the user's raised it, this has its line and its type, too; else it is where the action was made.
    """
    text = str(error) or type(error).__name__
    frames = [frame for frame in extract_tb(error.__traceback__) if _is_users(frame.filename)]
    if frames and not isinstance(error, InvalidLaunchFileError):
        return f"{frames[-1].filename}:{frames[-1].lineno}: {type(error).__name__}: {error}"
    place = getattr(error, _PLACE, "")
    return f"{place}: {text}" if place and not text.startswith(place) else text


def _is_users(path: str) -> bool:
    is_installed = path.startswith(_PYTHONS) and "site-packages" not in path
    return not (path.startswith((_OURS, "<")) or is_installed)
