"""Paths of numeric fields: `twist.linear.x`, `ranges[3]`, `poses[0].position.x`."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

from tfloom.rosidl.class_search import find_field_class
from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.spec import STRINGS
from tfloom.viewer.page_command import PageError

if TYPE_CHECKING:
    from tfloom.rosidl.message import Message

__all__ = ["Path", "number_at", "numeric_paths", "parse_path"]

Path = tuple[str | int, ...]
"""Names of fields, and indices of arrays."""

MAX_PATHS = 500
"""Number of a type's paths that a page may choose from; any other may be written."""
MAX_DEPTH = 20
_PART = re.compile(r"([A-Za-z][A-Za-z0-9_]*)(?:\[(\d{1,9})\])?")


def parse_path(message_class: type[Message], text: str) -> Path:
    """Return the path of a numeric field of a type.

    Raises:
        PageError: there is no such field, or it is not a number; the text has the fields there are.
    """
    steps: list[str | int] = []
    current: type[Message] | None = message_class
    for part in text.strip().split("."):
        match = _PART.fullmatch(part)
        if match is None:
            raise PageError(f"{text!r} is not a path of a field, as pose.position.x or ranges[0]")
        name, index = match[1], match[2]
        if current is None or name not in current._FIELDS:
            owner = message_class if current is None else current
            has = ", ".join(owner._FIELDS) or "none"
            place = f"{'.'.join(map(str, steps))} is a value" if current is None else f"its fields are {has}"
            raise PageError(f"{message_class._TYPE_NAME} has no field {text}: {place}")
        type_ = parse_type(current._FIELDS[name])
        steps.append(name)
        if type_.shape and index is None:
            raise PageError(f"{text}: {name} is an array, so it needs an index, as {name}[0]")
        if not type_.shape and index is not None:
            raise PageError(f"{text}: {name} is not an array")
        if index is not None:
            if type_.shape in {"array", "bounded"} and int(index) >= type_.length:
                raise PageError(f"{text}: {name} has at most {type_.length} elements, which begin with 0")
            steps.append(int(index))
        current = None if type_.is_primitive else find_field_class(type_.base)
        if type_.base in STRINGS:
            raise PageError(f"{text} is a text, and no number")
    if current is not None:
        raise PageError(f"{text} is a message: choose one of its fields, {', '.join(current._FIELDS)}")
    return tuple(steps)


def number_at(message: Any, path: Path) -> float:
    """Return the number of a message at a path; NaN where an array is too short."""
    value = message
    for step in path:
        if isinstance(step, str):
            value = getattr(value, step)
        elif step < len(value):
            value = value[step]
        else:
            return math.nan
    return float(value[0] if isinstance(value, bytes) else value)


def numeric_paths(message_class: type[Message]) -> list[str]:
    """Return the paths of a type's numeric fields in order; of arrays, that of the first element."""
    paths: list[str] = []

    def visit(current: type[Message], prefix: str, depth: int) -> None:
        for name, text in current._FIELDS.items():
            if len(paths) >= MAX_PATHS:
                return
            type_ = parse_type(text)
            path = f"{prefix}{name}{'[0]' if type_.shape else ''}"
            if not type_.is_primitive:
                if depth < MAX_DEPTH:
                    visit(find_field_class(type_.base), f"{path}.", depth + 1)
            elif type_.base not in STRINGS:
                paths.append(path)

    visit(message_class, "", 0)
    return paths
