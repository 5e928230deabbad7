"""The wait for Ctrl-C notices a signal that does not end a call of the main thread."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable

import pytest
from tests.conftest import Program

# A signal that comes just before the wait has the same effect as one on another thread: Python notes it, and the wait
# of the main thread goes on.
ON_ANOTHER_THREAD = """
import signal, threading
from tfloom.cli.shared.errors import wait_for_ctrl_c
threading.Thread(target=threading.Event().wait, daemon=True).start()
signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
try:
    print("waiting", flush=True)
    wait_for_ctrl_c()
except KeyboardInterrupt:
    print("ended")
"""


@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="signals don't come on threads there")
def test_a_signal_on_another_thread_ends_the_wait(start_program: Callable[..., Program]) -> None:
    program = start_program(sys.executable, "-c", ON_ANOTHER_THREAD)
    program.wait_for("waiting")
    program.signal(signal.SIGINT)
    assert program.wait() == 0
    assert program.lines == ["waiting", "ended"]
