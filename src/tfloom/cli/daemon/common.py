"""The common output of all verbs about the daemon."""

from __future__ import annotations


def no_daemon() -> int:
    """Print that no daemon is needed."""
    print(
        "There is no daemon, and none is needed: each command discovers the other programs in a quarter of a second."
    )
    return 0
