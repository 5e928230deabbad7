"""A drawn tree as one web page: search, zoom, and the way from a frame to its root. It uses no network."""

from __future__ import annotations

import json
import re
from html import escape
from pathlib import Path

from tfloom.tf2_tools.drawing.shapes import Picture
from tfloom.tf2_tools.drawing.svg import svg_text
from tfloom.tf2_tools.tree_pictures.tree import FrameTree, tree_json

PAGE = Path(__file__).with_name("web_page.html")
"""With a name in `@` where each text belongs; it has its style and its script in it, because it is one file."""


def html_text(tree: FrameTree, picture: Picture) -> str:
    """Return the page."""
    data = json.dumps(tree_json(tree), ensure_ascii=True, allow_nan=False).replace("<", "\\u003c")
    texts = {"@TITLE@": escape(picture.title), "@SVG@": svg_text(picture), "@DATA@": data}
    # In one pass, because a frame may have the name of a place.
    return re.sub("|".join(texts), lambda place: texts[place[0]], PAGE.read_text("utf-8"))
