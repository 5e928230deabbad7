"""Counts, durations and ages in words."""

from __future__ import annotations

__all__ = ["NS_PER_S", "ago", "counted", "seconds_text"]
NS_PER_S = 1e9


def counted(count: int, noun: str) -> str:
    """Return a count with its noun in the singular or plural."""
    return f"{count} {noun}{'' if count == 1 else 's'}"


def seconds_text(duration_s: float) -> str:
    """Return a duration in seconds with as many digits as matter: three below 1 s, two below 100 s."""
    if abs(duration_s) < 1.0:
        return f"{duration_s:.3f} s"
    return f"{duration_s:.2f} s" if abs(duration_s) < 100.0 else f"{duration_s:.0f} s"


def ago(stamp_ns: int, now_ns: int) -> str:
    """Return how long ago a stamp is, or how far ahead."""
    age_s = (now_ns - stamp_ns) / NS_PER_S
    return f"{seconds_text(age_s)} ago" if age_s >= 0.0 else f"{seconds_text(-age_s)} ahead"
