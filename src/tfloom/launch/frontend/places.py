"""Where in a launch file an error is."""

from __future__ import annotations

from tfloom.launch.utilities.error_texts import add_to_error

__all__ = ["describe_error", "place_error"]

_PLACE = "launch_file_place"


def place_error(error: Exception, place: str) -> None:
    """Add the place of an element to an error, unless one has been added for an element inside.

    The error keeps its type. Its text begins with the place, if the type allows it.

    Args:
        error: What the element's parsing raised.
        place: File and line; "" if they aren't known.
    """
    if place and not hasattr(error, _PLACE):
        add_to_error(error, before=f"{place}: ")
        setattr(error, _PLACE, place)


def describe_error(error: Exception, path: str) -> str:
    """Return what is wrong with a launch file, beginning with the place.

    Args:
        error: What its parsing raised.
        path: Path of the file, for errors without a place.
    """
    place = getattr(error, _PLACE, path)
    text = str(error)
    return text if text.startswith(place) else f"{place}: {type(error).__name__}: {text}"
