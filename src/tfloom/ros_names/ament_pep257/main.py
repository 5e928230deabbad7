"""Check docstrings with pydocstyle."""

from tfloom.workspace.lint import pep257_main as main

__all__ = ["main"]
