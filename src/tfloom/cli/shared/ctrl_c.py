"""The wait of a verb that has threads for its work, until Ctrl-C."""

from __future__ import annotations

import time
from typing import NoReturn

LOOK_S = 0.25
"""How late Ctrl-C may be noticed [s]."""


def wait_for_ctrl_c() -> NoReturn:
    """Wait on the main thread until the handler of a signal raises.

    Raises:
        KeyboardInterrupt: Ctrl-C.
    """
    while True:
        # Python runs handlers between two steps of the main thread. A wait without an end would miss a signal that
        # comes just before it, or on another thread: only one that comes within it, on this thread, ends it.
        time.sleep(LOOK_S)
