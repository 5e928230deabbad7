"""Colours and fonts that the pictures share."""

from __future__ import annotations

from tfloom.tf2_tools.drawing.fonts import Font

INK = "#1c2733"
FAINT = "#5d6975"
LINE = "#8796a5"
HAIRLINE = "#d3dae1"
STRIPE = "#f5f7f9"
PAPER = "#ffffff"
FILL = "#e3eefb"
OUTLINE = "#3d74b8"
ROOT_FILL = "#274b78"
STALE_FILL = "#ececec"
STALE = "#9a9a9a"
LOOP = "#b3362b"

NAME = Font(is_bold=True, size=9.5)
TEXT = Font(is_bold=False, size=6.5)
TITLE = Font(is_bold=True, size=12.0)
SUBTITLE = Font(is_bold=False, size=7.5)
ROW_NAME = Font(is_bold=True, size=7.5)
ROW_TEXT = Font(is_bold=False, size=7.0)

FRAME_STYLES = {
    "root": (ROOT_FILL, ROOT_FILL, PAPER),
    "live": (FILL, OUTLINE, INK),
    "static": (PAPER, OUTLINE, INK),
    "stale": (STALE_FILL, STALE, FAINT),
    "loop": (PAPER, LOOP, LOOP),
}
"""Fill, outline and letters of a frame's box, by its state."""

LINE_COLORS = {"live": OUTLINE, "static": OUTLINE, "stale": STALE, "loop": LOOP, "root": LINE}
"""Colour of the line to a frame, by its state."""

STATIC_DASH = (3.0, 2.0)
