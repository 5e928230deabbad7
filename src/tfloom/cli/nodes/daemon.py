"""The daemon that the reference keeps running between commands: there is none here, and none is needed."""

from __future__ import annotations

import argparse
from typing import Any

__all__ = ["add_arguments", "is_daemon_running", "shutdown_daemon", "spawn_daemon"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flag for an answer without the daemon, which has no effect."""
    parser.add_argument("--no-daemon", action="store_true", help="accepted and not used: there is no daemon")


def is_daemon_running(args: Any) -> bool:
    """Return whether a daemon runs: False."""
    return False


def spawn_daemon(args: Any, timeout: float | None = None, debug: bool = False) -> bool:
    """Return whether this call started a daemon: False."""
    return False


def shutdown_daemon(args: Any, timeout: float | None = None) -> bool:
    """Return whether this call ended a daemon: False."""
    return False
