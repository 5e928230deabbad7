"""Ctrl-C while a program that `ros2 launch` has started still imports: no traceback of these imports.

`tfloom.pth` calls `install` where LAUNCHED is set. The launch sends SIGINT to a program that has no handler yet, whose
traceback would show a line of some library that happened to be imported at that moment.
"""

from __future__ import annotations

import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import TracebackType

__all__ = ["LAUNCHED", "install"]

LAUNCHED = "TFLOOM_LAUNCHED"
"""Environment variable of the processes of a launch; CMakeLists.txt has it, too."""
_IMPORTS = "<frozen importlib"
"""Begin of the file names of Python's own functions that import, as frames have them."""


def install() -> None:
    """Let `sys.excepthook` print nothing of an interrupt that was raised within an import."""
    former = sys.excepthook

    def hook(kind: type[BaseException], error: BaseException, traceback: TracebackType | None) -> None:
        if not _is_interrupted_import(error):
            former(kind, error, traceback)

    sys.excepthook = hook


def _is_interrupted_import(error: BaseException | None) -> bool:
    """Return whether an error is, or follows from, a KeyboardInterrupt within an import.

    Some modules catch one while they are imported, and raise an ImportError in its place.
    """
    seen: set[int] = set()
    while error is not None and id(error) not in seen:
        seen.add(id(error))
        if isinstance(error, KeyboardInterrupt) and _is_within_import(error.__traceback__):
            return True
        error = error.__cause__ or error.__context__
    return False


def _is_within_import(traceback: TracebackType | None) -> bool:
    """Return whether a traceback leads through an import: through the code of a module that is not the program.

    Python leaves out its own functions that import, unless the interrupt came in one of them. Where it came between
    two of them, nothing but the import statement is left.
    """
    while traceback is not None:
        frame = traceback.tb_frame
        is_module = frame.f_code.co_name == "<module>" and frame.f_globals.get("__name__") != "__main__"
        if is_module or frame.f_code.co_filename.startswith(_IMPORTS) or _imports_at(traceback):
            return True
        traceback = traceback.tb_next
    return False


def _imports_at(traceback: TracebackType) -> bool:
    """Return whether the frame of a traceback executes an import statement."""
    from opcode import opname

    return opname[traceback.tb_frame.f_code.co_code[traceback.tb_lasti]] == "IMPORT_NAME"
