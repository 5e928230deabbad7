"""The common output of all verbs about the daemon."""

from __future__ import annotations


def no_daemon() -> int:
    """Print that none is needed."""
    print(
        "There is no daemon, and none is needed: each command finds the others by itself, in a quarter of a second."
    )
    return 0
