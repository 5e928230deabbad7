"""The programs that a setup.cfg declares as `console_scripts`, as scripts."""

from __future__ import annotations

import re
import sys
from configparser import ConfigParser, Error
from pathlib import Path

from tfloom.workspace.program_scripts import first_line

_SCRIPT = re.compile(r"\s*([\w.-]+)\s*=\s*([\w.]+)\s*:\s*(\w+)\s*(\[.*\])?\s*")
_TEXT = """\
{first_line}
import sys

from {module} import {function}

if __name__ == "__main__":
    sys.exit({function}())
"""


def read_console_scripts(path: Path) -> dict[str, str]:
    """Return the text of each program, by name.

    Raises:
        ValueError: the file isn't one of configparser's form, or a line of `console_scripts` isn't
            `name = module:function`; the text names the file.
        OSError: it can't be read.
    """
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
