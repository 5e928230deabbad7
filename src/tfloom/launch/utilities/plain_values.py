"""Texts whose value by YAML's rules is plain to see, so that yaml, which takes 15 ms to load, isn't needed."""

from __future__ import annotations

import re
from typing import Any

__all__ = ["plain_value"]

_WORD = re.compile(r"[A-Za-z_/][A-Za-z0-9_/.-]*")
_INTEGER = re.compile(r"[-+]?(?:0|[1-9][0-9]*)")
_FLOAT = re.compile(r"[-+]?[0-9]+\.[0-9]+")
_BOOLEANS = {"true": True, "yes": True, "on": True, "false": False, "no": False, "off": False}
_MAX_DIGITS = 18
"""Longer integers are left to yaml, because Python limits their length."""


def plain_value(text: str) -> Any:
    """Return the text itself if it is a word, else the integer, float or boolean; None if YAML has to be read."""
    if _WORD.fullmatch(text):
        lower = text.lower()
        if lower in _BOOLEANS:
            return _BOOLEANS[lower] if text in {lower, text.capitalize(), text.upper()} else text
        return None if lower == "null" else text
    if len(text) <= _MAX_DIGITS:
        if _INTEGER.fullmatch(text):
            return int(text)
        if _FLOAT.fullmatch(text):
            return float(text)
    return None
