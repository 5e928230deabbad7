"""The extension's type stub in the place of the extension: API pages are then built without a compiler.

The stub has the signatures and docstrings of the compiled classes and functions, which is all that autodoc reads.
"""

from __future__ import annotations
import __future__

import importlib.util
import sys
from importlib.machinery import ModuleSpec, SourceFileLoader
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import CodeType, ModuleType

SOURCES = Path(__file__).parents[1] / "src"
NATIVE = "tfloom._native"
STUB = SOURCES / "tfloom" / "_native.pyi"


def use_if_not_compiled() -> bool:
    """Let `import tfloom._native` load the stub where the extension isn't installed; return whether that is so."""
    if importlib.util.find_spec("tfloom") is None:
        sys.path.insert(0, str(SOURCES))
    if importlib.util.find_spec(NATIVE) is not None:
        return False
    sys.meta_path.append(_Finder())
    return True


class _Finder:
    def find_spec(
        self, fullname: str, _path: Sequence[str] | None = None, _target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if fullname != NATIVE:
            return None
        return importlib.util.spec_from_file_location(fullname, STUB, loader=_Loader(fullname, str(STUB)))


class _Loader(SourceFileLoader):
    def source_to_code(self, data: bytes, path: str, *_: object, **__: object) -> CodeType:  # type: ignore[override]
        # A stub names classes before it defines them, so its annotations must not be evaluated.
        return compile(data, path, "exec", flags=__future__.annotations.compiler_flag, dont_inherit=True)
