"""What a message shows in a notebook, as HTML: a table of its fields, and of a scan the points."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from tfloom.common.notebook import drawing, folded, shortened, table

__all__ = ["message_html"]

MAX_MESSAGES = 10
"""How many messages of a sequence are shown."""
MAX_NUMBERS = 20
SCAN = "sensor_msgs/msg/LaserScan"


def message_html(message: Any) -> str:
    """Return a message as a table; messages in it are tables that can be folded."""
    picture = _scan_drawing(message) if message._TYPE_NAME == SCAN else ""
    return f"<b>{escape(message._TYPE_NAME)}</b>{_table(message)}{picture}"


def _table(message: Any) -> str:
    return table(
        (escape(name), _value(getattr(message, name), kind)) for name, kind in message._FIELDS.items()
    )


def _value(value: Any, kind: str) -> str:
    if hasattr(value, "_FIELDS"):
        return folded(kind, _table(value), is_open=len(value._FIELDS) <= 4)
    if isinstance(value, str):
        return escape(shortened(value))
    if isinstance(value, Sequence) or hasattr(value, "tolist"):
        return _sequence(value, kind)
    return escape(str(value))


def _sequence(values: Any, kind: str) -> str:
    count = len(values)
    if count and hasattr(values[0], "_FIELDS"):
        shown = "".join(_table(item) for item in values[:MAX_MESSAGES])
        rest = f"{count - MAX_MESSAGES} more" if count > MAX_MESSAGES else ""
        return folded(f"{kind}: {count}", shown + rest, is_open=count <= 1)
    shown = ", ".join(_number(number) for number in list(values[:MAX_NUMBERS]))
    return f"{count}: [{shown}{', …' if count > MAX_NUMBERS else ''}]"


def _number(value: Any) -> str:
    return escape(shortened(str(value.item() if hasattr(value, "item") else value)))


def _scan_drawing(scan: Any) -> str:
    """Return the points of a scan in its own frame; ranges outside of the sensor's limits are not points."""
    import numpy as np

    ranges = np.asarray(scan.ranges, np.float64)
    with np.errstate(all="ignore"):  # a scan may hold any numbers
        angles = scan.angle_min + scan.angle_increment * np.arange(len(ranges))
        points = np.column_stack((ranges * np.cos(angles), ranges * np.sin(angles)))
        points = points[(ranges >= scan.range_min) & (ranges <= scan.range_max)]
    return drawing(points, f"the points in the frame {shortened(scan.header.frame_id)}", as_line=False)
