"""Scripts that start tfloom's own programs: each has a path, as the programs of a workspace do."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

from tfloom.common.files import write_file

__all__ = ["first_line", "write_script"]

_SHEBANG_LIMIT = 127
"""The longest first line that all kernels read [bytes]."""


def write_script(folder: Path, package: str, program: str, target: str) -> Path:
    """Write a script that runs one of tfloom's programs by the Python of this process, unless it is there.

    Args:
        folder: Where `lib/<package>/<program>` is written.
        package: Package of the program.
        program: Name of the program.
        target: `module:function` of the program.

    Returns:
        The path of the script.
    """
    path = folder / "lib" / package / program
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        write_file(path, _script(program, target))
        path.chmod(0o755)
    return path


def _script(program: str, target: str) -> str:
    return (
        f"{first_line(Path(sys.executable))}\n"
        "import sys\n\n"
        "from tfloom.cli.run import run_here\n\n"
        f"sys.exit(run_here({target!r}, {program!r}, sys.argv[1:]))\n"
    )


def first_line(python: Path) -> str:
    """Return the lines that start Python: by a shell if the kernel can't, because of a space or of the length."""
    direct = f"#!{python}"
    if " " not in direct and len(direct.encode()) <= _SHEBANG_LIMIT:
        return direct
    # The shell runs the second line; for Python, lines two and three are a text.
    return f"#!/bin/sh\n'''exec' {shlex.quote(str(python))} \"$0\" \"$@\"\n' '''"
