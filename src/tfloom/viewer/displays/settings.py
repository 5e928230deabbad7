"""Settings of displays: one declaration of each, by which pages, layouts and files of RViz have it."""

from __future__ import annotations

import re
import reprlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from tfloom.viewer.shapes import Color

__all__ = [
    "AXES_SETTINGS",
    "CELLS_SETTINGS",
    "CLOUD_SETTINGS",
    "EFFORT_SETTINGS",
    "FRAME_SETTINGS",
    "GRID_SETTINGS",
    "INTERACTIVE_SETTINGS",
    "MAP_SETTINGS",
    "MARKER_SETTINGS",
    "MAX_HISTORY",
    "ODOMETRY_SETTINGS",
    "PATH_SETTINGS",
    "POINT_SETTINGS",
    "POLYGON_SETTINGS",
    "POSE_ARRAY_SETTINGS",
    "POSE_SETTINGS",
    "POSE_WITH_COVARIANCE_SETTINGS",
    "RANGE_SETTINGS",
    "ROBOT_SETTINGS",
    "SCAN_SETTINGS",
    "TWIST_SETTINGS",
    "WRENCH_SETTINGS",
    "ChoiceSetting",
    "ColorSetting",
    "FlagSetting",
    "NamesSetting",
    "NumberSetting",
    "Setting",
    "SettingError",
    "TextSetting",
    "Value",
    "Values",
    "queue_setting",
    "taken_anywhere",
    "to_file",
    "usual_values",
]

Value = float | bool | str | Color | tuple[str, ...]
Values = Mapping[str, Any]
"""A value for each setting of a display."""
_RVIZ_COLOR = re.compile(r"\s*(\d{1,3})\s*;\s*(\d{1,3})\s*;\s*(\d{1,3})\s*", re.ASCII)
MAX_TEXT = 256
"""Number of characters of a text or a name."""
MAX_NAMES = 2000
"""Number of names in a list."""
MAX_DEPTH = 10_000
"""Number of messages of a topic that may wait to be taken."""
MAX_HISTORY = 1000
"""Number of messages that a display shows at a time."""


class SettingError(ValueError):
    """A value is not one of its setting; the text says which ones are, as 'has to be …, not …'."""

    def __init__(self, wanted: str, value: Any) -> None:
        super().__init__(f"has to be {wanted}, not {reprlib.repr(value)}")


@dataclass(frozen=True)
class Setting:
    """A setting.

    Attributes:
        usual: The value that counts where none is set.
        rviz: The property in files of RViz; one within another after a slash.
    """

    usual: Any
    rviz: str

    kind = ""
    """What pages call this kind of setting."""

    def taken(self, value: Any) -> Value:
        """Return a value of a page or a layout.

        Raises:
            SettingError: it is none.
        """
        raise NotImplementedError

    def from_rviz(self, value: Any) -> Value:
        """Return a value of a file of RViz.

        Raises:
            SettingError: it is none.
        """
        return self.taken(value)

    def to_rviz(self, value: Any) -> Any:
        """Return a value as files of RViz have it."""
        return value

    def description(self) -> dict[str, Any]:
        """Return what a page has to know to offer it."""
        return {"kind": self.kind, "usual": self.usual}


@dataclass(frozen=True)
class NumberSetting(Setting):
    """A number in a range."""

    least: float = 0.0
    greatest: float = 1e6
    is_whole: bool = False

    kind = "number"

    def taken(self, value: Any) -> Value:
        """Return the number.

        Raises:
            SettingError: it is none, or out of the range.
        """
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if is_number and self.least <= value <= self.greatest and (not self.is_whole or value == int(value)):
            return int(value) if self.is_whole else float(value)
        kind = "a whole number" if self.is_whole else "a number"
        raise SettingError(f"{kind} from {self.least:g} to {self.greatest:g}", value)

    def description(self) -> dict[str, Any]:
        """Return what a page has to know to offer it."""
        return {
            **super().description(),
            "least": self.least,
            "greatest": self.greatest,
            "is_whole": self.is_whole,
        }


