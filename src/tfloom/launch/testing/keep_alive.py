"""A process that runs until the launch ends."""

from __future__ import annotations

import sys

from tfloom.launch.actions.execute_process import ExecuteProcess

__all__ = ["KeepAliveProc"]

_PROGRAM = """\
import signal, sys, time
signal.signal(signal.SIGINT, lambda *_: sys.exit(0))
signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
if hasattr(signal, "pthread_sigmask"):
    signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT, signal.SIGTERM])
while True:
    time.sleep(3600)
"""


class _KeepAlive(ExecuteProcess):
    """Runs the program, which gets a signal that is sent before it has its handlers once it has them."""

    _blocks_signals = True


def KeepAliveProc() -> ExecuteProcess:
    """Return the action of a process that exits with 0 when the launch shuts down.

    A launch ends with its last process, and fails tests that still run. Where all processes under test end by
    themselves, this one keeps the launch going.
    """
    return _KeepAlive(cmd=[sys.executable, "-S", "-c", _PROGRAM], name="keep_alive")
