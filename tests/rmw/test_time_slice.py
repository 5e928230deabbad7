"""The library's threads that deliver samples are picked by the scheduler as soon as they wake."""

from __future__ import annotations

import ctypes
import platform
import struct
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tfloom._native import ReadyQueue
from tfloom.rmw.base import NodeName, Participant, Topic
from tfloom.rmw.qos import DurabilityPolicy, QoS

SCHED_GETATTR = {"x86_64": 315, "aarch64": 275}
"""The system call's number."""
ATTRIBUTES = struct.Struct("<IIQiIQQQ")
"""Size, policy, flags, nice value, priority, runtime, deadline and period, as in sched_setattr(2)."""
SLICE_NS = 100_000
DATA = b"\0\1\0\0\6\0\0\0hello\0\0\0"

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="slices of threads are Linux's"),
    pytest.mark.skipif(
        platform.machine() not in SCHED_GETATTR, reason="the system call's number is unknown here"
    ),
    pytest.mark.skipif(
        tuple(int(part) for part in platform.release().partition("-")[0].split(".")[:2] if part.isdigit())
        < (6, 12),
        reason="Linux has slices of threads since 6.12",
    ),
]


def slice_ns(thread_id: str) -> int:
    """Return the slice of a thread of this process [ns]; 0 if the thread has ended."""
    buffer = ctypes.create_string_buffer(ATTRIBUTES.size)
    number = SCHED_GETATTR[platform.machine()]
    if ctypes.CDLL(None).syscall(number, int(thread_id), buffer, ATTRIBUTES.size, 0) != 0:
        return 0
    return int(ATTRIBUTES.unpack(buffer.raw)[5])


def threads() -> set[str]:
    return {path.name for path in Path("/proc/self/task").iterdir()}


def test_a_thread_that_receives_has_a_short_slice(
    participant: Participant, start_peer: Callable[..., Any], node: NodeName, topic: Topic
) -> None:
    qos = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=1)
    reader, queue = participant.create_reader(node, topic, qos), ReadyQueue()
    reader.notify(queue, 1)
    peer = start_peer()
    end, _ = peer("writer", topic, qos)
    peer("write", end, DATA.hex())
    assert queue.wait(20_000_000_000) == [1]
    names = {
        Path(f"/proc/self/task/{thread}/comm").read_text().strip()
        for thread in threads()
        if slice_ns(thread) == SLICE_NS
    }
    assert names
    assert all(name.startswith(("recv", "dq.")) for name in names), names


def test_a_thread_of_the_program_keeps_its_slice(
    participant: Participant, node: NodeName, topic: Topic
) -> None:
    """What it writes, it delivers itself to the readers of its process."""
    reader, queue = participant.create_reader(node, topic, QoS()), ReadyQueue()
    reader.notify(queue, 1)
    writer = participant.create_writer(node, topic, QoS())
    found: list[tuple[int, int]] = []

    def write() -> None:
        this = str(threading.get_native_id())
        before = slice_ns(this)
        writer.write(DATA)
        found.append((before, slice_ns(this)))

    thread = threading.Thread(target=write)
    thread.start()
    thread.join(10)
    assert queue.wait(20_000_000_000) == [1]
    ((before, after),) = found
    assert before == after > SLICE_NS
