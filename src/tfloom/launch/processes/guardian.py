"""A process that ends a launch's processes when the launch itself was killed: `python -m …guardian ID TIME`.

Its stdin is a pipe, whose other end only the launch holds; the kernel closes it with the launch, however that ended.
"""

from __future__ import annotations

import signal
import sys

STEPS = {"SIGINT": 3.0, "SIGTERM": 2.0}
"""Time that the processes have after each signal [s], before SIGKILL."""


def main(arguments: list[str]) -> int:
    """Read the ids of process groups until the launch has ended, and end what is left of it."""
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    launch_id, since_s = arguments[0], float(arguments[1])
    groups = [int(line) for line in sys.stdin.buffer if line.strip().isdigit()]
    from tfloom.launch.processes import family  # not needed before

    family.end(launch_id, groups, since_s, {signal.Signals[name]: wait_s for name, wait_s in STEPS.items()})
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
