"""What is said of a machine's clock whose time doesn't fit into a message."""

from __future__ import annotations

__all__ = ["describe_machine_clock"]


def describe_machine_clock(time_ns: int) -> str:
    """Return a clause that names the machine's clock and its value, a time in UTC.

    Args:
        time_ns: What the clock says [ns since the epoch].
    """
    from datetime import datetime, timedelta, timezone

    utc = datetime(1970, 1, 1, tzinfo=timezone.utc) + timedelta(seconds=time_ns // 1_000_000_000)
    return f"the machine's clock says {utc:%Y-%m-%d %H:%M:%S} UTC ({time_ns / 1e9:.0f} s since 1970)"
