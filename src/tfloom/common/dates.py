"""A time as date and clock, for people to read."""

from __future__ import annotations

from datetime import datetime, timezone

__all__ = ["utc_text"]


def utc_text(stamp_s: float) -> str:
    """Return a time as date and clock in UTC, and as a number where no date is so late."""
    try:
        return datetime.fromtimestamp(stamp_s, timezone.utc).strftime("%Y-%m-%d %H:%M:%S UTC")
    except (OverflowError, ValueError, OSError):
        return f"{stamp_s} s"
