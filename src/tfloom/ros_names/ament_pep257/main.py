"""Check docstrings with pydocstyle."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.workspace.lint import pep257_main as main

__all__ = [
    "main",
]
