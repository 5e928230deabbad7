"""The nearest known name, for errors."""

from __future__ import annotations

from collections.abc import Iterable

__all__ = ["did_you_mean"]


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return "; did you mean 'x'?" with the known name that is nearest; "" if none is near."""
    import difflib

    near = difflib.get_close_matches(name, sorted(known), 1, 0.6)
    return f"; did you mean '{near[0]}'?" if near else ""