@dataclass(frozen=True)
class ColorSetting(Setting):
    """A colour."""

    kind = "color"

    def taken(self, value: Any) -> Value:
        """Return the colour of three numbers, or of a text as RViz writes it.

        Raises:
            SettingError: it is none.
        """
        parts = value
        if isinstance(value, str) and (found := _RVIZ_COLOR.fullmatch(value)) is not None:
            parts = [int(part) for part in found.groups()]
        if isinstance(parts, list) and len(parts) == 3 and all(map(_is_channel, parts)):
            return parts[0], parts[1], parts[2]
        raise SettingError("three whole numbers from 0 to 255, as [204, 51, 51]", value)

    def to_rviz(self, value: Any) -> Any:
        """Return a value as files of RViz have it."""
        return "; ".join(map(str, value))


def _is_channel(part: Any) -> bool:
    return isinstance(part, int) and not isinstance(part, bool) and 0 <= part <= 255


@dataclass(frozen=True)
class FlagSetting(Setting):
    """A truth value."""

    kind = "flag"

    def taken(self, value: Any) -> Value:
        """Return the truth value.

        Raises:
            SettingError: it is none.
        """
        if not isinstance(value, bool):
            raise SettingError("true or false", value)
        return value


@dataclass(frozen=True)
class ChoiceSetting(Setting):
    """One of a few words."""

    options: Mapping[str, str] = field(default_factory=dict)
    """RViz's word for each of ours; several of RViz's, of which the first is written, between bars."""

    kind = "choice"

    def taken(self, value: Any) -> Value:
        """Return the word.

        Raises:
            SettingError: it is none of them.
        """
        if not isinstance(value, str) or value not in self.options:
            raise SettingError(f"one of {', '.join(self.options)}", value)
        return value

    def from_rviz(self, value: Any) -> Value:
        """Return our word for one of RViz's.

        Raises:
            SettingError: it is none of them.
        """
        for ours, theirs in self.options.items():
            if isinstance(value, str) and value in theirs.split("|"):
                return ours
        raise SettingError(f"one of {', '.join(self.options.values()).replace('|', ', ')}", value)

    def to_rviz(self, value: Any) -> Any:
        """Return a value as files of RViz have it."""
        return self.options[value].split("|")[0]

    def description(self) -> dict[str, Any]:
        """Return what a page has to know to offer it."""
        return {**super().description(), "options": list(self.options)}


@dataclass(frozen=True)
class TextSetting(Setting):
    """A short text, as the name of a frame or a topic."""

    empty: str = ""
    """What files of RViz have in place of an empty one."""

    kind = "text"

    def taken(self, value: Any) -> Value:
        """Return the text.

        Raises:
            SettingError: it is none, or too long.
        """
        if not _is_name(value):
            raise SettingError(f"a text of at most {MAX_TEXT} characters", value)
        return str(value)

    def from_rviz(self, value: Any) -> Value:
        """Return a text of a file of RViz.

        Raises:
            SettingError: it is none, or too long.
        """
        return "" if value == self.empty else self.taken(value)

    def to_rviz(self, value: Any) -> Any:
        """Return a value as files of RViz have it."""
        return value or self.empty


def _is_name(value: Any) -> bool:
    if not isinstance(value, str) or len(value) > MAX_TEXT:
        return False
    try:
        value.encode()
    except UnicodeEncodeError:  # half of a surrogate pair, which no name has
        return False
    return True


@dataclass(frozen=True)
class NamesSetting(Setting):
    """Names of what is not shown, of parts that are there or may come: namespaces, frames, links."""

    others: frozenset[str] = frozenset()
    """Keys beside the names in files of RViz."""
    is_nested: bool = False
    """Whether RViz has a mapping for each name, with its own settings."""

    kind = "names"

    def taken(self, value: Any) -> Value:
        """Return the names, each once, in order.

        Raises:
            SettingError: it is not a list of them.
        """
        if not isinstance(value, list) or len(value) > MAX_NAMES or not all(map(_is_name, value)):
            raise SettingError(f"a list of at most {MAX_NAMES} names", value)
        return tuple(sorted(set(value)))

    def from_rviz(self, value: Any) -> Value:
        """Return the names that a file of RViz says are off.

        Raises:
            SettingError: it is not a mapping of names.
        """
        if not isinstance(value, dict):
            raise SettingError("a mapping of names to true or false", value)
        rows = {name: self._is_on(row) for name, row in value.items() if name not in self.others}
        return self.taken([str(name) for name, is_on in rows.items() if not is_on])

    def _is_on(self, row: Any) -> bool:
        if self.is_nested:
            return not isinstance(row, dict) or row.get("Value", True) is not False
        return row is not False

    def to_rviz(self, value: Any) -> Any:
        """Return a value as files of RViz have it."""
        return {name: {"Value": False} if self.is_nested else False for name in value}


