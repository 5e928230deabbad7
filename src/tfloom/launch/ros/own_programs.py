"""Scripts that start tfloom's own programs: each has a path, as the programs of a workspace do."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.ros.temporary_files import folder_of
from tfloom.whole_files import write_file

__all__ = ["script_for"]

_SHEBANG_LIMIT = 127
"""The longest first line that all kernels read [bytes]."""


def script_for(context: LaunchContext, package: str, program: str, target: str) -> str:
    """Return the path of a script that runs one of tfloom's programs by the Python of this process.

    Args:
        context: The launch, whose temporary folder holds the script.
        package: Package of the program, for the path.
        program: Name of the program, which becomes the file's.
        target: `module:function` of the program.
    """
    path = folder_of(context) / "lib" / package / program
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        write_file(path, _script(program, target))
        path.chmod(0o755)
    return str(path)


def _script(program: str, target: str) -> str:
    return (
        f"{_first_line(Path(sys.executable))}\n"
        "import sys\n\n"
        "from tfloom.cli.run import run_here\n\n"
        f"sys.exit(run_here({target!r}, {program!r}, sys.argv[1:]))\n"
    )


def _first_line(python: Path) -> str:
    """Return the lines that start Python: by a shell if the kernel can't, because of a space or of the length."""
    direct = f"#!{python}"
    if " " not in direct and len(direct.encode()) <= _SHEBANG_LIMIT:
        return direct
    # The shell runs the second line; for Python, lines two and three are a text.
    return f"#!/bin/sh\n'''exec' {shlex.quote(str(python))} \"$0\" \"$@\"\n' '''"
