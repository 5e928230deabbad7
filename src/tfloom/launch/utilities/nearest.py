"""The nearest known name, for errors."""

from __future__ import annotations

from collections.abc import Iterable

__all__ = ["did_you_mean", "names_with_hints", "nearest"]


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
