"""The values of a layout."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Value

__all__ = [
    "AXES",
    "CAMERA_KINDS",
    "DEFAULT_AXES_M",
    "MAX_PLOT",
    "TOP_FOV_RAD",
    "DisplayLayout",
    "Layout",
    "LayoutError",
    "PlotLayout",
    "Point",
    "SavedView",
    "ViewPoint",
]

DEFAULT_AXES_M = 0.3
"""Length of a frame's axes [m]."""
AXES = ("left", "right")
"""Sides of a plot at which an axis of values is."""
CAMERA_KINDS = ("orbit", "top", "first_person")
"""Cameras that turn about what they look at, look down from above without perspective, or look out of a frame."""
TOP_FOV_RAD = math.radians(4.0)
"""Of a view from above: viser has no camera without perspective, so this one is far away, with so small an angle."""
MAX_PLOT = 999
"""Greatest number of a plot."""

Point = tuple[float, float, float]


class LayoutError(Exception):
    """A file is not a layout; the text has the file, the line where it is known, and the reason."""


class ViewPoint(NamedTuple):
    """From where a page looks, and to where [m]."""

    position: Point
    look_at: Point


class SavedView(NamedTuple):
    """A camera, as a page shows it again by its name."""

    name: str
    camera: ViewPoint
    """Counted from the place of the frame."""
    kind: str = "orbit"
    """One of `CAMERA_KINDS`."""
    frame: str = ""
    """The frame that the camera follows; empty: the fixed frame."""
    turns: bool = False
    """Whether it turns with this frame about the vertical, too; one of a first person turns in any case."""


class DisplayLayout(NamedTuple):
    """A topic that is shown, or a display without one."""

    topic: str
    choice: str = ""
    """What is chosen for it, as the field that colours a cloud; empty: what fits best."""
    settings: tuple[tuple[str, Value], ...] = ()
    """Names and values of the settings that are not as they usually are."""
    kind: str = ""
    """The label of the display's kind; empty: that which shows messages of the topic's type."""


class PlotLayout(NamedTuple):
    """A field that is plotted."""

    topic: str
    field: str
    plot: int = 0
    """Number of the plot in which it is drawn, with others of this number; 0: in a plot of its own."""
    axis: str = "left"
    """At which side the axis of its values is: left or right."""
    unroll: bool = False
    """Whether it is an angle [rad] that goes on beyond half a turn."""


class Layout(NamedTuple):
    """What a page shows from the start."""

    fixed_frame: str = ""
    """Empty: a usual one, or the root of the largest tree."""
    with_names: bool = True
    axes_m: float = DEFAULT_AXES_M
    frames: tuple[tuple[str, Value], ...] = ()
    """Names and values of the settings of frames that are not as they usually are."""
    trails: tuple[str, ...] = ()
    """Frames whose way is drawn."""
    displays: tuple[DisplayLayout, ...] = ()
    plots: tuple[PlotLayout, ...] = ()
    camera: ViewPoint | None = None
    """From where new pages look; None: from where they do by themselves."""
    camera_frame: str = ""
    """The frame that the camera follows, from whose place `camera` counts; empty: the fixed frame."""
    camera_turns: bool = False
    """Whether it turns with this frame about the vertical, too."""
    camera_kind: str = "orbit"
    """One of `CAMERA_KINDS`."""
    views: tuple[SavedView, ...] = ()
    start_offset_s: float | None = None
    """How long after its first transform a recording begins [s]; None: where its frames connect."""
