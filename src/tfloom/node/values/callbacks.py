"""What is said of a callback that can't be called."""

from __future__ import annotations

import reprlib
from typing import Any

__all__ = ["not_callable"]


def not_callable(callback: Any) -> str:
    """Return what a program gave in place of a callback, and what was probably meant."""
    if callback is None:
        return (
            "got None: if it is the result of a call, as of `callback()`, write `callback`, without brackets"
        )
    return f"got {reprlib.repr(callback)} of class {type(callback).__name__}, which can't be called"