def to_file(value: Any) -> Any:
    """Return a value as files have it."""
    return list(value) if isinstance(value, tuple) else value


def taken_anywhere(name: str, value: Any, tables: Iterable[Mapping[str, Setting]]) -> Value:
    """Return a value of a setting of any of some displays, because it is not known which it is of.

    Raises:
        SettingError: it is none in all of them; the text is of the first one.
    """
    fault: SettingError | None = None
    for table in tables:
        if name in table:
            try:
                return table[name].taken(value)
            except SettingError as error:
                fault = fault or error
    raise fault or SettingError("a setting that a display has", name)


def usual_values(settings: Mapping[str, Setting]) -> dict[str, Any]:
    """Return the value of each setting that counts where none is set."""
    return {name: setting.usual for name, setting in settings.items()}


def queue_setting(rviz: str) -> NumberSetting:
    """Return the setting of how many messages of a topic may wait to be taken; 0: as is usual for it."""
    return NumberSetting(0, rviz, 0, MAX_DEPTH, is_whole=True)


def _opacity(usual: float = 1.0, rviz: str = "Alpha") -> NumberSetting:
    return NumberSetting(usual, rviz, 0.0, 1.0)


def _length(usual: float, rviz: str) -> NumberSetting:
    return NumberSetting(usual, rviz, 0.0, 1e4)


def _history(rviz: str, usual: int = 1) -> NumberSetting:
    return NumberSetting(usual, rviz, 1, MAX_HISTORY, is_whole=True)


def _without(settings: Mapping[str, Setting], names: Iterable[str]) -> dict[str, Setting]:
    return {name: setting for name, setting in settings.items() if name not in names}


CLOUD_SETTINGS: Mapping[str, Setting] = {
    "style": ChoiceSetting(
        "points",
        "Style",
        {
            "points": "Points",
            "spheres": "Spheres",
            "squares": "Flat Squares|Squares|Tiles",
            "boxes": "Boxes",
        },
    ),
    "size_px": NumberSetting(3.0, "Size (Pixels)", 0.1, 1e3),
    "size": NumberSetting(0.03, "Size (m)", 1e-4, 1e3),
    "opacity": _opacity(),
    "color_by": ChoiceSetting(
        "field",
        "Color Transformer",
        {"field": "Intensity|RGB8|RGBF32|RGB", "axis": "AxisColor", "flat": "FlatColor"},
    ),
    "color": ColorSetting((255, 255, 255), "Color"),
    "rainbow": FlagSetting(True, "Use rainbow"),
    "invert": FlagSetting(False, "Invert Rainbow"),
    "low_color": ColorSetting((0, 0, 0), "Min Color"),
    "high_color": ColorSetting((255, 255, 255), "Max Color"),
    "auto_range": FlagSetting(True, "Autocompute Intensity Bounds"),
    "low": NumberSetting(0.0, "Min Intensity", -1e30, 1e30),
    "high": NumberSetting(4096.0, "Max Intensity", -1e30, 1e30),
    "axis": ChoiceSetting("z", "Axis", {"x": "X", "y": "Y", "z": "Z"}),
    "axis_fixed": FlagSetting(True, "Use Fixed Frame"),
    "axis_auto_range": FlagSetting(True, "Autocompute Value Bounds/Value"),
    "axis_low": NumberSetting(-10.0, "Autocompute Value Bounds/Min Value", -1e12, 1e12),
    "axis_high": NumberSetting(10.0, "Autocompute Value Bounds/Max Value", -1e12, 1e12),
    "decay_s": NumberSetting(0.0, "Decay Time", 0.0, 1e6),
}
"""Of clouds. The field that colours them is the display's choice, because a message says which ones there are.

The style `points` has its size in pixels; those that are transparent have it in metres, as the other styles.
"""

SCAN_SETTINGS: Mapping[str, Setting] = {
    **CLOUD_SETTINGS,
    "size": NumberSetting(0.05, "Size (m)", 1e-4, 1e3),
    "color": ColorSetting((255, 70, 70), "Color"),
}

