"""Scripts that start programs: tfloom's own, and those that a setup.cfg declares as `console_scripts`.

Each of tfloom's programs has a path, as the programs of a workspace do.
"""

from __future__ import annotations

import re
import shlex
import sys
from pathlib import Path

from tfloom.common.files import write_file

__all__ = ["first_line", "read_console_scripts", "write_script"]

_SHEBANG_LIMIT = 127
"""The longest first line that all kernels read [bytes]."""
_SCRIPT = re.compile(r"\s*([\w.-]+)\s*=\s*([\w.]+)\s*:\s*(\w+)\s*(\[.*\])?\s*")
_TEXT = """\
{first_line}
import sys

from {module} import {function}

if __name__ == "__main__":
    sys.exit({function}())
"""


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


def read_console_scripts(path: Path) -> dict[str, str]:
    """Return the text of each program, by name.

    Raises:
        ValueError: the file isn't one of configparser's form, or a line of `console_scripts` isn't
            `name = module:function`; the text names the file.
        OSError: it can't be read.
    """
    from configparser import ConfigParser, Error

    parser = ConfigParser(interpolation=None)
    try:
        parser.read_string(path.read_text("utf-8"), str(path))
    except Error as error:
        raise ValueError(f"{path}: {' '.join(str(error).split())}") from None
    lines = parser.get("options.entry_points", "console_scripts", fallback="").splitlines()
    scripts = {}
    for line in filter(str.strip, lines):
        match = _SCRIPT.fullmatch(line)
        if match is None:
            raise ValueError(f"{path}: '{line.strip()}' of console_scripts isn't: name = module:function")
        name, module, function, _ = match.groups()
        scripts[name] = _TEXT.format(
            first_line=first_line(Path(sys.executable)), module=module, function=function
        )
    return scripts
