"""Files of definitions, programs that use them, and names as ROS makes them."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import textwrap
from collections.abc import Mapping
from pathlib import Path

from tests.conftest import run_to_end


def write_files(folder: Path, files: Mapping[str, str | bytes]) -> Path:
    """Write files by their paths in a folder, and return the folder."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return folder


def run_python(code: str, cwd: Path | None = None, **environment: object) -> subprocess.CompletedProcess[str]:
    """Run code in a new process, with these variables beside those of this one."""
    variables = os.environ | {name: str(value) for name, value in environment.items()}
    return run_to_end([sys.executable, "-c", textwrap.dedent(code)], cwd=cwd, env=variables)


def snake(name: str) -> str:
    """Return a class's name as ROS has it in the names of modules."""
    words = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", words).lower()
