"""Settings of displays: their names here and in files of RViz, and which values they may have."""

from __future__ import annotations

import re
import reprlib
from typing import Any, NamedTuple, Protocol

from tfloom.viewer.shapes import Color

__all__ = ["SETTINGS", "ColorSetting", "NumberSetting", "Setting", "SettingError", "Value"]

Value = float | Color
_RVIZ_COLOR = re.compile(r"\s*(\d{1,3})\s*;\s*(\d{1,3})\s*;\s*(\d{1,3})\s*", re.ASCII)


class SettingError(ValueError):
    """A value is not one of its setting; the text says which ones are, as 'has to be …, not …'."""


class Setting(Protocol):
    """What a setting may be."""

    @property
    def rviz(self) -> str:
        """The name of the property in files of RViz."""

    def taken(self, value: Any) -> Value:
        """Return a value of a file.

        Raises:
            SettingError: it is none.
        """


class NumberSetting(NamedTuple):
    """A number in a range."""

    rviz: str
    least: float
    greatest: float
    is_whole: bool = False

    def taken(self, value: Any) -> Value:
        """Return the number.

        Raises:
            SettingError: it is none, or out of the range.
        """
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if is_number and self.least <= value <= self.greatest and (not self.is_whole or value == int(value)):
            return int(value) if self.is_whole else float(value)
        kind = "a whole number" if self.is_whole else "a number"
        raise SettingError(
            f"has to be {kind} from {self.least:g} to {self.greatest:g}, not {reprlib.repr(value)}"
        )


class ColorSetting(NamedTuple):
    """A colour."""

    rviz: str

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
        raise SettingError(
            f"has to be three whole numbers from 0 to 255, as [204, 51, 51], not {reprlib.repr(value)}"
        )


def _is_channel(part: Any) -> bool:
    return isinstance(part, int) and not isinstance(part, bool) and 0 <= part <= 255


SETTINGS: dict[str, Setting] = {
    "force_color": ColorSetting("Force Color"),
    "torque_color": ColorSetting("Torque Color"),
    "opacity": NumberSetting("Alpha", 0.0, 1.0),
    "force_scale": NumberSetting("Force Arrow Scale", 0.0, 1e6),
    "torque_scale": NumberSetting("Torque Arrow Scale", 0.0, 1e6),
    "width": NumberSetting("Arrow Width", 0.001, 1e6),
    "history": NumberSetting("History Length", 1, 50, is_whole=True),
}
"""By their names in layouts; which kind of display has which is in `kinds.py`, with the values that none sets.

`history` is the number of messages that are shown, the last ones: a display that has it gets them in their order.
"""
