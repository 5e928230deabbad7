"""Take `tfloom._native` from $TFLOOM_SANITIZED_NATIVE: on PYTHONPATH, for a Python and all that it starts."""

from __future__ import annotations

import os
import sys
from importlib.machinery import ExtensionFileLoader, ModuleSpec


class _Finder:
    @staticmethod
    def find_spec(name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        if name != "tfloom._native":
            return None
        file = os.environ["TFLOOM_SANITIZED_NATIVE"]
        return ModuleSpec(name, ExtensionFileLoader(name, file), origin=file)


sys.meta_path.insert(0, _Finder)
