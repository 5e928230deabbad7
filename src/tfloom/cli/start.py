# PYTHON_ARGCOMPLETE_OK
"""The entry point of the command `tfloom`, which imports almost nothing."""

from __future__ import annotations

from tfloom.cli.quiet_imports import QuietImports

__all__ = ["main"]


def main() -> int:
    """Run the command line of sys.argv and return its exit code."""
    with QuietImports():
        from tfloom.cli.main import main as run_command_line
    return run_command_line()
