"""Threads of C++ and of Python that meet at the GIL: when an object is freed, and when the interpreter ends."""

from __future__ import annotations

import os

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


@pytest.mark.parametrize("turn", range(2))
def test_a_waiting_daemon_thread_does_not_abort_the_process(start_program, turn: int) -> None:
    program = start_program("python", "-c", WAITS_AT_THE_END)
    assert program.wait() == 0, program.output
    assert program.output == ""


FORKS = (
    WAITS_AT_THE_END.partition("class")[0]
    + """
import os, sys, time
time.sleep(0.1)  # so that some of the threads wait for the GIL
for _ in range(8):
    child = os.fork()
    if child == 0:
        sys.exit(0)
    assert os.waitpid(child, 0)[1] == 0
"""
)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
def test_a_fork_ends_without_waiting_for_threads_that_it_has_not(start_program) -> None:
    program = start_program("python", "-W", "ignore", "-c", FORKS)
    assert program.wait() == 0, program.output


WITH_A_FEEDER = """
import faulthandler, os, sys, threading, time
faulthandler.dump_traceback_later(20, exit=True)
from tfloom._native import DdsParticipant, DdsReader, DdsWriter
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.cyclone.config import configuration
from tfloom.rmw.cyclone.library import find_library
from tfloom.rmw.qos import DurabilityPolicy, QoS
from tfloom.rosidl.cdr import encode
from tfloom.tf2.buffer import Buffer

class Wire:
    def __init__(self):
        self.participant = DdsParticipant(find_library(), int(os.environ["ROS_DOMAIN_ID"]), configuration(), b"")
        names = "rt/tf", "tf2_msgs::msg::dds_::TFMessage_"
        self.writer = DdsWriter(self.participant, *names, QoS(depth=100).resolved(), b"")
        self.reader = DdsReader(self.participant, *names, QoS(depth=100).resolved(), b"")
        self.buffer = Buffer()
        self.reader.feed(self.buffer.tf_sink("wire", static=False))
        while not self.writer.matched_count():
            time.sleep(0.001)

    def send(self, *names):
        transforms = []
        for frame_id, child_frame_id in names:
            transform = TransformStamped(child_frame_id=child_frame_id)
            transform.header.frame_id = frame_id
            transform.transform.rotation.w = 1.0
            transforms.append(transform)
        self.writer.write(encode(TFMessage(transforms=transforms)))

wire = Wire()
entered = threading.Event()
"""

FREED_DURING_A_CALLBACK = """
def log(severity, text):
    entered.set()
    time.sleep(0.2)  # the callback returns, for which it needs the GIL, while the participant is being freed
    print("logged", flush=True)

wire.buffer.set_log_callback(log)
wire.send(("a", ""))
assert entered.wait(10)
del wire
print("freed")
"""

FREED_BY_A_CALLBACK = """
def log(severity, text):
    globals().pop("wire")
    print("freed", flush=True)
    entered.set()

wire.buffer.set_log_callback(log)
wire.send(("a", ""))
assert entered.wait(10)
"""

ENDS_DURING_CALLBACKS = """
count = 2000
for i in range(count):
    wire.buffer.add_request("a", f"b{i}", 0, lambda handle, is_available: entered.set() or sum(range(1000)))
wire.send(*(("a", f"b{i}") for i in range(count)))
assert entered.wait(10)
"""


def test_a_participant_is_freed_while_a_callback_runs(domain_id: int, start_program) -> None:
    program = start_program("python", "-c", WITH_A_FEEDER + FREED_DURING_A_CALLBACK)
    assert program.wait() == 0, program.output
    assert program.lines == ["logged", "freed"]


def test_a_participant_is_freed_by_a_callback(domain_id: int, start_program) -> None:
    program = start_program("python", "-c", WITH_A_FEEDER + FREED_BY_A_CALLBACK)
    assert program.wait() == 0, program.output
    assert program.lines == ["freed"]


@pytest.mark.parametrize("turn", range(2))
def test_the_interpreter_ends_while_callbacks_run(domain_id: int, start_program, turn: int) -> None:
    program = start_program("python", "-c", WITH_A_FEEDER + ENDS_DURING_CALLBACKS)
    assert program.wait() == 0, program.output
    assert program.output == ""
