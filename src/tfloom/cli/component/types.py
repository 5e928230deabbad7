"""Explain that components need C++."""

from __future__ import annotations

from tfloom.cli.component.standalone import add_arguments, main

__all__ = ["add_arguments", "main"]
