"""Explain that there is no daemon to stop."""

from __future__ import annotations

from tfloom.cli.daemon.status import add_arguments, main

__all__ = ["add_arguments", "main"]
