"""The comments of a definition as `rosidl_adapter.parser` has them: of the message, and of each field and constant."""

from __future__ import annotations

import re
import textwrap
from typing import Any, NamedTuple

__all__ = ["Comments", "annotations_of", "find_comments"]

_DELIMITER = "#"
_ELEMENT = re.compile(r"\S+\s+([A-Za-z]\w*)")
_UNIT = re.compile(r"\s*\[([^,\]]+)\]")
"""A unit in brackets; with a comma it might be a range."""


class Comments(NamedTuple):
    """The lines of comments, without their `#`."""

    message: list[str]
    """Those at the start of the file, up to its first line without `#`."""
    elements: dict[str, list[str]]
    """Of each field and constant, by name: those above it, the one behind it, and the indented ones below it."""


def find_comments(text: str) -> Comments:
    """Return the comments of the definition of a message."""
    lines = text.replace("\t", " ").splitlines()
    first = next((number for number, line in enumerate(lines) if not line.startswith(_DELIMITER)), len(lines))
    comments = Comments([line.lstrip(_DELIMITER) for line in lines[:first]], {})
    above: list[str] = []
    current: list[str] | None = None
    for line in lines[first:]:
        code, delimiter, _ = line.rstrip().partition(_DELIMITER)
        comment = line.rstrip()[len(code) :].lstrip(_DELIMITER)
        if code and not code.strip():  # indented, so it goes on about what stands above
            if current is not None:
                current.append(comment)
            continue
        if delimiter:
            above.append(comment)
        if match := _ELEMENT.match(code):
            current = comments.elements.setdefault(match[1], [])
            current += above
            above = []
    return comments


def annotations_of(lines: list[str]) -> dict[str, Any]:
    """Return `comment`, the lines without the indentation that all have, and `unit` where they have one in brackets."""
    annotations: dict[str, Any] = {}
    units = _UNIT.findall("\n".join(lines))
    if len(units) == 1:
        annotations["unit"] = units[0]
        lines = [_UNIT.sub("", line) for line in lines]
    kept: list[str] = []
    for line in lines:
        # No empty lines at the start, and no two in a row.
        if line or (kept and kept[-1]):
            kept.append(line)
    while kept and not kept[-1]:
        kept.pop()
    annotations["comment"] = textwrap.dedent("\n".join(kept)).split("\n") if kept else []
    return annotations
