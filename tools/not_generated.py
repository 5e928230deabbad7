"""Say what to do where a program imports what is not generated yet: `tfloom.pth` of an editable install runs this file.

It does so where the façades are missing, as after a pull, so that a complete checkout has no cost.
The files' folders may still be there, with compiled files that Python would take for packages.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path

ROOT = Path(__file__).parents[1]
GENERATED = re.compile(r"tfloom(_interfaces)?\.(interfaces\.\w+|ros_imports\.homes)")
"""The generated modules of import packages; façades have the names of `tools/facades/names.yaml` and of definitions."""


class Finder:
    """The finder of modules that are to be generated, before Python's own."""

    def __init__(self) -> None:
        table = (ROOT / "tools" / "facades" / "names.yaml").read_text("utf-8")
        folders = ROOT.glob("**/src/*/**/definitions/*/")
        self._facades = {*re.findall(r"^(\w+):", table, re.MULTILINE), *(path.name for path in folders)}

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, _target: object = None
    ) -> ModuleSpec | None:
        """Return the spec of such a module, whose import raises the error; None for others, and where it is there."""
        if name not in self._facades and not GENERATED.fullmatch(name):
            return None
        found = PathFinder.find_spec(name, path)
        if found is not None and found.origin is not None:
            return None
        from tfloom.ros_imports import absent as absent_modules

        absent_modules.INSTEAD[name] = f"it is generated, and not there yet: run `make setup` in {ROOT}"
        return absent_modules.spec_of(name)


sys.meta_path.insert(0, Finder())
