"""Hooks that PyInstaller runs when a program imports tfloom: they name the files that its analysis cannot find.

The entry point `pyinstaller40` of the distribution names this folder. PyInstaller reads the lists of each
`hook-<module>.py` if the program imports that module.
"""

from __future__ import annotations

import os

__all__ = ["hook_dirs"]


def hook_dirs() -> list[str]:
    """Return the folders of the hooks: this one."""
    return [os.path.dirname(__file__)]  # noqa: PTH120  # as every path of PyInstaller, a string
