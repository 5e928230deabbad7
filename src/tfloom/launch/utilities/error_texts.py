"""Additions to the text of an error that keeps its type."""

from __future__ import annotations

__all__ = ["add_to_error"]


def add_to_error(error: Exception, *, before: str = "", after: str = "") -> None:
    """Add to an error's text, if its first argument is its whole text, as it is with most types.

    Args:
        error: The error.
        before: What stands before its text.
        after: What stands after it.
    """
    if isinstance(error, SyntaxError):
        error.msg = f"{before}{error.msg}{after}"
    elif len(error.args) == 1 and isinstance(error.args[0], str) and str(error) == error.args[0]:
        error.args = (f"{before}{error.args[0]}{after}",)
