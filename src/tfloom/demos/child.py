"""Run a program that ends when its starter does: `python -m tfloom.demos.child MODULE:FUNCTION [ARGS]`.

Its standard input is a pipe that the starter holds and never writes to. However the starter ends, killed included,
the pipe ends with it, on every system.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from importlib import import_module

GRACE_S = 2.0
"""How long the program has to end by itself [s]."""


def _end_with_starter() -> None:
    while os.read(0, 1024):
        pass
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(GRACE_S)
    os._exit(1)


def main() -> int:
    """Run the program that the command line names; return its exit code."""
    threading.Thread(target=_end_with_starter, daemon=True).start()
    module, _, function = sys.argv[1].partition(":")
    return int(getattr(import_module(module), function)(sys.argv[2:]) or 0)


if __name__ == "__main__":
    sys.exit(main())
