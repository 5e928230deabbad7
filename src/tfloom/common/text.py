"""What a program gave in place of something else, for the texts of errors."""

from __future__ import annotations

import reprlib

__all__ = ["given_text"]


def given_text(value: object) -> str:
    """Return a value, cut where it is long, and its class, as `'1' of class str`."""
    return f"{reprlib.repr(value)} of class {type(value).__name__}"
