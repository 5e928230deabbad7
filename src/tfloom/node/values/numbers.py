"""What is said of a period or a rate that is no number."""

from __future__ import annotations

import reprlib

__all__ = ["not_a_number"]


def not_a_number(what: str, given: object) -> str:
    """Return what is needed, as `a period in seconds`, and what a program gave."""
    return f"needs {what}, as 0.5, got {reprlib.repr(given)} of class {type(given).__name__}"
