"""Programs that a launch runs by name: those that PATH leads to, and those of the environment that launches."""

from __future__ import annotations

import sys
from pathlib import Path

from tfloom.launch.core.launch_context import LaunchContext

__all__ = ["command_of", "find_program"]


def find_program(context: LaunchContext, name: str) -> str | None:
    """Return the path of an executable, or None.

    The folders of PATH come first, then that of the programs of this Python, because an environment that is not
    activated is not on PATH.
    """
    import shutil

    program = shutil.which(name, path=context.environment.get("PATH"))
    return program or shutil.which(name, path=str(_scripts_folder()))


def command_of(context: LaunchContext, name: str) -> list[str]:
    """Return the beginning of the command line that runs a program: its path, its name if it isn't found.

    `ros2` and `xacro` are run by tfloom itself, unless PATH leads to others than those of this Python.
    """
    here = [sys.executable, "-m", "tfloom.cli"]
    own = {"ros2": here, "xacro": [*here, "run", "xacro", "xacro"]}.get(name)
    path = find_program(context, name)
    if own is not None and (path is None or Path(path).parent == _scripts_folder()):
        return own
    return [path or name]


def _scripts_folder() -> Path:
    import sysconfig

    return Path(sysconfig.get_path("scripts"))
