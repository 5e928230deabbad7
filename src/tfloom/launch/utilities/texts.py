"""Texts: the nearest known name, for errors, and values that are plain to see without YAML."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

__all__ = ["did_you_mean", "names_with_hints", "nearest", "plain_value"]


def nearest(name: str, known: Iterable[str]) -> str | None:
    """Return the known name that is nearest to a name; None if none is near."""
    import difflib

    near = difflib.get_close_matches(name, sorted(known), 1, 0.6)
    return near[0] if near else None


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return "; did you mean 'x'?" with the known name that is nearest; "" if none is near."""
    near = nearest(name, known)
    return "" if near is None else f"; did you mean '{near}'?"


def names_with_hints(names: Iterable[str], known: Iterable[str]) -> str:
    """Return unknown names as a set, and after them for each the known name that is nearest, if one is near."""
    ordered = sorted(names)
    near = "".join(
        f"{hint} (for '{name}')" if len(ordered) > 1 else hint
        for name in ordered
        if (hint := did_you_mean(name, known))
    )
    return "{" + ", ".join(f"'{name}'" for name in ordered) + "}" + near


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
