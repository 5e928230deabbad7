"""A daemon thread that waits in C++ while the interpreter ends."""

from __future__ import annotations

import pytest

WAITS_AT_THE_END = """
import threading
from tfloom._native import ReadyQueue
queues = [ReadyQueue() for _ in range(8)]
def wait(queue):
    while True:
        queue.wait(1_000_000)
for queue in queues:
    threading.Thread(target=wait, args=[queue], daemon=True).start()
class AtTheVeryEnd:
    def __del__(self):
        import time
        time.sleep(0.05)
keep = AtTheVeryEnd()
"""


@pytest.mark.parametrize("turn", range(3))
def test_a_waiting_daemon_thread_does_not_abort_the_process(start_program, turn: int) -> None:
    program = start_program("python", "-c", WAITS_AT_THE_END)
    assert program.wait() == 0, program.output
    assert program.output == ""
