"""Commands that open tfloom's page in place of RViz's and rqt's windows, unless others of their names are on PATH."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from tfloom.cli.quiet_imports import QuietImports

__all__ = ["joint_state_publisher_gui", "rqt_console", "rqt_graph", "rqt_plot", "rviz2"]

STARTED = "TFLOOM_RVIZ_STARTED"
"""Variable with the name of a command that has started another one in its place, which may start it again."""
OURS = b"tfloom_rviz"
"""What the file of each command has, because it imports this package."""
MAX_FILE_BYTES = 1 << 20
"""How much of a file is searched for it [bytes]: the launchers on Windows have it behind a program."""
NOT_STARTED = 126
"""Exit code, as of shells, where another command is there and can't be started."""


def rviz2() -> int:
    """Start another `rviz2` of PATH, or open the page; return the exit code."""
    return _run("rviz2")


def rqt_graph() -> int:
    """Start another `rqt_graph` of PATH, or open the page at the graph; return the exit code."""
    return _run("rqt_graph")


def rqt_plot() -> int:
    """Start another `rqt_plot` of PATH, or open the page at the plots; return the exit code."""
    return _run("rqt_plot")


def rqt_console() -> int:
    """Start another `rqt_console` of PATH, or open the page at the log; return the exit code."""
    return _run("rqt_console")


def joint_state_publisher_gui() -> int:
    """Start another `joint_state_publisher_gui` of PATH, or open the page with sliders; return the exit code."""
    return _run("joint_state_publisher_gui")


def _run(name: str) -> int:
    with QuietImports():
        # A script that starts this one would be found again.
        other = None if os.environ.get(STARTED) == name else _find_other(name)
        if other is not None:
            return _start(name, other)
        from tfloom.cli.main import main
    sys.argv[1:1] = ["run", name, name]
    return main(prog=name)


def _find_other(name: str) -> str | None:
    """Return the first command of a name on PATH that isn't of this package, as a copy of it in another environment."""
    import shutil

    candidates = (shutil.which(name, path=folder) for folder in os.get_exec_path())
    return next((path for path in candidates if path is not None and not _is_ours(path)), None)


def _is_ours(path: str) -> bool:
    try:
        with Path(path).open("rb") as file:
            return OURS in file.read(MAX_FILE_BYTES)
    except OSError:  # it may be one that can be run and not read
        return False


def _start(name: str, path: str) -> int:
    """Start a command in place of this one, with its arguments; return the exit code."""
    os.environ[STARTED] = name
    command = [path, *sys.argv[1:]]
    try:
        if sys.platform != "win32":
            os.execv(path, command)
        import subprocess

        return subprocess.call(command)
    except OSError as error:
        print(f"{name}: can't start {path}, which is on PATH: {error.strerror or error}", file=sys.stderr)
        return NOT_STARTED
