"""Run a program that ends with its parent process: `python -m tfloom.demos.child MODULE:FUNCTION [ARGS]`.

Its standard input is a pipe to which the parent writes nothing. When the parent ends for any reason, even if it is
killed, the pipe is closed, on every system.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from importlib import import_module

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
    module, _, function = sys.argv[1].partition(":")
    return int(getattr(import_module(module), function)(sys.argv[2:]) or 0)


if __name__ == "__main__":
    sys.exit(main())
