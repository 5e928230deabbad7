"""Parsing of the values in a definition: constants and defaults."""

from __future__ import annotations

import re

from tfloom.rosidl import spec

_ESCAPES = {"n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "f": "\f", "v": "\v"}
_QUOTED = re.compile(r"""("(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')""", re.DOTALL)


def parse_value(type_: spec.Type, text: str) -> spec.Value:
    """Parse a constant or a default.

    Args:
        type_: Its type; for an array or a sequence, the text is a list in brackets.
        text: The text after the name, stripped.

    Returns:
        A bool, int, float, str, bytes of length 1 (`byte`), or a list of them.

    Raises:
        ValueError: the text is not a value of the type; the text of the error has the reason.
    """
    if not type_.shape:
        return _parse_single(type_, text.strip())
    if not (text.startswith("[") and text.endswith("]")):
        raise ValueError(f"expected a list in brackets, got {text}")
    values = [_parse_single(type_.element, part) for part in _split_list(text[1:-1])]
    if type_.shape == "array" and len(values) != type_.length:
        raise ValueError(f"{type_} takes {type_.length} values, got {len(values)}")
    if type_.shape == "bounded" and len(values) > type_.length:
        raise ValueError(f"{type_} takes at most {type_.length} values, got {len(values)}")
    return values


def _split_list(text: str) -> list[str]:
    """Split at the commas outside quotes."""
    parts = [""]
    for piece in _QUOTED.split(text):
        if _QUOTED.fullmatch(piece):
            parts[-1] += piece
            continue
        first, *rest = piece.split(",")
        parts[-1] += first
        parts += rest
    stripped = [part.strip() for part in parts]
    return [] if stripped == [""] else stripped


def _parse_single(type_: spec.Type, text: str) -> spec.Value:
    if type_.base == "bool":
        if text.lower() not in {"true", "false", "1", "0"}:
            raise ValueError(f"expected true or false, got {text or 'nothing'}")
        return text.lower() in {"true", "1"}
    if type_.base in spec.FLOATS:
        try:
            return float(text)
        except ValueError:
            raise ValueError(f"expected a number, got {text or 'nothing'}") from None
    if type_.base in spec.STRINGS:
        return _parse_string(type_, text)
    return _parse_integer(type_, text)


def _parse_integer(type_: spec.Type, text: str) -> int | bytes:
    try:
        value = int(text, 0) if not re.fullmatch(r"[-+]?0\d+", text) else int(text)
    except ValueError:
        raise ValueError(f"expected an integer, got {text or 'nothing'}") from None
    least, greatest = spec.INTEGER_RANGES[type_.base]
    if not least <= value <= greatest:
        raise ValueError(f"{value} is outside {type_.base}'s range [{least}, {greatest}]")
    return bytes([value]) if type_.base == "byte" else value


def _parse_string(type_: spec.Type, text: str) -> str:
    if text[:1] in {'"', "'"}:
        if not _QUOTED.fullmatch(text):
            raise ValueError(f"the quotes of {text} don't match")
        text = re.sub(r"\\(.)", lambda m: _ESCAPES.get(m[1], m[1]), text[1:-1], flags=re.DOTALL)
    if type_.string_bound and len(text) > type_.string_bound:
        raise ValueError(f"{type_} takes at most {type_.string_bound} characters, got {len(text)}")
    return text
