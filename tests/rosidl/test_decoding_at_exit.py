"""Programs that end while a daemon thread decodes a message."""

from __future__ import annotations

import sys

import pytest
from tests.conftest import run_to_end

PROGRAM = """
import sys, threading, time
from tfloom.interfaces.unique_identifier_msgs.msg import UUID
from tfloom.rosidl import cdr

assert "numpy" not in sys.modules
importing = threading.Event()

class SlowFinder:
    @staticmethod
    def find_spec(name, path=None, target=None):
        if name == "numpy":
            importing.set()
            end = time.monotonic() + 0.3
            while time.monotonic() < end:
                time.sleep(0)  # gives up the GIL and acquires it again, as an import that reads files

sys.meta_path.insert(0, SlowFinder)
data = bytes([0, 1, 0, 0]) + bytes(16)

def decode():
    while True:
        cdr.decode(UUID, data)

threading.Thread(target=decode, daemon=True).start()
{moment}
"""


@pytest.mark.parametrize("moment", ["importing.wait(10)", "importing.wait(10); time.sleep(0.4)"])
def test_program_that_ends_while_a_thread_decodes_ends_well(moment: str) -> None:
    # A thread inside the decoder imports numpy for the first array. Python would end it at its next line, and unwind
    # the native frames with it, which ends the process by a signal.
    for _ in range(2):
        command = [sys.executable, "-c", PROGRAM.format(moment=moment)]
        ended = run_to_end(command)
        assert (ended.returncode, ended.stderr) == (0, "")
