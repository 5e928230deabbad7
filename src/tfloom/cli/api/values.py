"""What a command line's words stand for: numbers, and words that complete them."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import Any

__all__ = ["argument_key", "positive_float", "positive_int"]


def positive_int(string: str) -> int:
    """Return a whole number above 0.

    Raises:
        argparse.ArgumentTypeError: it is no such number.
    """
    value: int = _positive(int, string, "value must be a positive integer")
    return value


def positive_float(inval: str) -> float:
    """Return a number above 0.

    Raises:
        argparse.ArgumentTypeError: it is no such number.
    """
    value: float = _positive(float, inval, "value must be a positive float")
    return value


def _positive(kind: Callable[[str], Any], text: str, otherwise: str) -> Any:
    try:
        value = kind(text)
    except ValueError:
        value = 0
    if not value > 0:
        raise argparse.ArgumentTypeError(otherwise)
    return value


def argument_key(given: str | None, usual: str) -> str:
    """Return the name of the argument that a completer reads."""
    return usual if given is None else given