_ARROW: Mapping[str, Setting] = {
    "shape": ChoiceSetting("arrow", "Shape", {"arrow": "Arrow", "axes": "Axes"}),
    "color": ColorSetting((255, 60, 60), "Color"),
    "opacity": _opacity(),
    "shaft_length": _length(0.4, "Shaft Length"),
    "shaft_radius": _length(0.02, "Shaft Radius"),
    "head_length": _length(0.1, "Head Length"),
    "head_radius": _length(0.05, "Head Radius"),
    "axes_length": _length(0.3, "Axes Length"),
    "axes_radius": _length(0.012, "Axes Radius"),
}
POSE_SETTINGS = _ARROW

_COVARIANCE: Mapping[str, Setting] = {
    "covariance": FlagSetting(True, "Covariance/Value"),
    "covariance_color": ColorSetting((200, 90, 255), "Covariance/Position/Color"),
    "covariance_opacity": _opacity(0.3, "Covariance/Position/Alpha"),
    "covariance_scale": NumberSetting(1.0, "Covariance/Position/Scale", 0.0, 1e4),
}

POSE_WITH_COVARIANCE_SETTINGS: Mapping[str, Setting] = {
    **_ARROW,
    "color": ColorSetting((255, 210, 60), "Color"),
    **_COVARIANCE,
}

ODOMETRY_SETTINGS: Mapping[str, Setting] = {
    **{
        name: type(setting)(
            **{
                **vars(setting),
                "rviz": "Shape/Value" if name == "shape" else f"Shape/{setting.rviz}",
            }
        )
        for name, setting in _without(POSE_WITH_COVARIANCE_SETTINGS, _COVARIANCE).items()
    },
    **_COVARIANCE,
    "history": _history("Keep"),
    "position_tolerance": _length(0.1, "Position Tolerance"),
    "angle_tolerance": _length(0.1, "Angle Tolerance"),
    "speed": FlagSetting(True, ""),
}
"""Further odometry is drawn once it has moved, or turned, by a tolerance [m, rad]."""

POSE_ARRAY_SETTINGS: Mapping[str, Setting] = {
    **_ARROW,
    "shape": ChoiceSetting("axes", "Shape", {"axes": "Axes", "arrow": "Arrow (Flat)|Arrow (3D)"}),
    "shaft_length": _length(0.23, "Shaft Length"),
    "shaft_radius": _length(0.01, "Shaft Radius"),
    "head_length": _length(0.07, "Head Length"),
    "head_radius": _length(0.03, "Head Radius"),
}

PATH_SETTINGS: Mapping[str, Setting] = {
    "color": ColorSetting((60, 220, 90), "Color"),
    "opacity": _opacity(),
    "line": ChoiceSetting("thin", "Line Style", {"thin": "Lines", "wide": "Billboards"}),
    "width": _length(0.03, "Line Width"),
    "poses": ChoiceSetting("none", "Pose Style", {"none": "None", "axes": "Axes", "arrows": "Arrows"}),
    "pose_color": ColorSetting((255, 85, 255), "Pose Color"),
    "axes_length": _length(0.3, "Length"),
    "axes_radius": _length(0.03, "Radius"),
    "shaft_length": _length(0.1, "Shaft Length"),
    "shaft_diameter": _length(0.1, "Shaft Diameter"),
    "head_length": _length(0.2, "Head Length"),
    "head_diameter": _length(0.3, "Head Diameter"),
    "history": _history("Buffer Length"),
}

POLYGON_SETTINGS: Mapping[str, Setting] = {
    "color": ColorSetting((255, 170, 40), "Color"),
    "opacity": _opacity(),
}

POINT_SETTINGS: Mapping[str, Setting] = {
    "color": ColorSetting((200, 90, 255), "Color"),
    "opacity": _opacity(),
    "radius": _length(0.1, "Radius"),
    "history": _history("History Length"),
}

RANGE_SETTINGS: Mapping[str, Setting] = {
    "color": ColorSetting((80, 160, 255), "Color"),
    "opacity": _opacity(0.4),
    "history": _history("Buffer Length"),
}

MAP_SETTINGS: Mapping[str, Setting] = {
    "opacity": _opacity(),
    "colors": ChoiceSetting("map", "Color Scheme", {"map": "map", "costmap": "costmap", "raw": "raw"}),
    "binary": FlagSetting(False, "Binary representation"),
    "threshold": NumberSetting(100, "Binary threshold", 0, 100, is_whole=True),
}

