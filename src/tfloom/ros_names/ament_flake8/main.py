"""Check files with flake8."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.workspace.lint import flake8_main as main
from tfloom.workspace.lint import flake8_main_with_errors as main_with_errors

__all__ = [
    "main",
    "main_with_errors",
]
