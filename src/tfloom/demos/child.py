"""Run a program that ends with its parent process: `python -m tfloom.demos.child MODULE:FUNCTION [ARGS]`.

In place of a function, it runs a file as Python would: `python -m tfloom.demos.child FILE.py [ARGS]`. ROS's names are
tfloom's there, also where a real ROS is sourced, because such a file is one of tfloom's own examples.

Its standard input is a pipe to which the parent writes nothing. When the parent ends for any reason, even if it is
killed, the pipe is closed, on every system.
"""

from __future__ import annotations

import os
import runpy
import signal
import sys
import threading
import time
from importlib import import_module
from pathlib import Path

import tfloom

GRACE_S = 2.0
"""Time in which the program must end after the parent's end [s]."""


def _end_with_starter() -> None:
    while os.read(0, 1024):
        pass
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(GRACE_S)
    os._exit(1)


def main() -> int:
    """Run the program in the command line; return its exit code."""
    threading.Thread(target=_end_with_starter, daemon=True).start()
    if sys.argv[1].endswith(".py"):
        _run_file(Path(sys.argv[1]))
        return 0
    module, _, function = sys.argv[1].partition(":")
    return int(getattr(import_module(module), function)(sys.argv[2:]) or 0)


def _run_file(path: Path) -> None:
    """Run a file as the main program; its SystemExit is the interpreter's affair."""
    del sys.argv[0]
    sys.path[:0] = [str(path.parent), str(Path(tfloom.__file__).parent / "ros_names")]
    runpy.run_path(str(path), run_name="__main__")


if __name__ == "__main__":
    sys.exit(main())