CELLS_SETTINGS: Mapping[str, Setting] = {
    "color": ColorSetting((25, 255, 0), "Color"),
    "opacity": _opacity(),
}

WRENCH_SETTINGS: Mapping[str, Setting] = {
    "force_color": ColorSetting((204, 51, 51), "Force Color"),
    "torque_color": ColorSetting((204, 204, 51), "Torque Color"),
    "opacity": _opacity(),
    "force_scale": NumberSetting(2.0, "Force Arrow Scale"),
    "torque_scale": NumberSetting(2.0, "Torque Arrow Scale"),
    "width": NumberSetting(0.5, "Arrow Width", 0.001),
    "history": _history("History Length"),
}
"""As in RViz. The scales are the lengths of arrows of 1 N and 1 N m; one shorter than the width is hidden."""

TWIST_SETTINGS: Mapping[str, Setting] = {
    "linear_color": ColorSetting((204, 51, 51), "Linear Color"),
    "angular_color": ColorSetting((204, 204, 51), "Angular Color"),
    "opacity": _opacity(),
    "linear_scale": NumberSetting(2.0, "Linear Arrow Scale"),
    "angular_scale": NumberSetting(2.0, "Angular Arrow Scale"),
    "width": NumberSetting(0.5, "Arrow Width", 0.001),
    "history": _history("History Length"),
}
"""As those of wrenches, for 1 m/s and 1 rad/s."""

EFFORT_SETTINGS: Mapping[str, Setting] = {
    "description": TextSetting("robot_description", "Robot Description"),
    "opacity": _opacity(),
    "width": NumberSetting(0.02, "Width", 1e-4, 1e3),
    "scale": NumberSetting(1.0, "Scale"),
    "history": _history("History Length"),
}
"""The scale is the length of the arrow of an effort that is at its limit."""

MARKER_SETTINGS: Mapping[str, Setting] = {"hidden_namespaces": NamesSetting((), "Namespaces")}

INTERACTIVE_SETTINGS: Mapping[str, Setting] = {
    "descriptions": FlagSetting(True, "Show Descriptions"),
    "axes": FlagSetting(False, "Show Axes"),
}

ROBOT_SETTINGS: Mapping[str, Setting] = {
    "opacity": _opacity(),
    "visual": FlagSetting(True, "Visual Enabled"),
    "collision": FlagSetting(False, "Collision Enabled"),
    "hidden_links": NamesSetting(
        (),
        "Links",
        frozenset(
            (
                "All Links Enabled",
                "Expand Joint Details",
                "Expand Link Details",
                "Expand Tree",
                "Link Tree Style",
            )
        ),
        is_nested=True,
    ),
}

_FRAME = TextSetting("", "Reference Frame", "<Fixed Frame>")

AXES_SETTINGS: Mapping[str, Setting] = {
    "frame": _FRAME,
    "length": _length(1.0, "Length"),
    "radius": _length(0.1, "Radius"),
    "opacity": _opacity(),
}

GRID_SETTINGS: Mapping[str, Setting] = {
    "frame": _FRAME,
    "cells": NumberSetting(10, "Plane Cell Count", 1, 1000, is_whole=True),
    "size": NumberSetting(1.0, "Cell Size", 1e-4, 1e4),
    "plane": ChoiceSetting("xy", "Plane", {"xy": "XY", "xz": "XZ", "yz": "YZ"}),
    "color": ColorSetting((160, 160, 164), "Color"),
    "opacity": _opacity(0.5),
    "line": ChoiceSetting("thin", "Line Style/Value", {"thin": "Lines", "wide": "Billboards"}),
    "width": _length(0.03, "Line Style/Line Width"),
    **{axis.lower(): NumberSetting(0.0, f"Offset/{axis}", -1e6, 1e6) for axis in "XYZ"},
}

FRAME_SETTINGS: Mapping[str, Setting] = {
    "show_axes": FlagSetting(True, "Show Axes"),
    "show_arrows": FlagSetting(True, "Show Arrows"),
    "timeout_s": NumberSetting(0.0, "Frame Timeout", 0.0, 1e6),
    "hidden_frames": NamesSetting((), "Frames", frozenset(("All Enabled",)), is_nested=True),
}
"""Of the frames: a frame of which nothing has come for the timeout is not drawn; 0: it is always drawn, in grey."""
