"""What is said of a callback that can't be called."""

from __future__ import annotations

from typing import Any

from tfloom.common.text import given_text

__all__ = ["not_callable"]


def not_callable(callback: Any) -> str:
    """Return what a program gave in place of a callback, and what was probably meant."""
    if callback is None:
        return (
            "got None: if it is the result of a call, as of `callback()`, write `callback`, without brackets"
        )
    return f"got {given_text(callback)}, which can't be called"
