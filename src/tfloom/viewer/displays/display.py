"""What all displays have in common: messages in, shapes out; colours and poses of messages."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from tfloom.viewer.shapes import Color, DisplayError, Placed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.displays.settings import Values

__all__ = [
    "MAX_COORDINATE_M",
    "Display",
    "KeepingDisplay",
    "Latest",
    "PairedDisplay",
    "are_drawable",
    "color_of",
    "finite_points",
    "point_table",
    "pose_of",
    "shown_text",
    "stamp_of",
]

Position = tuple[float, float, float]
Rotation = tuple[float, float, float, float]

MAX_TEXT = 200
"""Number of characters of a text that are shown."""

MAX_COORDINATE_M = 1e12
"""Coordinates at or above this are not drawn: pages compute with numbers of 32 bits [m]."""


class Display(Protocol):
    """Shows the messages of one topic."""

    keeps_all: bool
    """Whether what is shown depends on all messages so far; if not, on the last one alone."""
    choices: Sequence[str]
    """What the user may choose from, as the field by which points are coloured; it may change with a message."""
    choice: str
    """What is chosen; empty: what fits best."""

    def take(self, message: Any, stamp_ns: int) -> None:
        """Take the next message, or the only one that matters, with its stamp [ns since epoch].

        Raises:
            DisplayError: it can't be shown.
        """

    def clear(self) -> None:
        """Forget all messages."""

    def shapes(self, now_ns: int) -> list[Placed]:
        """Return what is to be drawn at a time [ns since epoch].

        Raises:
            DisplayError: it can't be shown.
        """


class KeepingDisplay(Display, Protocol):
    """Shows what all messages so far make."""

    def saved(self) -> Any:
        """Return what is known of the messages so far, which later ones don't change."""

    def restore(self, saved: Any) -> None:
        """Know what was saved, and nothing else."""


class PairedDisplay(Display, Protocol):
    """Shows messages by what those of a second topic say."""

    partner_type: str
    """The type of the second topic."""
    partner_name: str
    """What its messages are, for sentences."""
    partner: Any
    """What the last one says; None: that is not known."""
    absence: str
    """Why not."""

    def partner_topic(self, topic: str) -> str:
        """Return the second topic for one that is shown."""

    def partner_of(self, message: Any) -> Any:
        """Return what a message of the second topic says; what is equal changes nothing.

        Raises:
            DisplayError: it can't be used.
        """


class Latest:
    """A display of single messages, by a function from a message and the settings to shapes.

    Args:
        settings: A value for each setting; it may change.
        shapes_of: The function; None: a method of a subclass.
    """

    keeps_all = False
    choices: Sequence[str] = ()
    choice = ""

    def __init__(
        self, settings: Values, shapes_of: Callable[[Any, Values], list[Placed]] | None = None
    ) -> None:
        self.settings = settings
        self._shapes_of = shapes_of
        self._shapes: list[Placed] = []

    def shapes_of(self, message: Any) -> list[Placed]:
        """Return the shapes of a message.

        Raises:
            DisplayError: it can't be shown.
        """
        assert self._shapes_of is not None  # noqa: S101  # for the type checker; subclasses have a method of their own
        return self._shapes_of(message, self.settings)

    def take(self, message: Any, stamp_ns: int) -> None:  # the header's stamp counts
        """Take the only message that matters.

        Raises:
            DisplayError: it can't be shown.
        """
        self._shapes = []
        self._shapes = self.shapes_of(message)

    def clear(self) -> None:
        """Forget the message."""
        self._shapes = []

    def shapes(self, now_ns: int) -> list[Placed]:  # they stay until the next message
        """Return the message's shapes."""
        return self._shapes


def stamp_of(header: Any) -> int:
    """Return the stamp of a header [ns since epoch]."""
    return int(header.stamp.sec) * 1_000_000_000 + int(header.stamp.nanosec)


def pose_of(pose: Any) -> tuple[Position, Rotation]:
    """Return position and unit quaternion of a `geometry_msgs/msg/Pose`.

    A quaternion of zeros, which a message has that nobody filled in, is not a rotation.

    Raises:
        DisplayError: a number is not finite.
    """
    position = float(pose.position.x), float(pose.position.y), float(pose.position.z)
    turn = pose.orientation
    x, y, z, w = float(turn.x), float(turn.y), float(turn.z), float(turn.w)
    length = math.sqrt(x * x + y * y + z * z + w * w) if max(map(abs, (x, y, z, w))) < 1e100 else math.inf
    if not (math.isfinite(length) and all(abs(part) < MAX_COORDINATE_M for part in position)):
        raise DisplayError(f"a number of its pose is not finite, or beyond {MAX_COORDINATE_M:g} m")
    if length < 1e-9:
        return position, (0.0, 0.0, 0.0, 1.0)
    return position, (x / length, y / length, z / length, w / length)


def are_drawable(points: NDArray[Any]) -> NDArray[np.bool_]:
    """Return which of many points (N, K) have finite numbers below `MAX_COORDINATE_M` (N,)."""
    drawable: NDArray[np.bool_] = (np.abs(points) < MAX_COORDINATE_M).all(axis=1)
    return drawable


def point_table(points: Sequence[Any]) -> NDArray[np.float32]:
    """Return the numbers of many points or vectors (N, 3), as pages have them."""
    with np.errstate(over="ignore"):
        return np.array([(point.x, point.y, point.z) for point in points], np.float32).reshape(-1, 3)


def finite_points(points: Sequence[Any]) -> NDArray[np.float32]:
    """Return those of many points or vectors that can be drawn (N, 3)."""
    table = point_table(points)
    return table[are_drawable(table)]


def color_of(color: Any) -> tuple[Color, float]:
    """Return red, green and blue, and the opacity, of a `std_msgs/msg/ColorRGBA`; what is not finite is 0."""
    red, green, blue, opacity = (
        min(max(float(part), 0.0), 1.0) if math.isfinite(part) else 0.0
        for part in (color.r, color.g, color.b, color.a)
    )
    return (round(255 * red), round(255 * green), round(255 * blue)), opacity


def shown_text(text: str, most: int = MAX_TEXT) -> str:
    """Return a text as a page can take it: of limited length, and without halves of surrogate pairs."""
    cut = text if len(text) <= most else text[: most - 1] + "…"
    return cut.encode("utf-8", "replace").decode()
